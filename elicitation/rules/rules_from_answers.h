// From what an expert said to rules (paper, Section 3.4, Tables A1 and A2).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"

namespace tactus::elicitation {

/// Where a rule, or the absence of one, comes from.
struct RuleOrigin {
  std::string form;            ///< of an answer; for a given rule the form or reading that it names, may be empty
  int item = 0;                ///< the form's item number; 0 for a given rule
  study::TableLine line = {};  ///< of answers.csv, or of rules.csv for a given rule
};

/// An item that gives no rule.
struct MissingItem {
  enum class Reason { kNoAnswer, kSkipped, kCantTell, kCleared };

  RuleOrigin origin;
  Reason reason = Reason::kNoAnswer;
  std::vector<fuzzy::Condition> conditions;  ///< of the rule that is absent
};

/// `no answer`, `skipped`, `cannot tell`, `cleared`.
std::string_view name(MissingItem::Reason reason) noexcept;

/// The rules of a form: every item is in one of the two, in the order of the form.
struct AnsweredRules {
  std::vector<fuzzy::Rule> rules;
  std::vector<RuleOrigin> origins;  ///< one for each rule
  std::vector<MissingItem> missing;
};

/// The rules of one participant's answers to `form`, in the order of the form's items, weight 1: IF the item's
/// conditions THEN the output is the answer. An item without an answer (not there, skipped, cannot tell, cleared) is an
/// absent rule. Refused: an answer to another form, an item number that the form does not have, an item twice (a record
/// holds what a participant said last; the history of corrections is not part of it), an answer that is not in
/// `output_terms`, a term without an answer; an answer from a table is named by its line.
base::Result<AnsweredRules> rulesFromAnswers(std::span<const study::Answer> answers, const study::Form& form,
                                             std::span<const std::string> output_terms);

/// A rule given directly, with its weight. Whether its names exist is for the model that it joins.
fuzzy::Rule ruleFrom(const study::GivenRule& given);

}  // namespace tactus::elicitation
