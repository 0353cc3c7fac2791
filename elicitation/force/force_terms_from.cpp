#include "elicitation/force/force_terms_from.h"

#include "core/base/check.h"
#include "elicitation/force/force_frequency.h"
#include "elicitation/force/force_probit.h"
#include "elicitation/force/force_thresholds.h"

namespace tactus::elicitation {

base::Result<ForceTerms> forceTermsFrom(ForceTermsFrom from, const fuzzy::Variable& output,
                                        std::span<const study::ForceJudgement> judgements, std::string_view series,
                                        std::span<const VoteStep> steps, std::optional<double> end_n) {
  switch (from) {
    case ForceTermsFrom::kVote:
      return forceTerms(output, steps, end_n);
    case ForceTermsFrom::kFrequency:
      return frequencyTerms(output, steps, end_n);
    case ForceTermsFrom::kThresholds:
      return thresholdTerms(output, judgements, series, steps, end_n);
    case ForceTermsFrom::kProbit:
      return probitTerms(output, judgements, series, steps, end_n);
  }
  TACTUS_CHECK(false);
}

}  // namespace tactus::elicitation
