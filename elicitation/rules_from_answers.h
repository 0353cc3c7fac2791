// From what an expert said to rules (paper, Section 3.4, Tables A1 and A2).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"

namespace tactus::elicitation {

/// Rules and, one for each, the line of the answer or given rule that it comes from.
struct SourcedRules {
  std::vector<fuzzy::Rule> rules;
  std::vector<study::TableLine> lines;
};

/// The rules of one participant's answers to `form`, in the order of the form's items, weight 1: IF the item's
/// conditions THEN the output is the answer. An item without an answer (not there, skipped, cannot tell, cleared) is an
/// absent rule. Refused: an item number that the form does not have, an item answered twice, an answer that is not in
/// `output_terms`; an answer from a table is named by its line.
base::Result<SourcedRules> rulesFromAnswers(std::span<const study::Answer> answers, const study::Form& form,
                                            std::span<const std::string> output_terms);

/// A rule given directly, with its weight. Whether its names exist is for the model that it joins.
fuzzy::Rule ruleFrom(const study::GivenRule& given);

}  // namespace tactus::elicitation
