#include "core/analysis/directions.h"

#include <algorithm>
#include <map>
#include <optional>

#include "core/fuzzy/membership.h"

namespace tactus::analysis {
namespace {

using fuzzy::Condition;
using fuzzy::Term;

double centre(const Term& term) {
  const auto f = fuzzy::MembershipFunction::of(term);
  return f.gaussian ? f.mean : (f.a + f.b + f.c + f.d) / 4;
}

/// Consequents along one input with the other conditions fixed, by the centre of the input's term.
using Sequence = std::multimap<double, std::pair<const Term*, const Term*>>;

}  // namespace

std::string describe(std::vector<Condition> conditions) {
  std::sort(conditions.begin(), conditions.end(),
            [](const Condition& x, const Condition& y) { return x.input < y.input; });
  std::string text;
  for (const auto& condition : conditions) {
    if (!text.empty()) text += " and ";
    text += condition.input + " is " + condition.term;
  }
  return text;
}

ExpertDirection direction(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const fuzzy::Variable& input) {
  std::map<std::string, Sequence> sequences;
  for (const auto& rule : expert.rules) {
    if (!rule.enabled) continue;
    std::vector<Condition> others;
    const Term* along = nullptr;
    for (const auto& condition : rule.conditions) {
      if (condition.input == input.id) {
        along = findTerm(termsFor(expert, input), condition.term);
      } else {
        others.push_back(condition);
      }
    }
    if (along == nullptr) continue;
    const Term* const then = findTerm(termsFor(expert, model.output), rule.then);
    sequences[describe(others)].emplace(centre(*along), std::pair{along, then});
  }

  std::vector<std::string> up;
  std::vector<std::string> down;
  for (const auto& [others, sequence] : sequences) {
    const std::pair<const Term*, const Term*>* before = nullptr;
    for (const auto& [position, here] : sequence) {
      if (before != nullptr) {
        const double change = centre(*here.second) - centre(*before->second);
        const std::string step = input.id + " from " + before->first->id + " to " + here.first->id +
                                 (others.empty() ? "" : " where " + others) + ", force from " + before->second->id +
                                 " to " + here.second->id;
        if (change > 0) up.push_back(step);
        if (change < 0) down.push_back(step);
      }
      before = &here;
    }
  }
  const std::size_t steps = up.size() + down.size();
  if (steps > 0 && 4 * up.size() >= 3 * steps) return {Direction::kRises, std::move(down)};
  if (steps > 0 && 4 * down.size() >= 3 * steps) return {Direction::kFalls, std::move(up)};
  return {};
}

}  // namespace tactus::analysis
