#include "core/analysis/rule_steps.h"

#include <algorithm>
#include <map>

#include "core/analysis/rule_table.h"
#include "core/base/check.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {
namespace {

/// For each term its place in the order of the centres, from 0; terms with the same centre share one.
std::vector<int> places(const std::vector<fuzzy::Term>& terms) {
  std::vector<double> centres;
  for (const auto& term : terms) {
    const auto f = fuzzy::MembershipFunction::of(term);
    // A quarter of each: their sum may be beyond the range of double.
    centres.push_back(f.gaussian ? f.mean : f.a / 4 + f.b / 4 + f.c / 4 + f.d / 4);
  }
  std::vector<double> order = centres;
  std::sort(order.begin(), order.end());
  order.erase(std::unique(order.begin(), order.end()), order.end());
  std::vector<int> out;
  for (const double centre : centres) {
    out.push_back(static_cast<int>(std::lower_bound(order.begin(), order.end(), centre) - order.begin()));
  }
  return out;
}

}  // namespace

std::vector<NeighborStep> neighborSteps(const fuzzy::ForceModel& model, const fuzzy::Expert& expert,
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
  std::vector<NeighborStep> steps;
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

std::string describe(const NeighborStep& step, const fuzzy::ForceModel& model, const fuzzy::Expert& expert) {
  const auto& before = expert.rules[step.before];
  const auto& after = expert.rules[step.after];
  std::vector<fuzzy::Condition> others = before.conditions;
  const auto along = std::find_if(others.begin(), others.end(), [&](const fuzzy::Condition& condition) {
    return condition.input == model.inputs[step.input].id;
  });
  TACTUS_CHECK(along != others.end());
  std::string text = along->input + " from " + along->term + " to ";
  others.erase(along);
  for (const auto& condition : after.conditions) {
    if (condition.input == model.inputs[step.input].id) text += condition.term;
  }
  if (!others.empty()) text += " where " + describe(std::move(others));
  return text + ", " + model.output.id + " from " + before.then + " to " + after.then;
}

std::string describe(std::vector<fuzzy::Condition> conditions) {
  std::sort(conditions.begin(), conditions.end(),
            [](const fuzzy::Condition& x, const fuzzy::Condition& y) { return x.input < y.input; });
  std::string text;
  for (const auto& condition : conditions) {
    if (!text.empty()) text += " and ";
    text += condition.input + " is " + condition.term;
  }
  return text;
}

}  // namespace tactus::analysis
