// The anatomical regions along the path of the tube, as the depth terms of a model divide it.
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// A range in which one term has the largest membership.
struct DepthRegion {
  QString label;
  double from_mm = 0;
  double to_mm = 0;
  std::string id = {};  ///< of the term
};

/// The regions of `depth`, from the nostril inward. Places without a term belong to no region. The boundaries are exact
/// to 1/4000 of the universe.
std::vector<DepthRegion> depthRegions(const fuzzy::Variable& depth);

/// The region of `depth_mm`; nothing if it is in none.
std::optional<std::size_t> regionAt(const std::vector<DepthRegion>& regions, double depth_mm);

}  // namespace tactus::workbench
