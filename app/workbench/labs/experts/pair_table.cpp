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
  if (built_ == lab_.built()) return;
  beginResetModel();
  built_ = lab_.built();
  endResetModel();
}

int PairTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || built_ == nullptr ? 0 : static_cast<int>(built_->model.experts.size());
}

const elicitation::ExpertDistance& PairTable::between(int first, int second) const {
  const auto row = static_cast<std::size_t>(std::min(first, second));
  const auto column = static_cast<std::size_t>(std::max(first, second));
  const std::size_t before = row * built_->model.experts.size() - row * (row + 1) / 2;  // the pairs of earlier rows
  return built_->influences.pairs[before + column - row - 1];
}

QVariant PairTable::data(const QModelIndex& index, int role) const {
  if (role == Qt::TextAlignmentRole) return static_cast<int>(Qt::AlignCenter);
  if (index.row() == index.column() || (role != Qt::DisplayRole && role != Qt::ToolTipRole)) return {};
  const elicitation::ExpertDistance& pair = between(index.row(), index.column());
  if (role == Qt::DisplayRole) return pairNewtons(pair.rms_n);
  if (!pair.largest) return {};
  return tr("At most %1: %2")
      .arg(pairNewtons(pair.largest->newtons), text(elicitation::pointText(built_->model, pair.largest->at)));
}

QVariant PairTable::headerData(int section, Qt::Orientation, int role) const {
  if (role != Qt::DisplayRole || section >= rowCount()) return {};
  return harmless(labelOf(built_->model.experts[static_cast<std::size_t>(section)]));
}

}  // namespace tactus::workbench
