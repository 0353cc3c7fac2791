#include "elicitation/rules/rules_from_answers.h"

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

MissingItem::Reason reasonOf(study::Answer::Status status) {
  switch (status) {
    case study::Answer::Status::kSkipped:
      return MissingItem::Reason::kSkipped;
    case study::Answer::Status::kCantTell:
      return MissingItem::Reason::kCantTell;
    case study::Answer::Status::kCleared:
      return MissingItem::Reason::kCleared;
    case study::Answer::Status::kAnswered:
      break;
  }
  return MissingItem::Reason::kNoAnswer;
}

}  // namespace

std::string_view name(MissingItem::Reason reason) noexcept {
  switch (reason) {
    case MissingItem::Reason::kNoAnswer:
      return "no answer";
    case MissingItem::Reason::kSkipped:
      return "skipped";
    case MissingItem::Reason::kCantTell:
      return "cannot tell";
    case MissingItem::Reason::kCleared:
      return "cleared";
  }
  return "";
}

base::Result<AnsweredRules> rulesFromAnswers(std::span<const study::Answer> answers, const study::Form& form,
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
    if (answer.form != form.id) {
      return refused(base::ErrorCode::kReference, "form", "an answer to form " + base::quoted(answer.form),
                     base::quoted(answer.form), "an answer to form " + base::quoted(form.id));
    }
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
    if (answer.status != study::Answer::Status::kAnswered) {
      if (answer.term.empty()) continue;
      return refused(base::ErrorCode::kData, "term", "term " + base::quoted(answer.term), base::quoted(answer.term),
                     "no term, as the item has no answer (" + std::string(name(reasonOf(answer.status))) + ")");
    }
    if (std::find(output_terms.begin(), output_terms.end(), answer.term) == output_terms.end()) {
      return refused(base::ErrorCode::kReference, "term", "term " + base::quoted(answer.term),
                     base::quoted(answer.term), "one of " + base::joined(output_terms, ", "));
    }
  }

  AnsweredRules out;
  for (const auto& item : form.items) {
    const auto found = by_item.find(item.number);
    const study::Answer* const answer = found == by_item.end() ? nullptr : found->second;
    const RuleOrigin origin{form.id, item.number, answer == nullptr ? study::TableLine{} : answer->line};
    auto conditions = conditionsFrom(item.conditions);
    if (answer != nullptr && answer->status == study::Answer::Status::kAnswered) {
      out.rules.push_back({std::move(conditions), answer->term, 1, true});
      out.origins.push_back(origin);
    } else {
      const auto reason = answer == nullptr ? MissingItem::Reason::kNoAnswer : reasonOf(answer->status);
      out.missing.push_back({origin, reason, std::move(conditions)});
    }
  }
  return out;
}

fuzzy::Rule ruleFrom(const study::GivenRule& given) {
  return {conditionsFrom(given.conditions), given.then, given.weight, true};
}

}  // namespace tactus::elicitation
