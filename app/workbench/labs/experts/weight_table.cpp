#include "app/workbench/labs/experts/weight_table.h"

#include "app/figures/colors.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

const QString kAbsent = QStringLiteral("–");
constexpr int kForceDigits = 3;

QString newtons(double force_n) { return quantityText(force_n, "N", kForceDigits); }

QString leftOutTip() { return WeightTable::tr("How far the averaged force moves without this expert."); }

}  // namespace

WeightTable::WeightTable(ExpertsLab& lab, QObject* parent)
    : LabTableModel({{tr("Expert")},
                     {tr("Weight"), Qt::AlignRight, tr("Double-click a weight to change it.")},
                     {tr("Left out, rms"), Qt::AlignRight, leftOutTip()},
                     {tr("At most"), Qt::AlignRight, leftOutTip()},
                     {tr("JND"), Qt::AlignRight, tr("The largest change in just-noticeable differences.")},
                     {tr("Where"), Qt::AlignLeft, leftOutTip()}},
                    parent),
      lab_(lab) {}

void WeightTable::follow() {
  const bool same = built_ != nullptr && lab_.built() != nullptr &&
                    built_->model.experts.size() == lab_.built()->model.experts.size();
  if (!same) beginResetModel();
  built_ = lab_.built();
  numbers_ = built_ == nullptr ? std::vector<std::size_t>() : figures::expertNumbers(built_->model.experts);
  // The cell that is being edited stays while only numbers change.
  same ? emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1)) : endResetModel();
}

int WeightTable::rows() const { return built_ == nullptr ? 0 : static_cast<int>(built_->model.experts.size()); }

Qt::ItemFlags WeightTable::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  return index.column() == kWeight ? flags | Qt::ItemIsEditable : flags;
}

QVariant WeightTable::cell(int row, int column, int role) const {
  const auto expert = static_cast<std::size_t>(row);
  if (role == Qt::DecorationRole && column == kExpert) return theme::expert(numbers_[expert]);
  if (role == Qt::EditRole && column == kWeight) return numberText(built_->model.experts[expert].weight, 3);
  if (role == Qt::DisplayRole || role == Qt::ToolTipRole) return shown(expert, column);
  return {};
}

QString WeightTable::shown(std::size_t expert, int column) const {
  const fuzzy::Expert& one = built_->model.experts[expert];
  if (column == kExpert) return harmless(labelOf(one));
  if (column == kWeight) return numberText(one.weight, 3);
  const auto& influences = built_->influences.experts;
  if (expert >= influences.size()) return kAbsent;
  const elicitation::ExpertInfluence& influence = influences[expert];
  if (column == kRms) return newtons(influence.rms_n);
  if (!influence.largest) return kAbsent;
  if (column == kLargest) return newtons(influence.largest->newtons);
  if (column == kNoticeable) {
    return influence.most_noticeable ? numberText(influence.most_noticeable->noticeable, 1) : kAbsent;
  }
  return text(elicitation::pointText(built_->model, influence.largest->at));
}

bool WeightTable::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || index.column() != kWeight) return false;
  const auto weight = typedNumber(value.toString());
  if (!weight || *weight < 0) return false;
  lab_.setWeight(built_->model.experts[static_cast<std::size_t>(index.row())].id, *weight);
  return true;
}

}  // namespace tactus::workbench
