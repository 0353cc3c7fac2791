// The fixes of a step of the force: wider flanks of the terms at the step, which turn it into a slope.
#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/editing/edit.h"

namespace tactus::editing {

// Acceptance of coverage holes by a researcher. An acceptance is a hole's name with its boundaries, so it holds for
// these boundaries only:
//   accepted: the hole at depth 125 to 138 mm
//   after an edit moves it to 125 to 140 mm: a new hole, reported by the lint; the acceptance has lapsed

// A lapsed acceptance stays in the model, so that a drag there and back changes nothing. It is removed when the new
// hole is accepted, when a fix closes the hole, or by forgetLapsed.

/// The names of all holes of `model`, of each expert and of the mean, as analysis::describe gives them; each once.
/// Nothing if the search was cut off, because then some holes are unknown.
std::optional<std::vector<std::string>> holeNames(const fuzzy::ForceModel& model);

/// The acceptances without a hole, in the order of the model. Empty if the search for holes was cut off.
std::vector<std::string> lapsedAcceptances(const fuzzy::ForceModel& model);

/// Adds a hole's name to the accepted ones and removes all lapsed acceptances. The force does not change. `name`: as
/// analysis::describe gives it. Refused if it is accepted already.
base::Result<Edit> acceptHole(const fuzzy::ForceModel& model, const std::string& name);

/// Makes the hole a finding again. Refused if it is not accepted.
base::Result<Edit> withdrawAcceptance(const fuzzy::ForceModel& model, const std::string& name);

/// Removes the lapsed acceptances. Refused if there are none.
base::Result<Edit> forgetLapsed(const fuzzy::ForceModel& model);

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
