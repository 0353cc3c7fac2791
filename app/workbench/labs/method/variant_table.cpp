#include "app/workbench/labs/method/variant_table.h"

#include "app/workbench/base/display_text.h"
#include "app/workbench/labs/method/factor_table.h"
#include "elicitation/agreement/expert_influence.h"

namespace tactus::workbench {
VariantTable::VariantTable(QObject* parent)
    : LabTableModel({{tr("Instead")},
                     {tr("rms"), Qt::AlignRight},
                     {tr("JND"), Qt::AlignRight},
                     {tr("Felt at"), Qt::AlignRight},
                     {tr("At most"), Qt::AlignRight},
                     {tr("Where")}},
                    parent) {}

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

int VariantTable::rows() const { return static_cast<int>(rows_.size()); }

QVariant VariantTable::cell(int row, int column, int role) const {
  const Row& at = rows_[static_cast<std::size_t>(row)];
  const auto& one = at.variant;
  if (role == Qt::ToolTipRole && !one.unavailable.empty()) return text(one.unavailable);
  if (role == Qt::ToolTipRole && column == kWhere) return at.where;
  if (role != Qt::DisplayRole) return {};
  if (column == kValue) return text(one.value);
  if (!one.unavailable.empty()) return column == kWhere ? text(one.unavailable) : QStringLiteral("–");
  switch (column) {
    case kRms:
      return quantityText(one.rms_n, "N", 3);
    case kNoticeable:
      return numberText(one.rms_noticeable, 2);
    case kFelt:
      return feltText(one.noticeable_share);
    case kLargest:
      return quantityText(one.largest_n, "N", 3);
    case kWhere:
      return at.where;
    default:
      return {};
  }
}

}  // namespace tactus::workbench
