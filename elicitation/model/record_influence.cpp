#include "elicitation/model/record_influence.h"

#include <string>
#include <utility>
#include <vector>

#include "elicitation/force/force_terms_from.h"
#include "elicitation/force/noticeable_force.h"
#include "elicitation/variables/ngt_variables.h"

namespace tactus::elicitation {
namespace {

using base::Result;

Result<RecordInfluence> compared(const fuzzy::ForceModel& with, const fuzzy::ForceModel& without) {
  const auto first = fuzzy::compile(with);
  if (!first) return tl::unexpected(first.error());
  const auto second = fuzzy::compile(without);
  if (!second) return tl::unexpected(second.error());
  RecordInfluence out;
  out.difference = analysis::forceDifference(with, *first, without, *second);
  if (out.difference.largest_n > 0) {
    out.noticeable = out.difference.largest_n / justNoticeableDifference(out.difference.first_n);
  }
  return out;
}

}  // namespace

Result<RecordInfluence> withoutJudgement(const BuiltModel& built, const study::Study& study,
                                         const BuildSettings& settings, std::size_t index) {
  if (study.judgements[index].series != settings.series) return RecordInfluence();
  std::vector<study::ForceJudgement> rest = study.judgements;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(index));
  const fuzzy::Variable words = ngtOutput();
  std::vector<std::string> ids;
  for (const fuzzy::Term& term : words.terms) ids.push_back(term.id);
  const auto counts = countVotes(rest, settings.series, ids);
  if (!counts) return tl::unexpected(counts.error());
  const auto votes = vote(*counts, static_cast<int>(study.participants.size()));
  const auto terms = forceTermsFrom(settings.force_terms, words, rest, settings.series, votes, settings.force_end_n);
  if (!terms) return tl::unexpected(terms.error());
  fuzzy::ForceModel without = built.model;
  without.output = terms->output;
  return compared(built.model, without);
}

Result<RecordInfluence> withoutRule(const BuiltModel& built, std::size_t expert, std::size_t rule) {
  fuzzy::ForceModel without = built.model;
  auto& rules = without.experts[expert].rules;
  rules.erase(rules.begin() + static_cast<std::ptrdiff_t>(rule));
  return compared(built.model, without);
}

}  // namespace tactus::elicitation
