// Landmarks along the way of the tip, shown beside its axis. They are those of the procedure.
#pragma once

#include <QString>
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
/// (model/shown_procedure.h); otherwise none.
std::vector<Landmark> landmarksFor(const fuzzy::Variable& variable);

}  // namespace tactus::workbench
