// The rules of each expert of a study, and their depth terms.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"

namespace tactus::elicitation {

// Converts an expert's answers to rules (paper, Section 3.4, Tables A1 and A2).

/// The origin of a rule, or of a missing rule.
struct RuleOrigin {
  std::string form;            ///< of an answer; for a given rule the form or reading that it names; may be empty
  int item = 0;                ///< the form's item number; 0 for a given rule
  study::TableLine line = {};  ///< of answers.csv, or of rules.csv for a given rule
};

/// An item without a rule.
struct MissingItem {
  enum class Reason { kNoAnswer, kSkipped, kCantTell, kCleared };

  RuleOrigin origin;
  Reason reason = Reason::kNoAnswer;
  std::vector<fuzzy::Condition> conditions;  ///< of the missing rule
};

/// `no answer`, `skipped`, `cannot tell`, `cleared`.
std::string_view name(MissingItem::Reason reason) noexcept;

/// The rules of a form. Every item is either in `rules` or in `missing`, in the order of the form.
struct AnsweredRules {
  std::vector<fuzzy::Rule> rules;
  std::vector<RuleOrigin> origins;  ///< one per rule
  std::vector<MissingItem> missing;
};

/// The rules of one participant's answers to `form`, in the order of its items, with weight 1: IF the item's conditions
/// THEN the output is the answer. An item without an answer (absent, skipped, cannot tell, cleared) gives no rule.
/// Returns an error for: an answer to another form, an item number that the form lacks, a duplicate item (a record
/// holds only the last answer, without its history), an answer that is not in `output_terms`, a term without status
/// `answered`. The error has the line of an answer from a table.
base::Result<AnsweredRules> rulesFromAnswers(std::span<const study::Answer> answers, const study::Form& form,
                                             std::span<const std::string> output_terms);

/// A rule given directly, with its weight. The model to which it is added checks its names.
fuzzy::Rule ruleFrom(const study::GivenRule& given);

struct ExpertRules {
  enum class Source { kAnswers, kGiven };

  study::Participant participant;
  Source source = Source::kAnswers;
  std::vector<std::string> forms;     ///< ids of the forms or readings of the rules, in order of first use
  std::string depth_terms;            ///< id of the set of terms of the way
  bool depth_terms_inferred = false;  ///< derived from the regions in the rules, because they name no form
  std::vector<fuzzy::Rule> rules;
  std::vector<RuleOrigin> origins;   ///< one per rule
  std::vector<MissingItem> missing;  ///< items of those forms without a rule; empty for given rules
};

struct StudyRules {
  std::vector<ExpertRules> experts;  ///< participants with at least one rule, in the participants' order
  std::vector<std::string> notes;    ///< one sentence each
};

/// The rules of all experts. Given rules replace a participant's answers. The form of an expert decides the set of
/// depth terms. Given rules without a form get the set that contains their regions. Answers to a form that is not in
/// `forms` are skipped with a note that names their first line. `output_terms`: allowed ids of answers.
/// Returns the errors of rulesFromAnswers, and an error for: given rules that name an unknown form, forms of one expert
/// with different sets of depth terms, an unknown set, no rules at all.
base::Result<StudyRules> studyRules(const study::Study& study, std::span<const study::Form> forms,
                                    std::span<const std::string> output_terms);

// Checks the rules of an expert against the terms of the model, and for contradictions.

/// Checks the rules of `expert` against the terms for them. `origin`: the source of the rules. Returns an error with
/// the table line or rule number for: an unknown input or term, a weight outside [0, 1], a duplicate rule. Terms in
/// `absent_output_terms` have their own error.
base::Result<void> checkRules(const fuzzy::Expert& expert, const ExpertRules& origin,
                              std::span<const fuzzy::Variable> inputs, const fuzzy::Variable& output,
                              std::span<const std::string> absent_output_terms);

/// A sentence about rules with the conditions of an earlier rule and another consequent; nothing if there are none.
/// Both rules stay in the model.
std::optional<std::string> contradictionNote(const ExpertRules& expert);

}  // namespace tactus::elicitation
