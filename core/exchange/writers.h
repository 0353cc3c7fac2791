// The writers behind `format` (dialect.h). Nothing outside this folder includes this.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/exchange/expert_view.h"

namespace tactus::exchange {

std::string fllText(const ExpertView& view);
base::Result<std::string> fclIecText(const ExpertView& view);
std::string fclFuzzyliteText(const ExpertView& view);
std::string fisText(const ExpertView& view);
std::string fmlText(const ExpertView& view);

/// `lubrication is well and depth is stomach`, with the words of the dialect.
struct RuleWords {
  std::string_view condition_is;  ///< ` is `
  std::string_view join;          ///< ` and `
};
std::string conditionsText(const ExpertView& view, const IndexedRule& rule, const RuleWords& words);

/// A term as fuzzylite writes it: `Trapezoid 0 0 0.2 0.4`.
std::string fuzzyliteShape(const fuzzy::Term& term);

/// What no other format has, a line each: `not in this file: puncture, vein wall, 60 % of the force is lost`.
std::vector<std::string> missingEvents(const fuzzy::ForceModel& model);

/// `lines` of people's text, each behind `mark`: name, expert, origin, what the format cannot say.
std::string remarks(const ExpertView& view, std::string_view mark);

}  // namespace tactus::exchange
