#include "app/workbench/tune/rules/rule_rows.h"

#include <QCoreApplication>

#include "app/editing/edit_text.h"
#include "app/editing/rule_edits.h"
#include "app/workbench/base/display_text.h"

namespace tactus::workbench {
namespace {

struct RuleRowText {
  Q_DECLARE_TR_FUNCTIONS(RuleRowText)
};

}  // namespace

std::vector<RuleRow> ruleRows(const RuleController& rules) {
  std::vector<RuleRow> out;
  const fuzzy::Expert& expert = rules.expert();
  for (const fuzzy::Rule& rule : expert.rules) {
    RuleRow row;
    row.rule = rule;
    for (const fuzzy::Condition& condition : rule.conditions) {
      const fuzzy::Variable& input = rules.input(condition.input);
      const fuzzy::Term* const term = fuzzy::findTerm(fuzzy::termsFor(expert, input), condition.term);
      row.words.conditions
          << RuleRowText::tr("%1 is %2").arg(labelOf(input), term ? labelOf(*term) : text(condition.term));
    }
    row.words.consequent = text(editing::consequentText(rules.model(), expert, rule.then));
    row.strength = rules.strength(out.size());
    out.push_back(std::move(row));
  }
  for (const std::size_t r : editing::conflictingRules(expert)) out[r].conflict = true;
  return out;
}

bool sameRule(const RuleRow& one, const RuleRow& other) { return editing::sameConditions(one.rule, other.rule); }

bool isStill(const RuleController& rules, std::size_t rule, const RuleRow& row) {
  return rule < rules.expert().rules.size() && editing::sameConditions(rules.expert().rules[rule], row.rule);
}

}  // namespace tactus::workbench
