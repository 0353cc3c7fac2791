// The rules of the chosen expert in the words of the screen, one row each.
#pragma once

#include <vector>

#include "app/workbench/tune/rules/rule_controller.h"
#include "app/workbench/tune/rules/rule_filter.h"

namespace tactus::workbench {

struct RuleRow {
  fuzzy::Rule rule;
  RuleWords words;
  bool conflict = false;  ///< another rule that counts contradicts it
  double strength = 0;    ///< at the place that is read

  bool operator==(const RuleRow& other) const = default;
};

/// All rows, in the order of the rules. A model must be open.
std::vector<RuleRow> ruleRows(const RuleController& rules);

/// Whether the rows are about the same conditions: one rule, edited or not.
bool sameRule(const RuleRow& one, const RuleRow& other);

/// Whether rule number `rule` is still the one of `row`: a list may be a moment older than the rules.
bool isStill(const RuleController& rules, std::size_t rule, const RuleRow& row);

}  // namespace tactus::workbench
