// The anatomical regions along the depth, for plots and for statements about a region.
#pragma once

#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::report {

/// A region of the passage. It begins and ends where its term and the neighbor's have equal membership.
struct Region {
  std::string id;
  std::string code;   ///< two letters, for narrow plots
  std::string label;  ///< full name
  double from_mm = 0;
  double to_mm = 0;
};

/// The six regions from nasal cavity to stomach. A boundary comes from the terms of `depth` if both neighbors exist
/// (trapezoids or triangles); otherwise it is the default 70, 115, 150, 200 or 440 mm, the midpoints of published
/// landmarks of adults. The first region begins and the last one ends with the universe.
std::vector<Region> depthRegions(const fuzzy::Variable& depth);

/// The region `id` in that list; it must be one of the six.
const Region& regionOf(const std::vector<Region>& regions, std::string_view id);

/// The location of `depth_mm` in words: `laryngopharynx`, or near a boundary `border of laryngopharynx and esophagus`.
std::string whereabouts(const std::vector<Region>& regions, double depth_mm);

}  // namespace tactus::report
