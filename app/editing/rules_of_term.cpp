#include "app/editing/rules_of_term.h"

#include <algorithm>

#include "app/editing/edit_text.h"

namespace tactus::editing {

bool names(const fuzzy::Rule& rule, const fuzzy::ForceModel& model, const fuzzy::Variable& variable,
           const std::string& term) {
  if (variable.id == model.output.id) return rule.then == term;
  return std::find(rule.conditions.begin(), rule.conditions.end(), fuzzy::Condition{variable.id, term}) !=
         rule.conditions.end();
}

fuzzy::Rule withTerm(fuzzy::Rule rule, const fuzzy::ForceModel& model, const fuzzy::Variable& variable,
                     const std::string& from, const std::string& to) {
  if (variable.id == model.output.id) {
    if (rule.then == from) rule.then = to;
    return rule;
  }
  for (auto& condition : rule.conditions) {
    if (condition.input == variable.id && condition.term == from) condition.term = to;
  }
  return rule;
}

base::Result<void> letGo(fuzzy::Expert& expert, const fuzzy::ForceModel& model, const fuzzy::Variable& variable,
                         const std::string& term, RulesOfTerm rules) {
  const auto concerned = [&](const fuzzy::Rule& rule) { return names(rule, model, variable, term); };
  const auto count = std::count_if(expert.rules.begin(), expert.rules.end(), concerned);
  if (count == 0) return {};
  if (rules == RulesOfTerm::kRefuse) {
    return base::fail(
        base::ErrorCode::kReference, labelOf(variable) + " / " + term,
        std::to_string(count) + (count == 1 ? " rule of " : " rules of ") + labelOf(expert) + " with this term",
        "none, or that they are removed too");
  }
  expert.rules.erase(std::remove_if(expert.rules.begin(), expert.rules.end(), concerned), expert.rules.end());
  return {};
}

}  // namespace tactus::editing
