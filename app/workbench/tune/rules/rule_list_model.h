// The rules of the chosen expert as a table, one row each.
#pragma once

#include <functional>
#include <vector>

#include "app/workbench/base/columns.h"
#include "app/workbench/tune/rules/rule_rows.h"

namespace tactus::workbench {

class RuleListModel : public Columns<RuleRow> {
  Q_OBJECT

 public:
  enum { kNumber, kConditions, kConsequent, kWeight, kEnabled, kStrength, kColumns };
  enum Role {
    kSort = kOrderRole,  ///< a number or text, the sort key of the column
    kConflict,           ///< bool
    kActs,               ///< strength at the reading place, in [0, 1]
    kIsEnabled,          ///< bool
    kWord,               ///< index of the consequent among the words
    kLines,              ///< the conditions, each on a line of its own
  };

  explicit RuleListModel(RuleController& rules, QObject* parent = nullptr);

  /// Takes the current rules. A row whose rule is the same stays the same row.
  void refresh();
  /// Takes the strengths at the reading place.
  void refreshStrengths();
  const RuleWords& wordsOf(int index) const { return row(index).words; }

 private:
  std::vector<Column<RuleRow>> makeColumns();
  QVariant wordOf(const RuleRow& row) const;
  QString sentence(const RuleRow& row) const;
  /// Lets `change` edit the rule of a row, and with it all selected rules; it returns whether it takes the value.
  Column<RuleRow>::Edit edited(std::function<bool(const std::vector<std::size_t>& all, const QVariant& value)> change);

  RuleController& rules_;
};

}  // namespace tactus::workbench
