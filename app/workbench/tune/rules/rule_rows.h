// The rules of the chosen expert in the words of the screen, one row each.
#pragma once

#include <vector>

#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/rules/rule_filter.h"

namespace tactus::workbench {

struct RuleRow {
  fuzzy::Rule rule;
  RuleWords words;
  bool conflict = false;  ///< another rule that counts (enabled, weight > 0) contradicts it
  double strength = 0;    ///< at the reading place

  bool operator==(const RuleRow& other) const = default;
};

/// All rows, in the order of the rules. A model must be open.
std::vector<RuleRow> ruleRows(const RuleController& rules);

/// Whether the rows have the same conditions: one rule, edited or not.
bool sameRule(const RuleRow& one, const RuleRow& other);

/// Whether rule `rule` is still the rule of `row`. A list may be older than the rules.
bool isStill(const RuleController& rules, std::size_t rule, const RuleRow& row);

}  // namespace tactus::workbench
