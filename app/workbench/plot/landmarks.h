// Anatomical landmarks along the path of the tube, shown beside a depth axis. The data are in data/landmarks.json.
#pragma once

#include <QString>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// Depth from the rim of an adult's nostril. Values are typical; people differ by about 10 %.
struct Landmark {
  QString name;
  double from_mm = 0;
  double to_mm = 0;  ///< equal to from_mm for a point
  QString what;
  QString source;
};

/// The landmarks inside the universe of `variable` if it is the depth in mm; otherwise none.
std::vector<Landmark> landmarksFor(const fuzzy::Variable& variable);

}  // namespace tactus::workbench
