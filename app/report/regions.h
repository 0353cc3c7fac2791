// The anatomical regions along the depth, for marking plots and for statements about a region.
#pragma once

#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::report {

/// A region of the passage; it begins and ends where its term and the neighbour's are equal.
struct Region {
  std::string id;
  std::string code;   ///< two letters, for narrow plots
  std::string label;  ///< for people
  double from_mm = 0;
  double to_mm = 0;
};

/// The six regions from nasal cavity to stomach. Limits come from the terms of `depth` where two neighbours are both
/// there (trapezoids or triangles); where they are not, from the defaults 70, 115, 150, 200 and 440 mm, midpoints of
/// published landmarks of adults. The first begins and the last ends with the universe.
std::vector<Region> depthRegions(const fuzzy::Variable& depth);

/// The region `id` of that list; it must be one of the six.
const Region& regionOf(const std::vector<Region>& regions, std::string_view id);

/// Where `depth_mm` lies, in words: `laryngopharynx`, or near a limit `border of laryngopharynx and esophagus`.
std::string whereabouts(const std::vector<Region>& regions, double depth_mm);

}  // namespace tactus::report
