// The jump of the force at the boundary of a hole.
#pragma once

#include <optional>
#include <vector>

#include "core/analysis/coverage.h"
#include "core/analysis/force_probe.h"

namespace tactus::analysis {

/// Two neighboring points, one ulp of one input apart, and the jump of the force between them.
struct BoundaryJump {
  double newtons = 0;
  std::vector<double> outside;  ///< the point at which the expert (or some expert) still fires
  std::vector<double> inside;   ///< the point in the hole
};

/// The largest jump between the force beside `hole` and the default force. Searches all faces of the hole. On each face
/// it tries at most `samples` settings of the other inputs, and as many near the best of them.
/// `expert`: its own hole and its own force; empty: a hole of all experts and the mean.
/// Nothing if no rule fires beside the hole.
std::optional<BoundaryJump> jumpToDefault(ForceProbe& probe, const Hole& hole, std::optional<std::size_t> expert,
                                          std::size_t samples);

/// The largest jump of the mean at the faces of `hole`, where `expert` starts to abstain and other experts continue.
/// The search is that of jumpToDefault. Nothing if no other expert fires inside the hole at the tried settings.
std::optional<BoundaryJump> jumpOfMean(ForceProbe& probe, const Hole& hole, std::size_t expert, std::size_t samples);

}  // namespace tactus::analysis
