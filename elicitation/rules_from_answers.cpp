#include "elicitation/rules_from_answers.h"

#include <algorithm>
#include <map>

#include "core/base/text.h"

namespace tactus::elicitation {
namespace {

std::vector<fuzzy::Condition> conditionsFrom(const std::vector<study::ItemCondition>& conditions) {
  std::vector<fuzzy::Condition> out;
  out.reserve(conditions.size());
  for (const auto& condition : conditions) out.push_back({condition.input, condition.term});
  return out;
}

}  // namespace

base::Result<std::vector<fuzzy::Rule>> rulesFromAnswers(std::span<const study::Answer> answers, const study::Form& form,
                                                        std::span<const std::string> output_terms) {
  std::map<int, const study::Answer*> by_item;
  for (const auto& answer : answers) {
    const std::string place = "answer of participant " + answer.participant + " to item " +
                              std::to_string(answer.item) + " of form " + form.id;
    const bool known = std::any_of(form.items.begin(), form.items.end(),
                                   [&answer](const study::FormItem& item) { return item.number == answer.item; });
    if (!known) {
      return base::fail(base::ErrorCode::kReference, place, "an item that the form does not have",
                        "one of its " + std::to_string(form.items.size()) + " items");
    }
    if (!by_item.emplace(answer.item, &answer).second) {
      return base::fail(base::ErrorCode::kData, place, "a second answer", "one answer per item");
    }
    if (answer.status != study::Answer::Status::kAnswered) continue;
    if (std::find(output_terms.begin(), output_terms.end(), answer.term) == output_terms.end()) {
      return base::fail(base::ErrorCode::kReference, place, "term " + base::quoted(answer.term),
                        "one of " + base::joined(output_terms, ", "));
    }
  }

  std::vector<fuzzy::Rule> rules;
  for (const auto& item : form.items) {
    const auto answer = by_item.find(item.number);
    if (answer == by_item.end() || answer->second->status != study::Answer::Status::kAnswered) continue;
    rules.push_back({conditionsFrom(item.conditions), answer->second->term, 1, true});
  }
  return rules;
}

fuzzy::Rule ruleFrom(const study::GivenRule& given) {
  return {conditionsFrom(given.conditions), given.then, given.weight, true};
}

}  // namespace tactus::elicitation
