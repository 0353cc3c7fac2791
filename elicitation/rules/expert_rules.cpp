#include "elicitation/rules/expert_rules.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/procedure/procedure.h"

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

namespace {

std::vector<fuzzy::Condition> conditionsFrom(const std::vector<study::ItemCondition>& conditions) {
  std::vector<fuzzy::Condition> out;
  out.reserve(conditions.size());
  for (const auto& condition : conditions) out.push_back({condition.input, condition.term});
  return out;
}

MissingItem::Reason reasonOf(study::Answer::Status status) {
  switch (status) {
    case study::Answer::Status::kSkipped: return MissingItem::Reason::kSkipped;
    case study::Answer::Status::kCantTell: return MissingItem::Reason::kCantTell;
    case study::Answer::Status::kCleared: return MissingItem::Reason::kCleared;
    case study::Answer::Status::kAnswered: break;
  }
  return MissingItem::Reason::kNoAnswer;
}

}  // namespace

std::string_view name(MissingItem::Reason reason) noexcept {
  switch (reason) {
    case MissingItem::Reason::kNoAnswer: return "no answer";
    case MissingItem::Reason::kSkipped: return "skipped";
    case MissingItem::Reason::kCantTell: return "cannot tell";
    case MissingItem::Reason::kCleared: return "cleared";
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
    if (study::isWayOut(item)) continue;
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

namespace {

using base::ErrorCode;
using base::fail;
using base::quoted;
using base::Result;

const study::Form* findForm(std::span<const study::Form> forms, const std::string& id) {
  const auto it = std::find_if(forms.begin(), forms.end(), [&id](const study::Form& form) { return form.id == id; });
  return it == forms.end() ? nullptr : &*it;
}

std::string formIds(std::span<const study::Form> forms) {
  std::vector<std::string> ids;
  for (const auto& form : forms) ids.push_back(form.id);
  return ids.empty() ? "none" : base::joined(ids, ", ");
}

/// The set of depth terms of a form; a form that names none has the variable's own.
Result<std::string> depthTermsOf(const procedure::Procedure& about, const study::Form& form) {
  if (form.depth_terms.empty()) return about.way_terms.front().id;
  if (about.wayTerms(form.depth_terms) != nullptr) return form.depth_terms;
  std::vector<std::string> known;
  for (const auto& set : about.way_terms) known.push_back(set.id);
  return fail(ErrorCode::kReference, "form " + form.id, "depth terms " + quoted(form.depth_terms),
              "one of " + base::joined(known, ", "));
}

/// What people read of a set that `depthTermsOf` has looked up already.
const std::string& labelOf(const procedure::Procedure& about, const std::string& set) {
  return about.wayTerms(set)->label;
}

/// Sets the expert's depth terms to those of `form`, which `cell` names; another set than before is refused.
Result<void> joinForm(const procedure::Procedure& about, ExpertRules& expert, const study::Form& form,
                      const study::TableCell& cell) {
  TACTUS_TRY(auto set, depthTermsOf(about, form));
  if (!expert.depth_terms.empty() && expert.depth_terms != set) {
    return study::atCell(
        {ErrorCode::kData,
         {},
         "participant " + expert.participant.code,
         "forms with different depth terms (" + expert.forms.front() + ": " + labelOf(about, expert.depth_terms) +
             "; " + form.id + ": " + labelOf(about, set) + ")",
         "forms with the same depth terms"},
        cell,
        quoted(form.id) + " after " + quoted(expert.forms.front()) + " for participant " + expert.participant.code);
  }
  expert.depth_terms = std::move(set);
  if (std::find(expert.forms.begin(), expert.forms.end(), form.id) == expert.forms.end()) {
    expert.forms.push_back(form.id);
  }
  return {};
}

/// The set with all regions of the rules and the fewest others; where two are alike in that, the first of all sets.
std::string inferDepthTerms(const procedure::Procedure& about, const std::vector<fuzzy::Rule>& rules) {
  const std::string& way = about.wayInput().id;
  std::set<std::string> used;
  for (const auto& rule : rules) {
    for (const auto& condition : rule.conditions) {
      if (condition.input == way) used.insert(condition.term);
    }
  }
  const procedure::TermSet* best = nullptr;
  bool alike = false;
  for (const auto& set : about.way_terms) {
    const auto has = [&](const std::string& region) { return fuzzy::findTerm(set.terms, region) != nullptr; };
    if (!std::all_of(used.begin(), used.end(), has)) continue;
    if (best != nullptr && set.terms.size() > best->terms.size()) continue;
    alike = best != nullptr && set.terms.size() == best->terms.size();
    best = &set;
  }
  return best == nullptr || alike ? about.way_terms.front().id : best->id;
}

Result<void> addGiven(ExpertRules& expert, const study::Study& study, std::span<const study::Form> forms,
                      std::vector<std::string>& notes) {
  const procedure::Procedure& about = procedure::of(study);
  for (const auto& given : study.rules) {
    if (given.participant != expert.participant.code) continue;
    expert.source = ExpertRules::Source::kGiven;
    expert.rules.push_back(ruleFrom(given));
    expert.origins.push_back({given.form, 0, given.line});
    if (given.form.empty()) continue;
    const study::Form* const form = findForm(forms, given.form);
    const study::TableCell cell{study::kRulesTable, given.line, "form"};
    if (form == nullptr) {
      return study::atCell({ErrorCode::kReference,
                            {},
                            "rules of participant " + expert.participant.code,
                            "form " + quoted(given.form),
                            "one of " + formIds(forms)},
                           cell, quoted(given.form));
    }
    if (auto ok = joinForm(about, expert, *form, cell); !ok) return ok;
  }
  if (!expert.rules.empty() && expert.depth_terms.empty()) {
    expert.depth_terms = inferDepthTerms(about, expert.rules);
    expert.depth_terms_inferred = true;
    notes.push_back("The given rules of participant " + expert.participant.code +
                    " name no form; by the regions they use they get these depth terms: " +
                    labelOf(about, expert.depth_terms) + ".");
  }
  return {};
}

Result<void> addAnswered(const procedure::Procedure& about, ExpertRules& expert,
                         const std::vector<study::Answer>& answers, std::span<const study::Form> forms,
                         std::span<const std::string> output_terms) {
  for (const auto& form : forms) {
    std::vector<study::Answer> own;
    for (const auto& answer : answers) {
      if (answer.form == form.id) own.push_back(answer);
    }
    if (own.empty()) continue;
    TACTUS_TRY(const auto answered, rulesFromAnswers(own, form, output_terms));
    if (answered.rules.empty()) continue;
    if (auto ok = joinForm(about, expert, form, {study::kAnswersTable, answered.origins.front().line, "form"}); !ok)
      return ok;
    expert.rules.insert(expert.rules.end(), answered.rules.begin(), answered.rules.end());
    expert.origins.insert(expert.origins.end(), answered.origins.begin(), answered.origins.end());
    expert.missing.insert(expert.missing.end(), answered.missing.begin(), answered.missing.end());
  }
  return {};
}

void noteUnknownForms(const study::Study& study, std::span<const study::Form> forms, std::vector<std::string>& notes) {
  std::map<std::string, std::uint32_t> unknown;  // form, line of its first answer
  for (const auto& answer : study.answers) {
    if (findForm(forms, answer.form) == nullptr) unknown.emplace(answer.form, answer.line.number);
  }
  for (const auto& [form, line] : unknown) {
    const std::string from =
        line > 0 ? " (" + std::string(study::kAnswersTable) + ", from line " + std::to_string(line) + ")" : "";
    notes.push_back("Answers to the form " + quoted(form) + from +
                    " were passed over: it is not one that gives rules (" + formIds(forms) + ").");
  }
}

}  // namespace

Result<StudyRules> studyRules(const study::Study& study, std::span<const study::Form> forms,
                              std::span<const std::string> output_terms) {
  StudyRules out;
  noteUnknownForms(study, forms, out.notes);
  for (const auto& participant : study.participants) {
    ExpertRules expert;
    expert.participant = participant;
    if (auto ok = addGiven(expert, study, forms, out.notes); !ok) return tl::unexpected(ok.error());

    std::vector<study::Answer> answers;
    for (const auto& answer : study.answers) {
      if (answer.participant == participant.code) answers.push_back(answer);
    }
    if (!expert.rules.empty() && !answers.empty()) {
      out.notes.push_back("Participant " + participant.code +
                          " has both given rules and answers; the given rules are used.");
    } else if (expert.rules.empty()) {
      if (auto ok = addAnswered(procedure::of(study), expert, answers, forms, output_terms); !ok)
        return tl::unexpected(ok.error());
    }
    if (expert.rules.empty()) {
      out.notes.push_back("Participant " + participant.code + " has no rules and is not an expert of the model.");
    } else {
      out.experts.push_back(std::move(expert));
    }
  }
  if (out.experts.empty()) {
    return fail(ErrorCode::kData, "study", "no participant with rules",
                "answers to one of the forms (" + formIds(forms) + ") or given rules");
  }
  return out;
}

}  // namespace tactus::elicitation
