#include "app/workbench/labs/method/variant_table.h"

#include "app/workbench/base/display_text.h"
#include "app/workbench/labs/method/factor_table.h"
#include "elicitation/agreement/expert_influence.h"

namespace tactus::workbench {
namespace {

bool isNumber(int column) { return column > VariantTable::kValue && column < VariantTable::kWhere; }

}  // namespace

void VariantTable::setFactor(const elicitation::MethodStudy& study, const std::string& factor,
                             const fuzzy::ForceModel& model) {
  beginResetModel();
  rows_.clear();
  for (std::size_t i = 0; i < study.variants.size(); ++i) {
    const auto& one = study.variants[i];
    if (one.factor != factor) continue;
    rows_.push_back({i, one, one.at.empty() ? QString() : text(elicitation::pointText(model, one.at))});
  }
  endResetModel();
}

void VariantTable::clear() {
  beginResetModel();
  rows_.clear();
  endResetModel();
}

int VariantTable::rowOf(std::size_t variant) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i].index == variant) return static_cast<int>(i);
  }
  return -1;
}

int VariantTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant VariantTable::data(const QModelIndex& index, int role) const {
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  const auto& one = row.variant;
  if (role == Qt::TextAlignmentRole) {
    return static_cast<int>((isNumber(index.column()) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }
  if (role == Qt::ToolTipRole && !one.unavailable.empty()) return text(one.unavailable);
  if (role == Qt::ToolTipRole && index.column() == kWhere) return row.where;
  if (role != Qt::DisplayRole) return {};
  if (index.column() == kValue) return text(one.value);
  if (!one.unavailable.empty()) return index.column() == kWhere ? text(one.unavailable) : QStringLiteral("–");
  switch (index.column()) {
    case kRms:
      return quantityText(one.rms_n, "N", 3);
    case kNoticeable:
      return numberText(one.rms_noticeable, 2);
    case kFelt:
      return feltText(one.noticeable_share);
    case kLargest:
      return quantityText(one.largest_n, "N", 3);
    case kWhere:
      return row.where;
    default:
      return {};
  }
}

QVariant VariantTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) {
    return static_cast<int>((isNumber(section) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kValue:
      return tr("Instead");
    case kRms:
      return tr("rms");
    case kNoticeable:
      return tr("JND");
    case kFelt:
      return tr("Felt at");
    case kLargest:
      return tr("At most");
    case kWhere:
      return tr("Where");
    default:
      return {};
  }
}

}  // namespace tactus::workbench
