#include "app/workbench/labs/origins/origin_table.h"

#include "app/workbench/labs/data/influence_text.h"

namespace tactus::workbench {

OriginTable::OriginTable(const OriginFinder& finder, QObject* parent)
    : LabTableModel({{tr("Participant")},
                     {tr("Record")},
                     {tr("Says")},
                     {tr("Moves the force"), Qt::AlignRight,
                      tr("How far the averaged force moves without this record, at most, and in just-noticeable "
                         "differences.")}},
                    parent),
      finder_(finder) {
  connect(&finder, &OriginFinder::changed, this, [this] {
    beginResetModel();
    origin_ = finder_.sharedOrigin();
    endResetModel();
  });
  connect(&finder, &OriginFinder::influenceChanged, this, [this](std::size_t row) {
    const QModelIndex at = index(static_cast<int>(row), kMoves);
    emit dataChanged(at, at);
  });
}

int OriginTable::rows() const { return origin_ == nullptr ? 0 : static_cast<int>(origin_->records.size()); }

QString OriginTable::movesText(std::size_t row) const {
  const OriginFinder::Influence found = finder_.influence(row);
  if (!found) return row < OriginFinder::kMostUnasked ? QStringLiteral("…") : QStringLiteral("–");
  if (!*found) return tr("no model");
  return movedText(**found);
}

QVariant OriginTable::cell(int row, int column, int role) const {
  const auto at = static_cast<std::size_t>(row);
  const OriginRecord& record = origin_->records[at];
  if (role == Qt::ToolTipRole) {
    const QString sentence = finder_.influenceSentence(at);
    return column == kMoves && !sentence.isEmpty() ? QVariant(sentence) : QVariant();
  }
  if (role == kOrderRole && column == kMoves) {
    const OriginFinder::Influence found = finder_.influence(at);
    return found && *found ? (*found)->difference.largest_n : -1.0;
  }
  if (role == kOrderRole && column == kRecord) return row;
  if (role != Qt::DisplayRole && role != kOrderRole) return {};
  switch (column) {
    case kParticipant:
      return record.participant;
    case kRecord:
      return record.what;
    case kSays:
      return record.says;
    default:
      return movesText(at);
  }
}

}  // namespace tactus::workbench
