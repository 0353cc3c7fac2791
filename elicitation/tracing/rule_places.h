// Which rule of a built model an answer or a given rule of the study became.
#pragma once

#include <cstddef>
#include <optional>

#include "core/study/records.h"
#include "elicitation/model/model_builder.h"

namespace tactus::elicitation {

/// A rule of a model: the number of its expert, and its number among the expert's rules.
struct RulePlace {
  std::size_t expert = 0;
  std::size_t rule = 0;

  bool operator==(const RulePlace&) const = default;
};

/// The rule that answer `index` of `study` became. Nothing for an answer without a word, and for one that rules given
/// directly replace. `built`: from `study`.
std::optional<RulePlace> ruleOfAnswer(const study::Study& study, const BuiltModel& built, std::size_t index);

/// The same for the rule `index` of Study::rules.
std::optional<RulePlace> ruleOfGiven(const study::Study& study, const BuiltModel& built, std::size_t index);

}  // namespace tactus::elicitation
