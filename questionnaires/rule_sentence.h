// Reads a rule written as a sentence: "IF Speed IS Slow AND Tube Tip Position IS in Nasopharynx THEN Force IS Medium".
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
  std::string then;                              ///< id of the output's term; empty where the sentence asks for it
};

/// Reads `text`: IF, one or more `input IS [in] term` joined by AND, THEN, `output IS [term]`. Commas and a final colon
/// are passed over, case makes no difference. What a rule says comes from its words alone, never from its number or
/// place: the tables of the paper list their rules in different orders. Refused: another form, a word that `aliases`
/// does not know, two conditions on one input. Errors carry no file; their place is the sentence.
base::Result<RuleSentence> parseRuleSentence(std::string_view text, const AliasTable& aliases);

}  // namespace tactus::questionnaires
