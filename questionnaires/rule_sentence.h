// Parses a rule written as a sentence: "IF Speed IS Slow AND Tube Tip Position IS in Nasopharynx THEN Force IS Medium".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/study/records.h"
#include "questionnaires/aliases.h"

namespace tactus::questionnaires {

struct RuleSentence {
  std::vector<study::ItemCondition> conditions;  ///< ids, in the alias table's order of inputs
  std::string then;                              ///< id of the output's term; empty if the sentence asks for it
};

/// Parses `text`: IF, one or more `input IS [in] term` joined by AND, THEN, `output IS [term]`. Ignores commas, a final
/// colon and case. The meaning of a rule comes from its words only, not from its number or position, because the tables
/// of the paper use different orders. Returns an error for: another form, a word that `aliases` lacks, two conditions
/// on one input. Errors have no file; their place is the sentence.
base::Result<RuleSentence> parseRuleSentence(std::string_view text, const AliasTable& aliases);

}  // namespace tactus::questionnaires
