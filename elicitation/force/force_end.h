// Which judged forces count for the terms of the force, and where its universe ends.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "elicitation/force/force_voting.h"

namespace tactus::elicitation {

/// The steps that count, and what lies above them. One participant who goes on where all others stopped must not move
/// the terms of everybody: a universe that ends later moves the centroid of the highest term.
/// Example: four participants, votes by all at 0.1 to 0.7 N, by one at 0.8 to 1.5 N: the steps up to 0.7 N count.
struct ForceEnd {
  std::size_t steps = 0;           ///< the first so many steps count
  double last_n = 0;               ///< force of the last of them with votes
  std::optional<double> given_n;   ///< what the universe was asked to end at
  std::string reason;              ///< why the steps end there, to stand behind "the universe ends at 0.7 N:"
  std::vector<std::string> notes;  ///< one sentence each: votes that were left out, no quorum anywhere

  /// The force `count` (from 1) steps above `last_n`: that of the steps that come next, then as far apart as steps
  /// usually are.
  double stepsAbove(std::size_t count) const;

  std::vector<double> later_n;  ///< forces of the steps above `last_n`, ascending
  double width_n = 0;           ///< median distance of neighbouring steps
};

/// The end by the quorum: the last step at which half of the enrolled participants voted (VoteStep::below_quorum).
/// Where no step has that quorum, half of the most votes at a step. With `given_n` (> 0, finite) steps up to that force
/// count too. `steps` come from `vote`. Refused: no votes, or at 0 N alone.
base::Result<ForceEnd> forceEnd(std::span<const VoteStep> steps, std::optional<double> given_n = std::nullopt);

}  // namespace tactus::elicitation
