#include "app/workbench/labs/experts/policy_table.h"

#include "app/workbench/base/display_text.h"

namespace tactus::workbench {
namespace {

using elicitation::WeightPolicy;

const QString kUnknown = QStringLiteral("–");

QString policyNewtons(double force_n) { return quantityText(force_n, "N", 3); }

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

PolicyTable::PolicyTable(const ExpertsLab& lab, QObject* parent)
    : LabTableModel({{tr("Weights")},
                     {tr("Of the experts")},
                     {tr("From equal, at most"), Qt::AlignRight},
                     {tr("rms"), Qt::AlignRight},
                     {tr("Where")}},
                    parent),
      lab_(lab) {}

void PolicyTable::follow() {
  beginResetModel();
  rows_ = lab_.compared();
  endResetModel();
}

int PolicyTable::rows() const { return static_cast<int>(rows_.size()); }

QVariant PolicyTable::cell(int row, int column, int role) const {
  const ComparedWeights& at = rows_[static_cast<std::size_t>(row)];
  if (role == Qt::ToolTipRole && !at.unavailable.isEmpty()) return at.unavailable;
  if (role == Qt::ToolTipRole && column >= kWeights) return cell(row, column, Qt::DisplayRole);
  if (role != Qt::DisplayRole) return {};
  if (column == kPolicy) return policyName(at.policy);
  if (!at.unavailable.isEmpty()) return column == kWeights ? tr("not in the data") : kUnknown;
  switch (column) {
    case kWeights: {
      QStringList weights;
      for (const double weight : at.weights) weights << numberText(weight, 2);
      return weights.join(QStringLiteral(" · "));
    }
    case kLargest:
      return policyNewtons(at.from_equal.largest_n);
    case kRms:
      return policyNewtons(at.from_equal.rms_n);
    case kWhere:
      return at.where;
    default:
      return {};
  }
}

}  // namespace tactus::workbench
