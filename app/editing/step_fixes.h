// What makes a cliff in the force a slope: the flanks at the step widened.
#pragma once

#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/editing/edit.h"

namespace tactus::editing {

/// Where a step is: between two places of `input`, the other inputs as in `from`.
struct StepBetween {
  std::size_t input = 0;
  std::vector<double> from;
  std::vector<double> to;
};

/// The ways to widen the step of `experts` (indices; all that count for a step of the mean) at `step`, each with the
/// text of its button: `Widen to 5 mm`, and where a step is left then, the smallest of 10, 20 and 40 mm that leaves
/// none. For an input in another unit the widths are as many times `analysis::stepWidth`.
///
/// The flanks of the terms in use that cross the step and are narrower than that become as wide, around their middle;
/// of a wider flank that only begins or ends at the step, the foot moves so far that the terms overlap that wide.
/// Flanks move in the list that an expert reads, the shared one too.
/// The first width is offered whether a smaller step is left or not. It ends soon after `stop` says so.
std::vector<std::pair<std::string, base::Result<Edit>>> widenStep(const fuzzy::ForceModel& model,
                                                                  std::span<const std::size_t> experts, bool of_mean,
                                                                  const StepBetween& step,
                                                                  const std::stop_token& stop = {});

}  // namespace tactus::editing
