// How far the force jumps at the boundary of a hole.
#pragma once

#include <optional>
#include <vector>

#include "core/analysis/coverage.h"
#include "core/analysis/force_probe.h"

namespace tactus::analysis {

/// Two neighbouring points, one ulp of one input apart, and the jump of the force between them.
struct BoundaryJump {
  double newtons = 0;
  std::vector<double> outside;  ///< where the expert (or some expert) still fires
  std::vector<double> inside;   ///< in the hole
};

/// The jump from the force beside `hole` to the default force: the largest one over all faces of the hole and at most
/// `samples` settings of the other inputs on each face and as many beside the best of them. With `expert`: a hole of
/// that expert and its own force; without: a hole of all experts and the mean. Nothing where no rule fires beside the
/// hole.
std::optional<BoundaryJump> jumpToDefault(ForceProbe& probe, const Hole& hole, std::optional<std::size_t> expert,
                                          std::size_t samples);

/// The jump of the mean where `expert` starts to abstain, at the faces of its `hole`, while others go on; largest as
/// above. Nothing where no other expert fires inside the hole at the settings looked at.
std::optional<BoundaryJump> jumpOfMean(ForceProbe& probe, const Hole& hole, std::size_t expert, std::size_t samples);

}  // namespace tactus::analysis
