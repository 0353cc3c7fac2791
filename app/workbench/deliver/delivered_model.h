// The files of a bundle as a table: what each promises, and what was found.
#pragma once

#include <QAbstractTableModel>
#include <QString>
#include <optional>
#include <vector>

namespace tactus::workbench {

struct DeliveredFile {
  QString path;
  QString rule;                   ///< `exact`, `midpoint:1000`, …; empty for a file without forces
  std::optional<double> error_n;  ///< the largest found; nothing for a file without forces
  double tolerance_n = 0;
  bool ok = true;
  QString wrong;  ///< one sentence where `ok` is false
};

class DeliveredModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kFile, kError, kTolerance, kCentroid, kColumns };

  using QAbstractTableModel::QAbstractTableModel;

  void setFiles(std::vector<DeliveredFile> files);
  const DeliveredFile& file(int row) const { return files_[static_cast<std::size_t>(row)]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<DeliveredFile> files_;
};

/// An error in newtons with two digits: `0.0025 N`, `1.1e-12 N`, `0 N`.
QString errorText(double newtons);

/// How a reader of the file computes the centroid: `exact`, `1000 middles`, `101 points`, `grid, linear between`.
QString centroidText(const QString& rule);

}  // namespace tactus::workbench
