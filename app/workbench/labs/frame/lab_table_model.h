// The item model behind a table of the labs: each column has a title, a side and a tool tip.
#pragma once

#include <QAbstractTableModel>
#include <utility>
#include <vector>

namespace tactus::workbench {

struct LabColumn {
  QString title;
  Qt::AlignmentFlag side = Qt::AlignLeft;  ///< of the head and the cells; numbers stand at the right
  QString tip = {};                        ///< of the head
};

class LabTableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  explicit LabTableModel(std::vector<LabColumn> columns, QObject* parent = nullptr);
  /// For columns that follow from the data: none until `setColumns`.
  explicit LabTableModel(QObject* parent = nullptr) : LabTableModel({}, parent) {}

  int rowCount(const QModelIndex& parent = {}) const final { return parent.isValid() ? 0 : rows(); }
  int columnCount(const QModelIndex& parent = {}) const final;
  QVariant data(const QModelIndex& index, int role) const final;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const final;

 protected:
  virtual int rows() const = 0;
  /// What a cell has for `role`; never asked about the alignment.
  virtual QVariant cell(int row, int column, int role) const = 0;
  /// While the model is being reset.
  void setColumns(std::vector<LabColumn> columns) { columns_ = std::move(columns); }

 private:
  std::vector<LabColumn> columns_;
};

}  // namespace tactus::workbench
