#include "app/workbench/tune/history/history_model.h"

#include <QDateTime>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/shown_impact.h"

namespace tactus::workbench {
namespace {

using editing::EventKind;
using Place = editing::HistoryRow::Place;

// The time of day is enough for today.
QString timeText(std::int64_t utc_ms) {
  const QDateTime time = QDateTime::fromMSecsSinceEpoch(utc_ms).toLocalTime();
  return time.toString(time.date() == QDate::currentDate() ? QStringLiteral("HH:mm")
                                                           : QStringLiteral("yyyy-MM-dd HH:mm"));
}

}  // namespace

HistoryModel::HistoryModel(EditController& edits, QObject* parent) : QAbstractListModel(parent), edits_(edits) {
  // Rows of another history would name states that are not there, and may be painted before the next refresh.
  connect(&edits_, &EditController::modelReset, this, [this] {
    beginResetModel();
    rows_.clear();
    endResetModel();
  });
}

void HistoryModel::refresh() {
  beginResetModel();
  rows_ = edits_.isOpen() ? editing::historyRows(edits_.history()) : std::vector<editing::HistoryRow>();
  endResetModel();
}

std::optional<int> HistoryModel::currentRow() const {
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    if (rows_[row].place == Place::kCurrent) return static_cast<int>(row);
  }
  return std::nullopt;
}

int HistoryModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const {
  const editing::HistoryRow& row = rows_[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole: return text(edits_.history().labelOf(row.state));
    case Qt::ToolTipRole: return tipOf(row);
    case Qt::AccessibleTextRole:
      return text(edits_.history().labelOf(row.state)) + QStringLiteral(", ") + detailOf(row);
    case kEffectRole: return detailOf(row);
    case kSnapshotsRole: return marksOf(row, EventKind::kSnapshot);
    case kSignOffsRole: return marksOf(row, EventKind::kSignOff);
    default: return {};
  }
}

QString HistoryModel::detailOf(const editing::HistoryRow& row) const {
  const editing::Stamp& stamp = edits_.history().events()[edits_.history().states()[row.state].event].stamp;
  QStringList parts = {edits_.effectOf(row.state), timeText(stamp.utc_ms), text(stamp.author)};
  parts.removeAll(QString());
  return parts.join(QStringLiteral(" · "));
}

QString HistoryModel::tipOf(const editing::HistoryRow& row) const {
  const auto& events = edits_.history().events();
  QStringList lines = {text(edits_.history().labelOf(row.state)), detailOf(row)};
  for (const std::size_t mark : row.marks) {
    const editing::Event& event = events[mark];
    const QString what = event.kind == EventKind::kSnapshot ? tr("Snapshot “%1”").arg(text(event.label))
                                                            : tr("Signed off: %1").arg(text(event.label));
    lines.append(tr("%1 · %2 · %3").arg(what, text(event.stamp.author), timeText(event.stamp.utc_ms)));
  }
  switch (row.place) {
    case Place::kCurrent: lines.append(tr("The current model")); break;
    case Place::kDone: lines.append(tr("A click goes back to it; nothing is lost")); break;
    case Place::kUndone: lines.append(tr("Undone: a click brings it back")); break;
    case Place::kBranch: lines.append(tr("An earlier branch. Click to return to it")); break;
  }
  const bool newtons = edits_.model().output.unit == "N";
  if (newtons && edits_.impactOf(row.state)) lines.append(explained(Statistic::kNoticeable));
  return lines.join(QLatin1Char('\n'));
}

QStringList HistoryModel::marksOf(const editing::HistoryRow& row, EventKind kind) const {
  QStringList out;
  for (const std::size_t mark : row.marks) {
    const editing::Event& event = edits_.history().events()[mark];
    if (event.kind != kind) continue;
    out.append(kind == EventKind::kSnapshot
                   ? text(event.label)
                   : (editing::saysFelt(event.label) ? tr("%1: feels right") : tr("%1: approved unfelt"))
                         .arg(text(event.stamp.author)));
  }
  return out;
}

}  // namespace tactus::workbench
