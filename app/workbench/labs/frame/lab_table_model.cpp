#include "app/workbench/labs/frame/lab_table_model.h"

#include <utility>

namespace tactus::workbench {

LabTableModel::LabTableModel(std::vector<LabColumn> columns, QObject* parent)
    : QAbstractTableModel(parent), columns_(std::move(columns)) {}

int LabTableModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(columns_.size());
}

QVariant LabTableModel::data(const QModelIndex& index, int role) const {
  if (role != Qt::TextAlignmentRole) return cell(index.row(), index.column(), role);
  return static_cast<int>(columns_[static_cast<std::size_t>(index.column())].side | Qt::AlignVCenter);
}

QVariant LabTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  // A sorted table asks for column -1 if it has no rows to find the column by.
  if (orientation != Qt::Horizontal || section < 0 || section >= columnCount()) return {};
  const LabColumn& column = columns_[static_cast<std::size_t>(section)];
  if (role == Qt::DisplayRole) return column.title;
  if (role == Qt::TextAlignmentRole) return static_cast<int>(column.side | Qt::AlignVCenter);
  return role == Qt::ToolTipRole && !column.tip.isEmpty() ? QVariant(column.tip) : QVariant();
}

}  // namespace tactus::workbench
