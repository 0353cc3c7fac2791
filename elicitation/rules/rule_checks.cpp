#include "elicitation/rules/rule_checks.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/base/check.h"
#include "core/base/text.h"

namespace tactus::elicitation {
namespace {

using base::ErrorCode;
using base::quoted;
using base::Result;

std::string termIds(const std::vector<fuzzy::Term>& terms) {
  std::vector<std::string> ids;
  for (const auto& term : terms) ids.push_back(term.id);
  return base::joined(ids, ", ");
}

/// A rule of an expert, for errors about it.
struct RuleAt {
  const ExpertRules& origin;
  std::size_t index;

  bool given() const { return origin.source == ExpertRules::Source::kGiven; }

  /// An error about the cell `given_column` of rules.csv or `answer_column` of answers.csv, or about the rule by
  /// number.
  tl::unexpected<base::Error> refuse(ErrorCode code, std::string_view given_column, std::string_view answer_column,
                                     std::string found, std::string found_in_cell, std::string wanted) const {
    const std::string place = "rule " + std::to_string(index + 1) + " of participant " + origin.participant.code;
    return study::atCell({code, {}, place, std::move(found), std::move(wanted)},
                         {given() ? study::kRulesTable : study::kAnswersTable, origin.origins[index].line,
                          given() ? given_column : answer_column},
                         std::move(found_in_cell));
  }
};

Result<void> checkCondition(const fuzzy::Condition& condition, const fuzzy::Expert& expert,
                            std::span<const fuzzy::Variable> inputs, const RuleAt& rule) {
  const auto input = std::find_if(inputs.begin(), inputs.end(),
                                  [&condition](const fuzzy::Variable& v) { return v.id == condition.input; });
  if (input == inputs.end()) {
    std::vector<std::string> ids;
    for (const auto& variable : inputs) ids.push_back(variable.id);
    const std::string found = "input " + quoted(condition.input);
    return rule.refuse(ErrorCode::kReference, condition.input, "item", found, found,
                       "one of " + base::joined(ids, ", "));
  }
  const auto& terms = fuzzy::termsFor(expert, *input);
  if (fuzzy::findTerm(terms, condition.term) != nullptr) return {};
  const std::string found = input->id + " " + quoted(condition.term);
  return rule.refuse(ErrorCode::kReference, input->id, "item", found, rule.given() ? quoted(condition.term) : found,
                     "one of " + termIds(terms));
}

using Conditions = std::vector<std::pair<std::string, std::string>>;

/// The conditions of a rule, the same whatever their order.
Conditions sortedConditions(const fuzzy::Rule& rule) {
  Conditions out;
  for (const auto& condition : rule.conditions) out.emplace_back(condition.input, condition.term);
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

Result<void> checkRules(const fuzzy::Expert& expert, const ExpertRules& origin, std::span<const fuzzy::Variable> inputs,
                        const fuzzy::Variable& output, std::span<const std::string> absent_output_terms) {
  TACTUS_CHECK(origin.origins.size() == expert.rules.size());
  std::set<std::pair<Conditions, std::string>> seen;
  for (std::size_t i = 0; i < expert.rules.size(); ++i) {
    const fuzzy::Rule& rule = expert.rules[i];
    const RuleAt at{origin, i};
    for (const auto& condition : rule.conditions) {
      if (auto ok = checkCondition(condition, expert, inputs, at); !ok) return ok;
    }
    const auto refuse_then = [&](std::string wanted) {
      return at.refuse(ErrorCode::kReference, "then", "term", output.id + " " + quoted(rule.then), quoted(rule.then),
                       std::move(wanted));
    };
    if (std::find(absent_output_terms.begin(), absent_output_terms.end(), rule.then) != absent_output_terms.end()) {
      return refuse_then("a term that the judged forces give: there is no room for " + quoted(rule.then) +
                         " between 0 N and the end of the universe at " + base::roundedNumber(output.max) + " N");
    }
    if (fuzzy::findTerm(output.terms, rule.then) == nullptr) return refuse_then("one of " + termIds(output.terms));
    if (!(rule.weight >= 0 && rule.weight <= 1)) {
      const std::string weight = base::formatNumber(rule.weight);
      return at.refuse(ErrorCode::kValue, "weight", "term", "weight " + weight, quoted(weight), "a number in [0, 1]");
    }
    if (!seen.emplace(sortedConditions(rule), rule.then).second) {
      const std::string found = "the same rule as before";
      return at.refuse(ErrorCode::kSchema, "then", "item", found, found, "each rule once");
    }
  }
  return {};
}

std::optional<std::string> contradictionNote(const ExpertRules& expert) {
  std::map<Conditions, std::size_t> first_with;
  std::string first;
  int contradictions = 0;
  const auto said = [&expert](std::size_t rule) {
    const auto line = expert.origins[rule].line.number;
    return "rule " + std::to_string(rule + 1) + (line > 0 ? " (line " + std::to_string(line) + ")" : "") + " says " +
           quoted(expert.rules[rule].then);
  };
  for (std::size_t i = 0; i < expert.rules.size(); ++i) {
    const auto earlier = first_with.emplace(sortedConditions(expert.rules[i]), i).first->second;
    if (expert.rules[earlier].then == expert.rules[i].then) continue;
    if (contradictions++ == 0) first = said(earlier) + ", " + said(i);
  }
  if (contradictions == 0) return std::nullopt;
  return "Participant " + expert.participant.code + " contradicts themselves: " + first + " of the same conditions" +
         (contradictions > 1 ? "; " + std::to_string(contradictions) + " such rules in all." : ".");
}

}  // namespace tactus::elicitation
