// The rules of the chosen expert as a table, one row each.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "app/workbench/tune/rules/rule_rows.h"

namespace tactus::workbench {

class RuleListModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kNumber, kConditions, kConsequent, kWeight, kEnabled, kStrength, kColumns };
  enum Role {
    kSort = Qt::UserRole,  ///< a number or text, the sort key of the column
    kConflict,             ///< bool
    kActs,                 ///< strength at the reading place, in [0, 1]
    kIsEnabled,            ///< bool
    kWord,                 ///< index of the consequent among the words
    kLines,                ///< the conditions, each on a line of its own
  };

  explicit RuleListModel(RuleController& rules, QObject* parent = nullptr);

  /// Takes the current rules. A row whose rule is the same stays the same row.
  void refresh();
  /// Takes the strengths at the reading place.
  void refreshStrengths();
  const RuleWords& wordsOf(int row) const { return rows_[static_cast<std::size_t>(row)].words; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 private:
  QVariant shown(const RuleRow& row, int number, int column) const;
  QVariant order(const RuleRow& row, int number, int column) const;
  std::vector<std::size_t> editedWith(std::size_t rule) const;
  QString sentence(const RuleRow& row, int number) const;

  RuleController& rules_;
  std::vector<RuleRow> rows_;
};

}  // namespace tactus::workbench
