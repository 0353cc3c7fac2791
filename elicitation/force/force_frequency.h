// The other way from judgements to the terms of the force: shares of answers and the trapezoids closest to them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/force/force_terms.h"
#include "elicitation/force/force_voting.h"

namespace tactus::elicitation {

/// The answers at one force.
struct FrequencyStep {
  double force_n = 0;
  int votes = 0;
  std::vector<double> shares;  ///< of the terms, lowest first; empty where nobody voted
};

struct FrequencyTerms : ForceTerms {
  std::vector<FrequencyStep> steps;  ///< all steps, those that do not count too
  double rms_error = 0;              ///< root mean square of membership - share, over answers that count and terms
};

/// The frequency curve of `output`'s terms (ids and labels from there, lowest first; universe from 0): trapezoids that
/// sum to 1 everywhere, least squares against the shares, each answer weighing the same (after Chameau and Santamarina
/// 1987; the paper's vote keeps only the winner of each force). Which steps count, where the universe ends and what
/// becomes of terms above all that were chosen: as for `forceTerms`. Refused: nobody voted, or at 0 N alone. `steps`
/// come from `vote` with as many terms as `output`.
base::Result<FrequencyTerms> frequencyTerms(const fuzzy::Variable& output, std::span<const VoteStep> steps,
                                            std::optional<double> end_n = std::nullopt);

}  // namespace tactus::elicitation
