#include "app/workbench/labs/experts/policy_table.h"

#include "app/workbench/base/display_text.h"

namespace tactus::workbench {
namespace {

using elicitation::WeightPolicy;

const QString kUnknown = QStringLiteral("–");

QString policyNewtons(double force_n) { return quantityText(force_n, "N", 3); }

QVariant policyAlignment(int column) {
  const bool number = column == PolicyTable::kLargest || column == PolicyTable::kRms;
  return static_cast<int>((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
}

}  // namespace

QString policyName(WeightPolicy policy) {
  switch (policy) {
    case WeightPolicy::kEqual:
      return PolicyTable::tr("Equal");
    case WeightPolicy::kYears:
      return PolicyTable::tr("By years of experience");
    case WeightPolicy::kCategory:
      return PolicyTable::tr("By category");
    case WeightPolicy::kColumn:
      return PolicyTable::tr("From the profiles");
    case WeightPolicy::kTable:
      return PolicyTable::tr("Own weights");
  }
  return {};
}

PolicyTable::PolicyTable(const ExpertsLab& lab, QObject* parent) : QAbstractTableModel(parent), lab_(lab) {}

void PolicyTable::follow() {
  beginResetModel();
  rows_ = lab_.compared();
  endResetModel();
}

int PolicyTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant PolicyTable::data(const QModelIndex& index, int role) const {
  const ComparedWeights& row = rows_[static_cast<std::size_t>(index.row())];
  if (role == Qt::TextAlignmentRole) return policyAlignment(index.column());
  if (role == Qt::ToolTipRole && !row.unavailable.isEmpty()) return row.unavailable;
  if (role == Qt::ToolTipRole && index.column() >= kWeights) return data(index, Qt::DisplayRole);
  if (role != Qt::DisplayRole) return {};
  if (index.column() == kPolicy) return policyName(row.policy);
  if (!row.unavailable.isEmpty()) return index.column() == kWeights ? tr("not in the data") : kUnknown;
  switch (index.column()) {
    case kWeights: {
      QStringList weights;
      for (const double weight : row.weights) weights << numberText(weight, 2);
      return weights.join(QStringLiteral(" · "));
    }
    case kLargest:
      return policyNewtons(row.from_equal.largest_n);
    case kRms:
      return policyNewtons(row.from_equal.rms_n);
    case kWhere:
      return row.where;
    default:
      return {};
  }
}

QVariant PolicyTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) return policyAlignment(section);
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kPolicy:
      return tr("Weights");
    case kWeights:
      return tr("Of the experts");
    case kLargest:
      return tr("From equal, at most");
    case kRms:
      return tr("rms");
    case kWhere:
      return tr("Where");
    default:
      return {};
  }
}

}  // namespace tactus::workbench
