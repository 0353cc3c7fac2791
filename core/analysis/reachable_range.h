// The range of forces of a model, found by sampling.
#pragma once

#include <stop_token>

#include "core/analysis/lint.h"

namespace tactus::analysis {

/// Evaluates every combination of the vertices of all terms and their midpoints. If there are more than 20,000, it
/// evaluates 20,000 points of a Halton sequence over them, fewer if the model has many rules. Deterministic. Ends soon
/// after `stop` is requested and returns the range found so far.
ForceRange reachableRange(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                          const std::stop_token& stop = {});

}  // namespace tactus::analysis
