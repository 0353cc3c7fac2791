// Landmarks along the way of the tip, shown beside its axis: those of the procedure, and the punctures of the model.
#pragma once

#include <QString>
#include <span>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// Values are typical; people differ.
struct Landmark {
  QString name;
  double from_mm = 0;
  double to_mm = 0;  ///< equal to from_mm for a point
  QString what;
  QString source;
};

/// The landmarks inside the universe of `variable` if it is the way of the procedure on the screen
/// (model/shown_procedure.h), and those of `events` if it is the way of their model; in the order of the way.
std::vector<Landmark> landmarksFor(const fuzzy::Variable& variable, std::span<const fuzzy::TubeEvent> events = {});

}  // namespace tactus::workbench
