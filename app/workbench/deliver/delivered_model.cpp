#include "app/workbench/deliver/delivered_model.h"

#include <utility>

namespace tactus::workbench {

QString errorText(double newtons) { return DeliveredModel::tr("%1 N").arg(QString::number(newtons, 'g', 2)); }

QString centroidText(const QString& rule) {
  const QString count = rule.section(QLatin1Char(':'), 1);
  if (rule.startsWith(QLatin1String("midpoint:"))) return DeliveredModel::tr("middles of %1 cells").arg(count);
  if (rule.startsWith(QLatin1String("linspace:"))) return DeliveredModel::tr("%1 points").arg(count);
  if (rule == QLatin1String("table")) return DeliveredModel::tr("linear between nodes");
  return rule == QLatin1String("exact") ? DeliveredModel::tr("exact") : rule;
}

void DeliveredModel::setFiles(std::vector<DeliveredFile> files) {
  beginResetModel();
  files_ = std::move(files);
  endResetModel();
}

int DeliveredModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(files_.size());
}

int DeliveredModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant DeliveredModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const DeliveredFile& file = files_[static_cast<std::size_t>(index.row())];
  if (role == Qt::ToolTipRole) return file.ok ? file.path : file.wrong;
  if (role == Qt::TextAlignmentRole && (index.column() == kError || index.column() == kTolerance))
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case kFile:
      return file.path;
    case kError:
      return file.error_n ? errorText(*file.error_n) : QString();
    case kTolerance:
      return file.error_n ? errorText(file.tolerance_n) : QString();
    case kCentroid:
      return file.ok ? centroidText(file.rule) : tr("not as promised");
    default:
      return {};
  }
}

QVariant DeliveredModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) {
    return QVariant((section == kError || section == kTolerance ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kFile:
      return tr("File");
    case kError:
      return tr("Largest error");
    case kTolerance:
      return tr("Tolerance");
    case kCentroid:
      return tr("Centroid");
    default:
      return {};
  }
}

}  // namespace tactus::workbench
