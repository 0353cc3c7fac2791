#include "core/analysis/rule_steps.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "core/analysis/rule_table.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {
namespace {

/// For each term its place in the order of the centres, from 0.
std::vector<int> places(const std::vector<fuzzy::Term>& terms) {
  std::vector<double> centres;
  for (const auto& term : terms) {
    const auto f = fuzzy::MembershipFunction::of(term);
    centres.push_back(f.gaussian ? f.mean : f.a / 4 + f.b / 4 + f.c / 4 + f.d / 4);
  }
  std::vector<std::size_t> order(terms.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) { return centres[x] < centres[y]; });
  std::vector<int> out(terms.size());
  for (std::size_t k = 0; k < order.size(); ++k) out[order[k]] = static_cast<int>(k);
  return out;
}

}  // namespace

std::vector<NeighbourStep> neighbourSteps(const fuzzy::ForceModel& model, const fuzzy::Expert& expert,
                                          std::size_t input) {
  const auto along = places(termsFor(expert, model.inputs[input]));
  const auto levels = places(termsFor(expert, model.output));
  // By the other conditions, then by the place of the term along the input.
  std::map<std::uint64_t, std::map<int, std::vector<const ResolvedRule*>>> sequences;
  const auto rules = resolveRules(model, expert);
  for (const auto& rule : rules) {
    const int term = rule.termOf(input);
    if (term < 0) continue;
    const std::uint64_t others = rule.conditions & ~(std::uint64_t{0x7F} << (7 * input));
    sequences[others][along[static_cast<std::size_t>(term)]].push_back(&rule);
  }
  std::vector<NeighbourStep> steps;
  for (const auto& [others, sequence] : sequences) {
    for (auto here = sequence.begin(); here != sequence.end(); ++here) {
      const auto next = std::next(here);
      if (next == sequence.end()) break;
      for (const auto* before : here->second) {
        for (const auto* after : next->second) {
          steps.push_back({input, before->index, after->index, levels[after->then] - levels[before->then],
                           next->first == here->first + 1});
        }
      }
    }
  }
  return steps;
}

RuleStep ruleStep(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const NeighbourStep& step) {
  const std::string& input = model.inputs[step.input].id;
  const auto& before = expert.rules[step.before];
  const auto& after = expert.rules[step.after];
  std::string from;
  std::string to;
  std::vector<fuzzy::Condition> others;
  for (const auto& condition : before.conditions) {
    if (condition.input == input) {
      from = condition.term;
    } else {
      others.push_back(condition);
    }
  }
  for (const auto& condition : after.conditions) {
    if (condition.input == input) to = condition.term;
  }
  std::string text = input + " from " + from + " to " + to;
  if (!others.empty()) text += " where " + describe(std::move(others));
  text += ", " + model.output.id + " from " + before.then + " to " + after.then;
  return {std::move(text), before.conditions, after.conditions, step.levels > 0};
}

}  // namespace tactus::analysis
