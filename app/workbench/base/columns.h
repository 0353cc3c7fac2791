// A table for the screen as a list of its columns: what each head says, and what a cell has of its row.
// Example: Columns<Vote> votes({{tr("Force"), [](const Vote& one) { return one.force; }, Qt::AlignRight}});
#pragma once

#include <QAbstractTableModel>
#include <algorithm>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace tactus::workbench {

inline constexpr int kOrderRole = Qt::UserRole;  ///< what a column is sorted by

/// What a cell has of its row for one role.
template <class Row>
using CellOf = std::function<QVariant(const Row&)>;

template <class Row>
struct Column {
  using Roles = std::map<int, CellOf<Row>>;
  using Edit = std::function<bool(const Row&, const QVariant&)>;

  Column(QString title, CellOf<Row> cell, Qt::Alignment at = Qt::AlignLeft, QString tip = {}, Roles further = {},
         Edit take = {})
      : head(std::move(title)),
        text(std::move(cell)),
        side(at),
        head_tip(std::move(tip)),
        roles(std::move(further)),
        edit(std::move(take)) {}

  QString head;
  CellOf<Row> text;
  Qt::Alignment side;  ///< of the head and the cells; numbers stand at the right; none: the style's
  QString head_tip;
  Roles roles;  ///< what else a cell has: Qt::ToolTipRole, Qt::DecorationRole, …
  Edit edit;    ///< takes what the user typed or, with a Qt::CheckStateRole, checked; returns whether it is taken
};

/// `columns`, of which those without `role` have `cell` for it; without `cell`, their text.
template <class Row>
std::vector<Column<Row>> withRole(std::vector<Column<Row>> columns, int role, const CellOf<Row>& cell = {}) {
  for (Column<Row>& column : columns) column.roles.try_emplace(role, cell ? cell : column.text);
  return columns;
}

/// Has no signals of its own, so that it can be a template.
template <class Row>
class Columns : public QAbstractTableModel {
 public:
  explicit Columns(QObject* parent = nullptr) : QAbstractTableModel(parent) {}
  explicit Columns(std::vector<Column<Row>> columns, QObject* parent = nullptr)
      : QAbstractTableModel(parent), columns_(std::move(columns)) {}

  const std::vector<Row>& rows() const { return rows_; }
  const Row& row(int index) const { return rows_[static_cast<std::size_t>(index)]; }

  void setRows(std::vector<Row> rows) {
    beginResetModel();
    rows_ = std::move(rows);
    endResetModel();
  }
  /// For columns that follow from the data.
  void setTable(std::vector<Column<Row>> columns, std::vector<Row> rows) {
    beginResetModel();
    columns_ = std::move(columns);
    rows_ = std::move(rows);
    endResetModel();
  }
  /// As many rows as before stay the same rows: the selection and the editor in a cell stay.
  void updateRows(std::vector<Row> rows) {
    if (rows.empty() || rows.size() != rows_.size()) return setRows(std::move(rows));
    rows_ = std::move(rows);
    emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
  }
  /// Rows that are the `same` at the beginning and at the end stay the same rows; what is between them is new.
  template <class Same>
  void updateRows(std::vector<Row> next, Same same) {
    std::size_t begin = 0;
    while (begin < rows_.size() && begin < next.size() && same(rows_[begin], next[begin])) ++begin;
    std::size_t end = 0;
    while (end < rows_.size() - begin && end < next.size() - begin &&
           same(rows_[rows_.size() - 1 - end], next[next.size() - 1 - end])) {
      ++end;
    }
    const auto at = [](std::vector<Row>& rows, std::size_t i) { return rows.begin() + static_cast<std::ptrdiff_t>(i); };
    if (rows_.size() - end > begin) {
      beginRemoveRows({}, static_cast<int>(begin), static_cast<int>(rows_.size() - end) - 1);
      rows_.erase(at(rows_, begin), at(rows_, rows_.size() - end));
      endRemoveRows();
    }
    if (next.size() - end > begin) {
      beginInsertRows({}, static_cast<int>(begin), static_cast<int>(next.size() - end) - 1);
      rows_.insert(at(rows_, begin), at(next, begin), at(next, next.size() - end));
      endInsertRows();
    }
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      if (!(rows_[r] == next[r])) setRow(static_cast<int>(r), std::move(next[r]));
    }
  }
  /// The same row with other contents; with `column`, only in that one.
  void setRow(int index, Row now, int column = -1) {
    rows_[static_cast<std::size_t>(index)] = std::move(now);
    const int first = std::max(0, column);
    emit dataChanged(this->index(index, first), this->index(index, column < 0 ? columnCount() - 1 : first));
  }
  /// What the functions of `column` read beside the rows has changed.
  void updateColumn(int column) {
    if (!rows_.empty()) emit dataChanged(index(0, column), index(rowCount() - 1, column));
  }
  /// The heads at the left.
  void setRowHeads(CellOf<Row> head) { row_head_ = std::move(head); }

  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
  }
  int columnCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(columns_.size());
  }
  QVariant data(const QModelIndex& index, int role) const override {
    if (!index.isValid()) return {};
    const Column<Row>& column = at(index.column());
    if (role == Qt::TextAlignmentRole) return sideOf(column);
    const auto found = column.roles.find(role);
    if (found != column.roles.end()) return found->second(row(index.row()));
    return role == Qt::DisplayRole ? column.text(row(index.row())) : QVariant();
  }
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
    // A sorted table asks for column -1 if it has no rows to find the column by.
    if (section < 0 || section >= (orientation == Qt::Horizontal ? columnCount() : rowCount())) return {};
    if (orientation == Qt::Vertical) {
      return role == Qt::DisplayRole && row_head_ ? row_head_(row(section)) : QVariant();
    }
    const Column<Row>& column = at(section);
    if (role == Qt::TextAlignmentRole) return sideOf(column);
    if (role == Qt::ToolTipRole && !column.head_tip.isEmpty()) return column.head_tip;
    return role == Qt::DisplayRole ? QVariant(column.head) : QVariant();
  }
  Qt::ItemFlags flags(const QModelIndex& index) const override {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (!index.isValid() || !at(index.column()).edit) return flags;
    return flags | (isChecked(at(index.column())) ? Qt::ItemIsUserCheckable : Qt::ItemIsEditable);
  }
  bool setData(const QModelIndex& index, const QVariant& value, int role) override {
    if (!index.isValid()) return false;
    const Column<Row>& column = at(index.column());
    return column.edit && role == (isChecked(column) ? Qt::CheckStateRole : Qt::EditRole) &&
           column.edit(row(index.row()), value);
  }

 private:
  const Column<Row>& at(int column) const { return columns_[static_cast<std::size_t>(column)]; }
  static bool isChecked(const Column<Row>& column) { return column.roles.contains(Qt::CheckStateRole); }
  static QVariant sideOf(const Column<Row>& column) {
    return column.side == Qt::Alignment() ? QVariant() : static_cast<int>(column.side | Qt::AlignVCenter);
  }

  std::vector<Column<Row>> columns_;
  std::vector<Row> rows_;
  CellOf<Row> row_head_;
};

}  // namespace tactus::workbench
