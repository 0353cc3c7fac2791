#include "app/workbench/tune/rules/rule_list_sieve.h"

#include "app/workbench/tune/rules/rule_list_model.h"

namespace tactus::workbench {

RuleListSieve::RuleListSieve(RuleListModel& list, QObject* parent) : QSortFilterProxyModel(parent), list_(list) {
  setSourceModel(&list_);
  setSortRole(RuleListModel::kSort);
  setSortLocaleAware(true);
  setSortCaseSensitivity(Qt::CaseInsensitive);
}

void RuleListSieve::setText(const QString& typed) {
  filter_ = RuleFilter(typed);
  invalidateFilter();
}

void RuleListSieve::setOnly(Only only) {
  only_ = only;
  invalidateFilter();
}

bool RuleListSieve::filterAcceptsRow(int row, const QModelIndex& /*parent*/) const {
  const QModelIndex index = list_.index(row, 0);
  switch (only_) {
    case Only::kAll:
      break;
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

}  // namespace tactus::workbench
