#include "core/analysis/force_balance.h"

#include <algorithm>
#include <cmath>

#include "core/fuzzy/centroid.h"

namespace tactus::analysis {
namespace {

/// The slices of each output term, measured from the lower end of the universe.
std::vector<fuzzy::AreaAndMoment> slicesOf(const fuzzy::ForceModel& model, const fuzzy::Expert& expert,
                                           const std::vector<ExplainedOutputTerm>& terms) {
  const std::vector<fuzzy::Term>& output = termsFor(expert, model.output);
  double highest = 0;
  for (const auto& term : terms) highest = std::max(highest, term.strength);
  std::vector<fuzzy::MembershipFunction> functions(terms.size());
  std::vector<fuzzy::ActiveTerm> active;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (!terms[t].winning_rule) continue;
    functions[t] = fuzzy::MembershipFunction::of(output[t]);
    active.push_back({&functions[t], terms[t].strength, terms[t].strength / highest});
  }
  std::vector<fuzzy::AreaAndMoment> found(active.size());
  fuzzy::sliceMoments(active, model.implication, model.output.min, model.output.max, found);
  std::vector<fuzzy::AreaAndMoment> out(terms.size());
  for (std::size_t t = 0, next = 0; t < terms.size(); ++t) {
    if (terms[t].winning_rule) out[t] = found[next++];
  }
  return out;
}

/// What each of the `rules` gives to a strength that is their maximum (airport game): shares that sum to 1.
std::vector<double> maxGame(const std::vector<double>& strengths) {
  std::vector<std::size_t> order(strengths.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return strengths[a] < strengths[b]; });
  std::vector<double> out(strengths.size(), 0);
  double below = 0;
  double sum = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    sum += (strengths[order[i]] - below) / static_cast<double>(order.size() - i);
    below = strengths[order[i]];
    out[order[i]] = sum / strengths[order.back()];
  }
  return out;
}

/// Adds an expert whose force counts for `weight` of `balance.force_n`.
void addExpert(const fuzzy::ForceModel& model, const ExplainedExpert& explained, std::size_t expert, double weight,
               ForceBalance& balance) {
  const auto slices = slicesOf(model, model.experts[expert], explained.output_terms);
  const double force = balance.force_n - model.output.min;
  double area = 0;
  for (const auto& one : slices) area += one.area;
  if (!(area > 0)) area = 1;  // sets narrower than any number tells: all at one place, without a share
  for (std::size_t t = 0; t < slices.size(); ++t) {
    const ExplainedOutputTerm& term = explained.output_terms[t];
    if (!term.winning_rule) continue;
    const double pull_n = weight * (slices[t].moment - force * slices[t].area) / area;
    auto word = std::find_if(balance.words.begin(), balance.words.end(),
                             [&](const WordPull& one) { return one.term == term.term; });
    if (word == balance.words.end()) {
      word = balance.words.insert(balance.words.end(), WordPull{});
      word->term = term.term;
    }
    word->strength += weight * term.strength;
    word->share += weight * slices[t].area / area;
    word->pull_n += pull_n;

    std::vector<std::size_t> rules;
    std::vector<double> strengths;
    for (const ExplainedRule& rule : explained.rules) {
      if (rule.strength <= 0 || model.experts[expert].rules[rule.rule].then != term.term) continue;
      rules.push_back(rule.rule);
      strengths.push_back(rule.strength);
    }
    const std::vector<double> shares = maxGame(strengths);
    for (std::size_t r = 0; r < rules.size(); ++r) balance.rules.push_back({expert, rules[r], pull_n * shares[r]});
  }
}

}  // namespace

ForceBalance forceBalance(const fuzzy::ForceModel& model, const Explanation& explanation,
                          std::optional<std::size_t> expert) {
  ForceBalance balance;
  const auto counts = [&](std::size_t e) {
    const ExplainedExpert& one = explanation.experts[e];
    return !one.abstains && (expert ? e == *expert : one.weight_share > 0);
  };
  balance.force_n = expert ? explanation.experts[*expert].force_n : explanation.force_n;
  for (const fuzzy::Term& term : model.output.terms) balance.words.push_back({term.id, 0, 0, 0, 0});
  for (std::size_t e = 0; e < explanation.experts.size(); ++e) {
    if (!counts(e)) continue;
    const ExplainedExpert& one = explanation.experts[e];
    const double weight = expert ? 1 : one.weight_share;
    addExpert(model, one, e, weight, balance);
    ExpertPull pull{e, one.force_n, weight * (one.force_n - balance.force_n), std::nullopt};
    if (weight < 1) pull.leave_one_out_n = pull.pull_n / (1 - weight);
    balance.experts.push_back(pull);
  }
  std::erase_if(balance.words, [](const WordPull& word) { return word.strength <= 0; });
  for (WordPull& word : balance.words) {
    word.centroid_n = balance.force_n + (word.share > 0 ? word.pull_n / word.share : 0);
  }
  std::stable_sort(balance.rules.begin(), balance.rules.end(),
                   [](const RulePull& a, const RulePull& b) { return std::abs(a.pull_n) > std::abs(b.pull_n); });
  return balance;
}

}  // namespace tactus::analysis
