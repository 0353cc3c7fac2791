// Converts an expert's answers to rules (paper, Section 3.4, Tables A1 and A2).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"

namespace tactus::elicitation {

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

}  // namespace tactus::elicitation
