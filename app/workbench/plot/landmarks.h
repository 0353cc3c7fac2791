// Places of the anatomy along the way of the tube, for display beside a depth axis. The data are in
// data/landmarks.json.
#pragma once

#include <QString>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// Depth from the rim of the nostril of an adult, as typical values; people differ by about 10 %.
struct Landmark {
  QString name;
  double from_mm = 0;
  double to_mm = 0;  ///< equal to from_mm for a point
  QString what;
  QString source;
};

/// The landmarks for the axis of `variable`: those inside its universe where it is the depth in mm, otherwise none.
std::vector<Landmark> landmarksFor(const fuzzy::Variable& variable);

}  // namespace tactus::workbench
