#include "app/workbench/collect/participant_table.h"

#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/collect/study_overview.h"
#include "app/workbench/study/connection/study_contents.h"

namespace tactus::workbench {

ParticipantTable::ParticipantTable(CollectController& collect, QObject* parent)
    : QAbstractTableModel(parent), collect_(collect), rows_(collect.overview().rows) {
  connect(&collect_, &CollectController::changed, this, &ParticipantTable::follow);
}

std::optional<CollectStep> ParticipantTable::stepOf(int column) {
  if (column < kFirstStep || column >= kNext) return std::nullopt;
  return static_cast<CollectStep>(column - kFirstStep);
}

const ParticipantRow& ParticipantTable::participant(int row) const { return rows_[static_cast<std::size_t>(row)]; }

int ParticipantTable::rowOf(const study::RecordId& person) const {
  const auto found =
      std::find_if(rows_.begin(), rows_.end(), [&](const ParticipantRow& one) { return one.person == person; });
  return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

int ParticipantTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int ParticipantTable::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

// The same people in the same order keep their rows, and with them the selection.
void ParticipantTable::follow() {
  const auto& now = collect_.overview().rows;
  const auto same = [](const ParticipantRow& one, const ParticipantRow& other) { return one.person == other.person; };
  if (std::equal(now.begin(), now.end(), rows_.begin(), rows_.end(), same)) {
    rows_ = now;
    if (!rows_.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
    return;
  }
  beginResetModel();
  rows_ = now;
  endResetModel();
}

QString ParticipantTable::shown(const ParticipantRow& row, int column) const {
  if (const auto step = stepOf(column)) return stateText(row.at(*step));
  switch (column) {
    case kCode: return harmless(row.code);
    case kNext: return nextText(row);
    case kLastSeen: return lastSeenText(row.last_seen_ms, utcNowMs());
    case kLanguage: return languageName(row.language);
    default: return {};
  }
}

QVariant ParticipantTable::data(const QModelIndex& index, int role) const {
  const ParticipantRow& row = participant(index.row());
  const auto step = stepOf(index.column());
  switch (role) {
    case Qt::DisplayRole: return shown(row, index.column());
    case Qt::ToolTipRole:
      if (index.column() == kNext && !row.trouble.isEmpty()) return harmless(row.trouble);
      return step ? tr("%1: %2").arg(stepName(*step), spokenState(row.at(*step))) : QString();
    case Qt::AccessibleTextRole: {
      if (step) return tr("%1: %2").arg(stepName(*step), spokenState(row.at(*step)));
      const QString text = shown(row, index.column());
      if (index.column() != kCode) return text;
      return row.simulated ? tr("%1, SIMULATED").arg(text) : row.virtual_device ? tr("%1, VIRTUAL").arg(text) : text;
    }
    default: return {};
  }
}

QVariant ParticipantTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  if (const auto step = stepOf(section)) return stepName(*step);
  switch (section) {
    case kCode: return tr("Participant");
    case kNext: return tr("Next step");
    case kLastSeen: return tr("Last seen");
    case kLanguage: return tr("Language");
    default: return {};
  }
}

}  // namespace tactus::workbench
