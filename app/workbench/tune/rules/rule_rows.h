// The rules of the chosen expert in the words of the screen, one row each.
#pragma once

#include <QSortFilterProxyModel>
#include <QString>
#include <QStringList>
#include <vector>

#include "app/workbench/tune/rules/rule_controller.h"

namespace tactus::workbench {

// The filter of the rule list, by the words of a rule.

/// A rule in the words of the screen.
struct RuleWords {
  QStringList conditions;  ///< `Tube lubrication is Well`, one each
  QString consequent;      ///< `Very large`

  bool operator==(const RuleWords&) const = default;
};

/// The user's text: `well esoph`, `if well and stomach then small`. Upper and lower case are equal.
class RuleFilter {
 public:
  RuleFilter() = default;
  explicit RuleFilter(const QString& typed);

  /// Whether the rule passes. Each part between `and` must be found in one condition; the part after `then`, in the
  /// consequent. Without `then` a part may be in the consequent, too. Without any of these words each word is a part.
  /// An empty filter passes every rule.
  bool takes(const RuleWords& rule) const;

 private:
  std::vector<QStringList> parts_;  ///< the words of each part
  QStringList then_;
  bool has_then_ = false;
};

struct RuleRow {
  std::size_t number = 0;  ///< of the rule, from 0
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

// Filters and sorts the list of rules as the user chose.

class RuleListModel;

class RuleListFilter : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  enum class Only { kAll, kActing, kDisabled, kConflicts };

  explicit RuleListFilter(RuleListModel& list, QObject* parent = nullptr);

  void setText(const QString& typed);
  void setOnly(Only only);

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  RuleListModel& list_;
  RuleFilter filter_;
  Only only_ = Only::kAll;
};

}  // namespace tactus::workbench
