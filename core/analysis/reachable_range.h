// The range of forces that a model gives, as far as looking at many points shows.
#pragma once

#include <stop_token>

#include "core/analysis/lint.h"

namespace tactus::analysis {

/// Looks at every combination of the vertices of all terms and the middles between them, or, where these are more than
/// 20,000, at 20,000 points of a Halton sequence over them, fewer where the model has many rules. Deterministic.
/// It ends soon after `stop` says so, with what it saw until then.
ForceRange reachableRange(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                          const std::stop_token& stop = {});

}  // namespace tactus::analysis
