// The regions along the way of the tube, as the depth terms of a model divide it.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// Where one term has the largest membership of all.
struct DepthRegion {
  QString label;
  double from_mm = 0;
  double to_mm = 0;
};

/// The regions of `depth`, from the nostril inwards. Places that belong to no term are in none. The boundaries are
/// exact to a 4000th of the universe.
std::vector<DepthRegion> depthRegions(const fuzzy::Variable& depth);

/// The region that `depth_mm` is in.
std::optional<std::size_t> regionAt(const std::vector<DepthRegion>& regions, double depth_mm);

}  // namespace tactus::workbench
