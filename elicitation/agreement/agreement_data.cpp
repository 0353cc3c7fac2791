#include "elicitation/agreement/agreement_data.h"

#include <algorithm>
#include <utility>

#include "core/base/text.h"
#include "elicitation/agreement/agreement_table.h"

namespace tactus::elicitation {
namespace {

std::string forceName(double force_n) { return base::formatNumber(force_n) + " N"; }

}  // namespace

void noteUnrated(const std::vector<std::string>& units, AgreementData& data) {
  if (units.empty()) return;
  data.notes.push_back("Left out, because no participant chose a term: " + base::joined(units, ", ") + ".");
}

void noteSilent(const std::set<std::string>& all, AgreementData& data) {
  std::vector<std::string> silent;
  for (const auto& one : all) {
    if (std::find(data.raters.begin(), data.raters.end(), one) == data.raters.end()) silent.push_back(one);
  }
  if (silent.empty()) return;
  data.notes.push_back("Left out, because they chose no term: " + base::listed(silent) + ".");
}

base::Result<AgreementData> agreementData(std::span<const study::ForceJudgement> judgements, std::string_view series,
                                          std::span<const std::string> terms) {
  const auto steps = countVotes(judgements, series, terms);
  if (!steps) return tl::unexpected(steps.error());
  AgreementData data = agreementData(*steps, terms);

  const auto step_at = [&steps](double force_n) {
    return static_cast<std::size_t>(
        std::find_if(steps->begin(), steps->end(),
                     [force_n](const VoteCounts& step) { return force_n - step.force_n <= kSameForceN; }) -
        steps->begin());
  };
  std::vector<Rating<std::size_t>> ratings;
  std::vector<std::size_t> rated;
  std::set<std::string> people;
  for (std::size_t i = 0; i < steps->size(); ++i) {
    if (ratingsOf((*steps)[i].votes) > 0) rated.push_back(i);
  }
  for (const auto& judgement : judgements) {
    if (judgement.series != series) continue;
    people.insert(judgement.participant);
    if (judgement.kind != study::ForceJudgement::Kind::kTerm) continue;
    const auto term = std::find(terms.begin(), terms.end(), judgement.term) - terms.begin();
    ratings.push_back({judgement.participant, step_at(judgement.force_n), static_cast<std::size_t>(term)});
  }
  fillTable(data, ratings, rated);
  noteSilent(people, data);
  return data;
}

AgreementData agreementData(std::span<const VoteCounts> steps, std::span<const std::string> terms) {
  AgreementData data;
  data.terms.assign(terms.begin(), terms.end());
  data.counts.categories = terms.size();
  std::vector<std::string> unrated;
  for (const auto& step : steps) {
    if (ratingsOf(step.votes) == 0) {
      unrated.push_back(forceName(step.force_n));
      continue;
    }
    data.counts.units.push_back(step.votes);
    data.units.push_back({forceName(step.force_n), step.force_n, {}, {}});
  }
  noteUnrated(unrated, data);
  return data;
}

}  // namespace tactus::elicitation
