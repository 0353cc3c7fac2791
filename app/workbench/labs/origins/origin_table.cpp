#include "app/workbench/labs/origins/origin_table.h"

#include "app/workbench/base/display_text.h"

namespace tactus::workbench {

OriginTable::OriginTable(const OriginFinder& finder, QObject* parent) : QAbstractTableModel(parent), finder_(finder) {
  connect(&finder, &OriginFinder::changed, this, [this] {
    beginResetModel();
    endResetModel();
  });
  connect(&finder, &OriginFinder::influenceChanged, this, [this](std::size_t row) {
    const QModelIndex at = index(static_cast<int>(row), kMoves);
    emit dataChanged(at, at);
  });
}

int OriginTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || finder_.origin() == nullptr ? 0 : static_cast<int>(finder_.origin()->records.size());
}

QString OriginTable::movesText(std::size_t row) const {
  const OriginFinder::Influence& found = finder_.influence(row);
  if (!found) return row < OriginFinder::kMostUnasked ? QStringLiteral("…") : QStringLiteral("–");
  if (!*found) return tr("no model");
  return tr("%1 (%2 JND)")
      .arg(quantityText((*found)->difference.largest_n, "N", 3), numberText((*found)->noticeable, 1));
}

QVariant OriginTable::data(const QModelIndex& index, int role) const {
  const auto row = static_cast<std::size_t>(index.row());
  const OriginRecord& record = finder_.origin()->records[row];
  if (role == Qt::TextAlignmentRole) {
    return static_cast<int>((index.column() == kMoves ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }
  if (role == Qt::ToolTipRole) {
    const QString sentence = finder_.influenceSentence(row);
    return index.column() == kMoves && !sentence.isEmpty() ? QVariant(sentence) : QVariant();
  }
  if (role == kOrderRole && index.column() == kMoves) {
    const OriginFinder::Influence& found = finder_.influence(row);
    return found && *found ? (*found)->difference.largest_n : -1.0;
  }
  if (role == kOrderRole && index.column() == kRecord) return index.row();
  if (role != Qt::DisplayRole && role != kOrderRole) return {};
  switch (index.column()) {
    case kParticipant:
      return record.participant;
    case kRecord:
      return record.what;
    case kSays:
      return record.says;
    default:
      return movesText(row);
  }
}

QVariant OriginTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) {
    return static_cast<int>((section == kMoves ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }
  if (role == Qt::ToolTipRole && section == kMoves) {
    return tr("How far the averaged force moves without this record, at most, and in just-noticeable differences.");
  }
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kParticipant:
      return tr("Participant");
    case kRecord:
      return tr("Record");
    case kSays:
      return tr("Says");
    default:
      return tr("Moves the force");
  }
}

}  // namespace tactus::workbench
