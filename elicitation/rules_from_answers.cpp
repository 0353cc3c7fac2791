#include "elicitation/rules_from_answers.h"

#include <algorithm>
#include <map>
#include <utility>

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

base::Result<SourcedRules> rulesFromAnswers(std::span<const study::Answer> answers, const study::Form& form,
                                            std::span<const std::string> output_terms) {
  std::map<int, const study::Answer*> by_item;
  for (const auto& answer : answers) {
    const std::string place = "answer of participant " + answer.participant + " to item " +
                              std::to_string(answer.item) + " of form " + form.id;
    const auto refused = [&answer, &place](base::ErrorCode code, std::string_view column, std::string found,
                                           std::string found_in_cell, std::string wanted) {
      return study::atCell({code, {}, place, std::move(found), std::move(wanted)},
                           {study::kAnswersTable, answer.line, column}, std::move(found_in_cell));
    };
    const std::string number = "item " + std::to_string(answer.item);
    const bool known = std::any_of(form.items.begin(), form.items.end(),
                                   [&answer](const study::FormItem& item) { return item.number == answer.item; });
    if (!known) {
      return refused(base::ErrorCode::kReference, "item", "an item that the form does not have",
                     number + ", which form " + form.id + " does not have",
                     "one of its " + std::to_string(form.items.size()) + " items");
    }
    if (!by_item.emplace(answer.item, &answer).second) {
      return refused(base::ErrorCode::kData, "item", "a second answer", number + " again", "one answer per item");
    }
    if (answer.status != study::Answer::Status::kAnswered) continue;
    if (std::find(output_terms.begin(), output_terms.end(), answer.term) == output_terms.end()) {
      return refused(base::ErrorCode::kReference, "term", "term " + base::quoted(answer.term),
                     base::quoted(answer.term), "one of " + base::joined(output_terms, ", "));
    }
  }

  SourcedRules out;
  for (const auto& item : form.items) {
    const auto answer = by_item.find(item.number);
    if (answer == by_item.end() || answer->second->status != study::Answer::Status::kAnswered) continue;
    out.rules.push_back({conditionsFrom(item.conditions), answer->second->term, 1, true});
    out.lines.push_back(answer->second->line);
  }
  return out;
}

fuzzy::Rule ruleFrom(const study::GivenRule& given) {
  return {conditionsFrom(given.conditions), given.then, given.weight, true};
}

}  // namespace tactus::elicitation
