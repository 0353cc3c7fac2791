// Settings of the paper's figures 9 to 11, for models that have the inputs of the study.
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
};

/// The presets for `model`; none where one of lubrication, neck_flexion and speed is missing. Inputs that a figure
/// varies have no setting (paper, Sec. 4 and captions of Fig. 9 to 11).
std::vector<FigurePreset> figurePresets(const fuzzy::ForceModel& model);

}  // namespace tactus::workbench
