// The fixes of a step of the force: wider flanks of the terms at the step, which turn it into a slope.
#pragma once

#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/editing/edit.h"

namespace tactus::editing {

/// The place of a step: between two values of `input`, with the other inputs as in `from`.
struct StepBetween {
  std::size_t input = 0;
  std::vector<double> from;
  std::vector<double> to;
};

/// The ways to widen the step of `experts` at `step` (indices; for a step of the mean all experts that count), each
/// with the text of its button. The first is `Widen to 5 mm`; if that leaves a step, the second is the smallest of 10,
/// 20 and 40 mm that leaves none. For other units the widths are the same multiples of `analysis::stepWidth`.
///
/// Used terms whose flank crosses the step and is narrower than that get flanks of that width, around the same middle.
/// For a wider flank that only begins or ends at the step, the foot moves until the terms overlap by that width. Flanks
/// move in the list that an expert uses, also in the shared one. The first width is offered even if it leaves a smaller
/// step. Returns soon after `stop` is requested.
std::vector<std::pair<std::string, base::Result<Edit>>> widenStep(const fuzzy::ForceModel& model,
                                                                  std::span<const std::size_t> experts, bool of_mean,
                                                                  const StepBetween& step,
                                                                  const std::stop_token& stop = {});

}  // namespace tactus::editing
