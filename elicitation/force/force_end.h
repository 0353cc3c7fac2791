// The judged forces that count for the force terms, and the end of the force universe.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/study/records.h"
#include "elicitation/force/force_voting.h"

namespace tactus::elicitation {

// Checks that the participants of a force experiment judged the same forces.

/// One sentence for each participant with a step of `series` at another force than most judgements of that step (on a
/// tie the lowest force). The vote counts by force, so such a judgement may be alone.
std::vector<std::string> stepForceNotes(std::span<const study::ForceJudgement> judgements, std::string_view series);

/// The steps that count, and the steps above them. One participant who continues after all others stopped must not move
/// the terms of all experts: a universe that ends later moves the centroid of the highest term.
/// Example: of four participants, all vote at 0.1 to 0.7 N and one at 0.8 to 1.5 N: the steps up to 0.7 N count.
struct ForceEnd {
  std::size_t steps = 0;           ///< number of steps that count, from the first
  double last_n = 0;               ///< force of the last counting step with votes
  std::optional<double> given_n;   ///< end of the universe requested by the caller
  std::string reason;              ///< why the steps end there; text for after "the universe ends at 0.7 N:"
  std::vector<std::string> notes;  ///< one sentence each: omitted votes, no step with a quorum

  /// The force `count` (from 1) steps above `last_n`: first the next steps, then further ones at the
  /// distance `width_n`.
  double stepsAbove(std::size_t count) const;

  std::vector<double> later_n;  ///< forces of the steps above `last_n`, ascending
  double width_n = 0;           ///< median distance of neighboring steps
};

/// The end by quorum: the last step at which half of the enrolled participants voted (VoteStep::below_quorum). If no
/// step has that quorum: half of the largest number of votes at a step. `given_n` (> 0, finite): steps up to that force
/// count too. `steps`: from `vote`. Returns an error for no votes, or votes at 0 N only.
base::Result<ForceEnd> forceEnd(std::span<const VoteStep> steps, std::optional<double> given_n = std::nullopt);

}  // namespace tactus::elicitation
