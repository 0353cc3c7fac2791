// From the classified forces to the terms of the force (paper, Fig. 3(e)).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/force/force_voting.h"

namespace tactus::elicitation {

/// Which way leads from the judgements to the terms of the force.
enum class ForceTermsFrom {
  kVote,        ///< the winner of each force (paper, Section 3.3)
  kFrequency,   ///< the shares of all answers (force_frequency.h)
  kThresholds,  ///< the mean of the participants' thresholds (force_thresholds.h)
};

/// `vote`, `frequency`, `thresholds`: the words of `tactus build --force-terms`.
std::string_view name(ForceTermsFrom from) noexcept;

struct ForceTerms {
  fuzzy::Variable output;                 ///< the variable with its new terms; its universe is [0, ForceEnd]
  std::vector<std::string> interpolated;  ///< ids of terms that nobody gave: placed between their neighbours, or above
  std::vector<std::string> absent;        ///< ids of terms that nobody gave and that have no room
  std::vector<std::string> notes;         ///< one sentence each: these terms, votes that were left out
  std::string end_reason;                 ///< why the universe ends where it does, to stand behind a colon
};

/// The terms of `output` (ids and labels from there, lowest first; universe from 0) from the outcome of the vote. The
/// core of a term runs from its first to its last step, ramps join neighbouring cores, the ends are shoulders.
/// Only the steps that count (force_end.h) shape the terms, and the universe ends at the last of them, or at
/// `end_n` (> 0, finite), which cuts the terms off and removes those that begin there.
/// k terms that no step won, in a gap [e, s], become triangles with peaks e + j(s - e)/(k + 1) and feet on the
/// neighbouring peaks; at the low end the outermost is a shoulder, and in a gap without width there is no such term.
/// Above the highest term that was won, each missing term lies one step above the one before it: participants who say
/// "beyond what I have felt" there know no word for it, but the form asks with all words.
/// Refused: no step was decided, or the last one lies at 0 N. `steps` come from `vote` with as many terms as `output`.
base::Result<ForceTerms> forceTerms(const fuzzy::Variable& output, std::span<const VoteStep> steps,
                                    std::optional<double> end_n = std::nullopt);

}  // namespace tactus::elicitation
