// The terms of the insertion depth from the boundaries of regions along the tube (paper, Section 3.1.3, Fig. 3c).
#pragma once

#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::elicitation {

/// The boundary between a region and the next one.
struct DepthBoundary {
  double depth_mm = 0;         ///< along the path, of the person on the image
  double half_overlap_mm = 0;  ///< the terms cross here and end this far before and behind, >= 0

  bool operator==(const DepthBoundary&) const = default;
};

/// The scale factor of a person as tall as the one on the image; 0.93 fits a small or female adult, 1.05 a large one
/// (facts: 1.3).
inline constexpr double kSameAnatomy = 1;

/// The terms of `depth`, whose ids and labels stay, with trapezoids whose ramps cross at the boundaries, all depths
/// times `scale`. The first and the last term have shoulders at the ends of the universe, which stays. One boundary
/// fewer than terms.
/// Returns an error that names the regions for: another number of boundaries, a scale outside 0.5 to 2, boundaries that
/// do not rise, overlaps that reach into each other, ramps that do not end inside the universe.
base::Result<std::vector<fuzzy::Term>> depthTerms(const fuzzy::Variable& depth,
                                                  std::span<const DepthBoundary> boundaries,
                                                  double scale = kSameAnatomy);

/// The boundaries of `terms`, trapezoids whose neighbors' ramps cross: where they cross, and half of their overlap.
std::vector<DepthBoundary> boundariesOf(std::span<const fuzzy::Term> terms);

}  // namespace tactus::elicitation
