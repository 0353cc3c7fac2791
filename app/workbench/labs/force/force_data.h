// What the force lab shows of the vote: Table 2 with its winners, and the force terms by each method.
#pragma once

#include <QString>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/force/force_terms.h"
#include "elicitation/force/force_voting.h"

namespace tactus::workbench {

inline constexpr std::array kForceMethods = {
    elicitation::ForceTermsFrom::kVote, elicitation::ForceTermsFrom::kFrequency,
    elicitation::ForceTermsFrom::kThresholds, elicitation::ForceTermsFrom::kProbit};

/// One way from the judgements to the terms.
struct ForceMethod {
  elicitation::ForceTermsFrom from = elicitation::ForceTermsFrom::kVote;
  std::optional<elicitation::ForceTerms> terms;
  QString refusal;  ///< why there are no terms; empty if there are
};

struct ForceVotes {
  fuzzy::Variable words;  ///< the force with all its words, in order; its terms are the defaults
  std::vector<elicitation::VoteStep> steps;
  int enrolled = 0;  ///< participants of the study
  std::array<ForceMethod, kForceMethods.size()> methods;
  QString refusal;  ///< why there is no vote; empty if there is one
};

/// The votes of `series`, as elicitation::buildModel counts them. `end_n`: end of the force universe, if it is given.
/// Thread: any.
ForceVotes forceVotes(const study::Study& study, const std::string& series, std::optional<double> end_n);

/// The series in `study`, by name; `ascending` first.
std::vector<std::string> seriesOf(const study::Study& study);

}  // namespace tactus::workbench
