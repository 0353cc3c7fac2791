// The settings of the paper's figures 9 to 11, for models that have the inputs of the study.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

struct FigurePreset {
  struct Setting {
    std::string input;  ///< id
    double value = 0;   ///< in the unit of the input
  };

  QString figure;  ///< `Fig. 11`
  QString shows;   ///< what the figure shows, in a few words
  std::vector<Setting> settings;
  std::string varied{};          ///< id of the input that differs from curve to curve; empty: none
  std::vector<double> values{};  ///< values of that input, one for each curve of the mean
  std::string map_x{};           ///< ids of the axes of a map or surface; empty: the figure has curves
  std::string map_y{};
};

/// The presets for `model`; none if lubrication, neck_flexion or speed is missing. The settings are the paper's (Sec.
/// 3.4, captions of Fig. 9 to 11). The paper does not give the values of the varied input in Fig. 10; these are the
/// report's (app/report/sections_force.cpp).
std::vector<FigurePreset> figurePresets(const fuzzy::ForceModel& model);

}  // namespace tactus::workbench
