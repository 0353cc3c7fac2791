#include "elicitation/expert_rules.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/base/text.h"
#include "elicitation/ngt_variables.h"
#include "elicitation/rules_from_answers.h"

namespace tactus::elicitation {
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
Result<std::string> depthTermsOf(const study::Form& form) {
  if (form.depth_terms.empty()) return std::string(kDefaultDepthTerms);
  if (findDepthTerms(form.depth_terms)) return form.depth_terms;
  std::vector<std::string> known;
  for (const auto& set : depthTermSets()) known.push_back(set.id);
  return fail(ErrorCode::kReference, "form " + form.id, "depth terms " + quoted(form.depth_terms),
              "one of " + base::joined(known, ", "));
}

/// Sets the expert's depth terms to those of `form`; another set than before is refused.
Result<void> joinForm(ExpertRules& expert, const study::Form& form) {
  auto set = depthTermsOf(form);
  if (!set) return tl::unexpected(set.error());
  if (!expert.depth_terms.empty() && expert.depth_terms != *set) {
    return fail(ErrorCode::kData, "participant " + expert.participant.code,
                "forms with different depth terms (" + expert.depth_terms + ", " + *set + ")",
                "forms with the same depth terms");
  }
  expert.depth_terms = std::move(*set);
  return {};
}

std::string inferDepthTerms(const std::vector<fuzzy::Rule>& rules) {
  bool oropharynx = false;
  bool stomach = false;
  for (const auto& rule : rules) {
    for (const auto& condition : rule.conditions) {
      if (condition.input != "depth") continue;
      oropharynx = oropharynx || condition.term == "oropharynx";
      stomach = stomach || condition.term == "stomach";
    }
  }
  if (stomach && !oropharynx) return "form_a2";
  if (oropharynx && !stomach) return "form_a1";
  return std::string(kDefaultDepthTerms);
}

Result<void> addGiven(ExpertRules& expert, const study::Study& study, std::span<const study::Form> forms,
                      std::vector<std::string>& notes) {
  for (const auto& given : study.rules) {
    if (given.participant != expert.participant.code) continue;
    expert.source = ExpertRules::Source::kGiven;
    expert.rules.push_back(ruleFrom(given));
    if (given.form.empty()) continue;
    const study::Form* const form = findForm(forms, given.form);
    if (form == nullptr) {
      return fail(ErrorCode::kReference, "rules of participant " + expert.participant.code,
                  "form " + quoted(given.form), "one of " + formIds(forms));
    }
    if (auto ok = joinForm(expert, *form); !ok) return ok;
  }
  if (!expert.rules.empty() && expert.depth_terms.empty()) {
    expert.depth_terms = inferDepthTerms(expert.rules);
    notes.push_back("The given rules of participant " + expert.participant.code +
                    " name no form; by the regions they use they get the depth terms " + expert.depth_terms + ".");
  }
  return {};
}

Result<void> addAnswered(ExpertRules& expert, const std::vector<study::Answer>& answers,
                         std::span<const study::Form> forms, std::span<const std::string> output_terms) {
  for (const auto& form : forms) {
    std::vector<study::Answer> own;
    for (const auto& answer : answers) {
      if (answer.form == form.id) own.push_back(answer);
    }
    if (own.empty()) continue;
    auto rules = rulesFromAnswers(own, form, output_terms);
    if (!rules) return tl::unexpected(rules.error());
    if (rules->empty()) continue;
    if (auto ok = joinForm(expert, form); !ok) return ok;
    expert.rules.insert(expert.rules.end(), rules->begin(), rules->end());
  }
  return {};
}

void noteUnknownForms(const study::Study& study, std::span<const study::Form> forms, std::vector<std::string>& notes) {
  std::set<std::string> unknown;
  for (const auto& answer : study.answers) {
    if (findForm(forms, answer.form) == nullptr) unknown.insert(answer.form);
  }
  for (const auto& form : unknown) {
    notes.push_back("Answers to the form " + quoted(form) + " were passed over: it is not one that gives rules (" +
                    formIds(forms) + ").");
  }
}

std::string termIds(const std::vector<fuzzy::Term>& terms) {
  std::vector<std::string> ids;
  for (const auto& term : terms) ids.push_back(term.id);
  return base::joined(ids, ", ");
}

Result<void> checkCondition(const fuzzy::Condition& condition, const fuzzy::Expert& expert,
                            std::span<const fuzzy::Variable> inputs, const std::string& place) {
  const auto input = std::find_if(inputs.begin(), inputs.end(),
                                  [&condition](const fuzzy::Variable& v) { return v.id == condition.input; });
  if (input == inputs.end()) {
    std::vector<std::string> ids;
    for (const auto& variable : inputs) ids.push_back(variable.id);
    return fail(ErrorCode::kReference, place, "input " + quoted(condition.input), "one of " + base::joined(ids, ", "));
  }
  const auto& terms = fuzzy::termsFor(expert, *input);
  if (fuzzy::findTerm(terms, condition.term) != nullptr) return {};
  return fail(ErrorCode::kReference, place, input->id + " " + quoted(condition.term), "one of " + termIds(terms));
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
      if (auto ok = addAnswered(expert, answers, forms, output_terms); !ok) return tl::unexpected(ok.error());
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

Result<void> checkRules(const fuzzy::Expert& expert, std::span<const fuzzy::Variable> inputs,
                        const fuzzy::Variable& output, std::span<const std::string> absent_output_terms) {
  std::set<std::vector<std::pair<std::string, std::string>>> seen;
  for (std::size_t i = 0; i < expert.rules.size(); ++i) {
    const fuzzy::Rule& rule = expert.rules[i];
    const std::string place = "rule " + std::to_string(i + 1) + " of participant " + expert.id;
    std::vector<std::pair<std::string, std::string>> key;
    for (const auto& condition : rule.conditions) {
      if (auto ok = checkCondition(condition, expert, inputs, place); !ok) return ok;
      key.emplace_back(condition.input, condition.term);
    }
    if (std::find(absent_output_terms.begin(), absent_output_terms.end(), rule.then) != absent_output_terms.end()) {
      return fail(ErrorCode::kReference, place, output.id + " " + quoted(rule.then),
                  "a term that the judged forces give: no force was voted " + quoted(rule.then) +
                      " and there is no room for it");
    }
    if (fuzzy::findTerm(output.terms, rule.then) == nullptr) {
      return fail(ErrorCode::kReference, place, output.id + " " + quoted(rule.then), "one of " + termIds(output.terms));
    }
    if (!(rule.weight >= 0 && rule.weight <= 1)) {
      return fail(ErrorCode::kValue, place, "weight " + base::formatNumber(rule.weight), "a number in [0, 1]");
    }
    std::sort(key.begin(), key.end());
    key.emplace_back(output.id, rule.then);
    if (!seen.insert(std::move(key)).second) {
      return fail(ErrorCode::kSchema, place, "the same rule as before", "each rule once");
    }
  }
  return {};
}

}  // namespace tactus::elicitation
