#include "app/workbench/labs/force/force_data.h"

#include <set>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "elicitation/force/force_terms_from.h"
#include "elicitation/variables/ngt_variables.h"

namespace tactus::workbench {

ForceVotes forceVotes(const study::Study& study, const std::string& series, std::optional<double> end_n) {
  ForceVotes out;
  out.words = elicitation::ngtOutput();
  out.enrolled = static_cast<int>(study.participants.size());
  std::vector<std::string> ids;
  for (const fuzzy::Term& term : out.words.terms) ids.push_back(term.id);
  const auto counts = elicitation::countVotes(study.judgements, series, ids);
  if (!counts) {
    out.refusal = text(counts.error().message());
    return out;
  }
  out.steps = elicitation::vote(*counts, out.enrolled);
  for (std::size_t i = 0; i < kForceMethods.size(); ++i) {
    ForceMethod& method = out.methods[i];
    method.from = kForceMethods[i];
    auto terms = elicitation::forceTermsFrom(method.from, out.words, study.judgements, series, out.steps, end_n);
    if (terms) {
      method.terms = std::move(*terms);
    } else {
      method.refusal = text(terms.error().message());
    }
  }
  return out;
}

std::vector<std::string> seriesOf(const study::Study& study) {
  constexpr auto kFirst = "ascending";
  std::set<std::string> names;
  for (const study::ForceJudgement& judgement : study.judgements) names.insert(judgement.series);
  std::vector<std::string> out;
  if (names.erase(kFirst) > 0) out.emplace_back(kFirst);
  out.insert(out.end(), names.begin(), names.end());
  return out;
}

}  // namespace tactus::workbench
