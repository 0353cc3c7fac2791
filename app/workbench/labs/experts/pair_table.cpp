#include "app/workbench/labs/experts/pair_table.h"

#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "elicitation/agreement/expert_influence.h"

namespace tactus::workbench {
namespace {

QString pairNewtons(double force_n) { return quantityText(force_n, "N", 3); }

}  // namespace

PairTable::PairTable(const ExpertsLab& lab, QObject* parent) : QAbstractTableModel(parent), lab_(lab) {}

void PairTable::follow() {
  beginResetModel();
  built_ = lab_.built();
  endResetModel();
}

int PairTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || built_ == nullptr ? 0 : static_cast<int>(built_->model.experts.size());
}

const elicitation::ExpertDistance* PairTable::between(int first, int second) const {
  const auto& experts = built_->model.experts;
  const std::string& one = experts[static_cast<std::size_t>(std::min(first, second))].id;
  const std::string& other = experts[static_cast<std::size_t>(std::max(first, second))].id;
  for (const elicitation::ExpertDistance& pair : built_->influences.pairs) {
    if (pair.first == one && pair.second == other) return &pair;
  }
  return nullptr;
}

QVariant PairTable::data(const QModelIndex& index, int role) const {
  if (role == Qt::TextAlignmentRole) return static_cast<int>(Qt::AlignCenter);
  const auto* const pair = index.row() == index.column() ? nullptr : between(index.row(), index.column());
  if (role == Qt::DisplayRole) return pair == nullptr ? QString() : pairNewtons(pair->rms_n);
  if (role == Qt::ToolTipRole && pair != nullptr && pair->largest) {
    return tr("At most %1: %2")
        .arg(pairNewtons(pair->largest->newtons), text(elicitation::pointText(built_->model, pair->largest->at)));
  }
  return {};
}

QVariant PairTable::headerData(int section, Qt::Orientation, int role) const {
  if (role != Qt::DisplayRole || section >= rowCount()) return {};
  return harmless(labelOf(built_->model.experts[static_cast<std::size_t>(section)]));
}

}  // namespace tactus::workbench
