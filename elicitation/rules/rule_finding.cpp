#include "elicitation/rules/rule_finding.h"

#include <algorithm>

#include "core/base/text.h"

namespace tactus::elicitation {
namespace {

using Source = RuleFinding::Source;

// More than the items of one region; the complete list is in the finding.
constexpr std::size_t kMostListed = 12;

/// `item 3`, `items 3, 8`, `items 3, 8, … and 20 more`.
std::string counted(const std::string& word, const std::vector<std::string>& numbers) {
  const std::size_t listed = std::min(numbers.size(), kMostListed);
  std::string text = word + (numbers.size() > 1 ? "s " : " ");
  text += base::joined(std::vector<std::string>(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(listed)),
                       ", ");
  if (numbers.size() > listed) text += " and " + std::to_string(numbers.size() - listed) + " more";
  return text;
}

}  // namespace

std::string_view name(RuleFinding::Kind kind) noexcept {
  using Kind = RuleFinding::Kind;
  switch (kind) {
    case Kind::kHole:
      return "hole";
    case Kind::kAbstentionJump:
      return "abstention_jump";
    case Kind::kForceStep:
      return "force_step";
    case Kind::kRegionWithoutRule:
      return "region_without_rule";
    case Kind::kMissingItem:
      return "missing_item";
    case Kind::kConflict:
      return "conflict";
    case Kind::kExpertsApart:
      return "experts_apart";
    case Kind::kAgainstDeclaration:
      return "against_declaration";
    case Kind::kLevelJump:
      return "level_jump";
    case Kind::kDirectionChange:
      return "direction_change";
    case Kind::kDisagreement:
      return "disagreement";
    case Kind::kRedundantRule:
      return "redundant_rule";
    case Kind::kUnreachableRule:
      return "unreachable_rule";
    case Kind::kUnreachableTerm:
      return "unreachable_term";
    case Kind::kUnusedTerm:
      return "unused_term";
  }
  return "";
}

std::string describe(const std::vector<Source>& sources) {
  if (sources.empty()) return {};
  const bool items = sources.front().origin.item > 0;
  std::vector<std::string> numbers;
  std::vector<std::string> lines;
  for (const auto& source : sources) {
    numbers.push_back(std::to_string(items ? source.origin.item : static_cast<int>(source.rule.value_or(0)) + 1));
    if (source.origin.line.number > 0) lines.push_back(std::to_string(source.origin.line.number));
  }
  std::string text = counted(items ? "item" : "rule", numbers);
  if (lines.empty()) return text;
  return text + " (" + std::string(items ? study::kAnswersTable : study::kRulesTable) + ", " + counted("line", lines) +
         ")";
}

}  // namespace tactus::elicitation
