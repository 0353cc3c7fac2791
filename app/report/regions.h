// The regions along the way, for plots and for statements about a region.
#pragma once

#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"
#include "core/procedure/procedure.h"

namespace tactus::report {

/// A region of the passage. It begins and ends where its term and the neighbor's have equal membership.
struct Region {
  std::string id;
  std::string code;   ///< two letters, for narrow plots
  std::string label;  ///< full name
  double from_mm = 0;
  double to_mm = 0;
};

/// The regions of the first list of terms of `procedure` that has every term of `way`, an input of a model. A boundary
/// comes from the terms of `way` if both neighbors exist there (trapezoids or triangles), otherwise from the list. The
/// first region begins and the last one ends with the universe.
std::vector<Region> wayRegions(const procedure::Procedure& procedure, const fuzzy::Variable& way);

/// The region `id` in that list; it must be there.
const Region& regionOf(const std::vector<Region>& regions, std::string_view id);

/// The location of `depth_mm` in words: `laryngopharynx`, or near a boundary `border of laryngopharynx and esophagus`.
std::string whereabouts(const std::vector<Region>& regions, double depth_mm);

}  // namespace tactus::report
