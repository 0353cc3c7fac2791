// Force terms by frequency: the trapezoids closest to the shares of answers.
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
  std::vector<double> shares;  ///< shares of the terms, lowest first; empty without votes
};

struct FrequencyTerms : ForceTerms {
  std::vector<FrequencyStep> steps;  ///< all steps, including those that do not count
  double rms_error = 0;              ///< root mean square of membership - share, over counting answers and terms
};

/// The frequency curve of `output`'s terms (ids and labels from there, lowest first; universe from 0): trapezoids that
/// sum to 1 everywhere, fitted by least squares to the shares. Each answer has the same weight (after Chameau and
/// Santamarina 1987; the paper's vote keeps only the winner of each force).
/// Counting steps, end of the universe and terms above all chosen ones: as in `forceTerms`. Returns an error for no
/// votes, or votes at 0 N only. `steps`: from `vote`, with as many terms as `output`.
base::Result<FrequencyTerms> frequencyTerms(const fuzzy::Variable& output, std::span<const VoteStep> steps,
                                            std::optional<double> end_n = std::nullopt);

}  // namespace tactus::elicitation
