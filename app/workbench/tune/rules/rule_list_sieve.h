// Filters and sorts the list of rules as the user chose.
#pragma once

#include <QSortFilterProxyModel>

#include "app/workbench/tune/rules/rule_filter.h"

namespace tactus::workbench {

class RuleListModel;

class RuleListSieve : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  enum class Only { kAll, kActing, kDisabled, kConflicts };

  explicit RuleListSieve(RuleListModel& list, QObject* parent = nullptr);

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
