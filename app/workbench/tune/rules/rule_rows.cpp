#include "app/workbench/tune/rules/rule_rows.h"

#include <QCoreApplication>
#include <algorithm>

#include "app/editing/edit.h"
#include "app/editing/rule_edits.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/tune/rules/rule_list_model.h"

namespace tactus::workbench {

RuleListFilter::RuleListFilter(RuleListModel& list, QObject* parent) : QSortFilterProxyModel(parent), list_(list) {
  setSourceModel(&list_);
  setSortRole(RuleListModel::kSort);
  setSortLocaleAware(true);
  setSortCaseSensitivity(Qt::CaseInsensitive);
}

void RuleListFilter::setText(const QString& typed) {
  filter_ = RuleFilter(typed);
  invalidateFilter();
}

void RuleListFilter::setOnly(Only only) {
  only_ = only;
  invalidateFilter();
}

bool RuleListFilter::filterAcceptsRow(int row, const QModelIndex& /*parent*/) const {
  const QModelIndex index = list_.index(row, 0);
  switch (only_) {
    case Only::kAll: break;
    case Only::kActing:
      if (index.data(RuleListModel::kActs).toDouble() <= 0) return false;
      break;
    case Only::kDisabled:
      if (index.data(RuleListModel::kIsEnabled).toBool()) return false;
      break;
    case Only::kConflicts:
      if (!index.data(RuleListModel::kConflict).toBool()) return false;
      break;
  }
  return filter_.takes(list_.wordsOf(row));
}

namespace {

bool holds(const QString& text, const QStringList& words) {
  return std::all_of(words.begin(), words.end(),
                     [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

}  // namespace

RuleFilter::RuleFilter(const QString& typed) {
  const QStringList words = typed.toLower().split(QLatin1Char(' '), Qt::SkipEmptyParts);
  const bool sentence = words.contains(QStringLiteral("if")) || words.contains(QStringLiteral("and")) ||
                        words.contains(QStringLiteral("then"));
  QStringList part;
  const auto end_part = [&] {
    if (!part.isEmpty()) parts_.push_back(part);
    part.clear();
  };
  for (const QString& word : words) {
    if (word == QLatin1String("if") || word == QLatin1String("is")) continue;
    if (word == QLatin1String("then")) {
      end_part();
      has_then_ = true;
    } else if (has_then_) {
      then_ << word;
    } else if (word == QLatin1String("and")) {
      end_part();
    } else {
      part << word;
      if (!sentence) end_part();
    }
  }
  end_part();
}

bool RuleFilter::takes(const RuleWords& rule) const {
  if (has_then_ && !holds(rule.consequent, then_)) return false;
  return std::all_of(parts_.begin(), parts_.end(), [&](const QStringList& part) {
    if (!has_then_ && holds(rule.consequent, part)) return true;
    return std::any_of(rule.conditions.begin(), rule.conditions.end(),
                       [&](const QString& condition) { return holds(condition, part); });
  });
}

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
    row.number = out.size();
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
