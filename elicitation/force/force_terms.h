// The force terms from the judged forces (paper, Fig. 3(e)).
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

/// The method for the force terms.
enum class ForceTermsFrom {
  kVote,        ///< from the winner of each force (paper, Section 3.3)
  kFrequency,   ///< from the shares of all answers (force_frequency.h)
  kThresholds,  ///< from the mean of the participants' thresholds (force_thresholds.h)
  kProbit,      ///< from one ordered probit over all answers (force_terms_from.h)
};

/// `vote`, `frequency`, `thresholds`, `probit`: the values of `tactus build --force-terms`.
std::string_view name(ForceTermsFrom from) noexcept;

struct ForceTerms {
  fuzzy::Variable output;                 ///< the variable with its new terms; its universe is [0, ForceEnd]
  std::vector<std::string> interpolated;  ///< ids of terms without answers: placed between their neighbors, or above
  std::vector<std::string> absent;        ///< ids of terms without answers that do not fit into the universe
  std::vector<std::string> notes;         ///< one sentence each: these terms, omitted votes
  std::string end_reason;                 ///< why the universe ends there; text for after a colon
};

/// The terms of `output` (ids and labels from there, lowest first; universe from 0) from the outcome of the vote. The
/// core of a term runs from its first to its last step, ramps join neighboring cores, the outer terms have shoulders.
/// Only the counting steps (force_end.h) shape the terms. The universe ends at the last of them, or at `end_n` (> 0,
/// finite), which cuts the terms and removes those that begin beyond.
/// If no step won k terms in a gap [e, s], they become triangles with peaks e + j(s - e)/(k + 1) and feet on the
/// neighboring peaks. At the low end the outermost is a shoulder. In a gap without width these terms are absent.
/// Above the highest won term, each missing term lies one step above the previous one: participants who answer "beyond
/// what I have felt" there do not use its word, but the form uses all words.
/// Returns an error if no step was decided, or the last one lies at 0 N. `steps`: from `vote`, with as many terms as
/// `output`.
base::Result<ForceTerms> forceTerms(const fuzzy::Variable& output, std::span<const VoteStep> steps,
                                    std::optional<double> end_n = std::nullopt);

/// What the rule of the vote gives against what was said, one sentence each: the forces whose word nobody said, the
/// winners that are not the most frequent word, and by how many newtons the corners move if the most frequent words
/// (the higher of several, never falling) took their place. Nothing where each winner is a most frequent word.
/// Arguments as for `forceTerms`.
std::vector<std::string> unsaidNotes(const fuzzy::Variable& output, std::span<const VoteStep> steps,
                                     std::optional<double> end_n = std::nullopt);

}  // namespace tactus::elicitation
