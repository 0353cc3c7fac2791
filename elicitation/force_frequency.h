// The other way from judgements to the terms of the force: shares of answers and the trapezoids closest to them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/force_voting.h"

namespace tactus::elicitation {

/// The answers at one force.
struct FrequencyStep {
  double force_n = 0;
  int votes = 0;
  std::vector<double> shares;  ///< of the terms, lowest first; empty where nobody voted
};

struct FrequencyTerms {
  std::vector<FrequencyStep> steps;
  fuzzy::Variable output;  ///< the variable with its new terms; the universe ends at the last voted force
  std::vector<std::string> interpolated;  ///< ids of terms that nobody chose, placed between their neighbours
  std::vector<std::string> absent;        ///< ids of terms that have no room
  double rms_error = 0;                   ///< root mean square of membership - share, over answers and terms
};

/// The frequency curve of `output`'s terms (ids and labels from there, lowest first; universe from 0): trapezoids that
/// sum to 1 everywhere, least squares against the shares, each answer weighing the same (after Chameau and Santamarina
/// 1987; the paper's vote keeps only the winner of each force). Refused: nobody voted, or at 0 N alone. `counts` in
/// ascending force with as many terms as `output`.
base::Result<FrequencyTerms> frequencyTerms(const fuzzy::Variable& output, std::span<const VoteCounts> counts);

}  // namespace tactus::elicitation
