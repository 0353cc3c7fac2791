#include "elicitation/rules/expert_rules.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "core/base/text.h"
#include "elicitation/variables/ngt_variables.h"

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

/// What people read of a set that `depthTermsOf` has looked up already.
std::string labelOf(const std::string& set) { return findDepthTerms(set).value().label; }

/// Sets the expert's depth terms to those of `form`, which `cell` names; another set than before is refused.
Result<void> joinForm(ExpertRules& expert, const study::Form& form, const study::TableCell& cell) {
  auto set = depthTermsOf(form);
  if (!set) return tl::unexpected(set.error());
  if (!expert.depth_terms.empty() && expert.depth_terms != *set) {
    return study::atCell(
        {ErrorCode::kData,
         {},
         "participant " + expert.participant.code,
         "forms with different depth terms (" + expert.forms.front() + ": " + labelOf(expert.depth_terms) + "; " +
             form.id + ": " + labelOf(*set) + ")",
         "forms with the same depth terms"},
        cell,
        quoted(form.id) + " after " + quoted(expert.forms.front()) + " for participant " + expert.participant.code);
  }
  expert.depth_terms = std::move(*set);
  if (std::find(expert.forms.begin(), expert.forms.end(), form.id) == expert.forms.end()) {
    expert.forms.push_back(form.id);
  }
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
    if (auto ok = joinForm(expert, *form, cell); !ok) return ok;
  }
  if (!expert.rules.empty() && expert.depth_terms.empty()) {
    expert.depth_terms = inferDepthTerms(expert.rules);
    expert.depth_terms_inferred = true;
    notes.push_back(
        "The given rules of participant " + expert.participant.code +
        " name no form; by the regions they use they get these depth terms: " + labelOf(expert.depth_terms) + ".");
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
    const auto answered = rulesFromAnswers(own, form, output_terms);
    if (!answered) return tl::unexpected(answered.error());
    if (answered->rules.empty()) continue;
    if (auto ok = joinForm(expert, form, {study::kAnswersTable, answered->origins.front().line, "form"}); !ok)
      return ok;
    expert.rules.insert(expert.rules.end(), answered->rules.begin(), answered->rules.end());
    expert.origins.insert(expert.origins.end(), answered->origins.begin(), answered->origins.end());
    expert.missing.insert(expert.missing.end(), answered->missing.begin(), answered->missing.end());
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

}  // namespace tactus::elicitation
