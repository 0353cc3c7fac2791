#include "app/workbench/tune/history/history_model.h"

#include <QDateTime>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/shown_impact.h"

namespace tactus::workbench {
namespace {

using editing::EventKind;
using Row = editing::HistoryRow;
using RowPlace = editing::HistoryRow::Place;

// The time of day is enough for today.
QString timeText(std::int64_t utc_ms) {
  const QDateTime time = QDateTime::fromMSecsSinceEpoch(utc_ms).toLocalTime();
  return time.toString(time.date() == QDate::currentDate() ? QStringLiteral("HH:mm")
                                                           : QStringLiteral("yyyy-MM-dd HH:mm"));
}

}  // namespace

HistoryModel::HistoryModel(EditController& edits, QObject* parent)
    : Columns({{{},
                [this](const Row& row) { return labelOf(row); },
                {},
                {},
                {{Qt::ToolTipRole, [this](const Row& row) { return tipOf(row); }},
                 {Qt::AccessibleTextRole,
                  [this](const Row& row) { return labelOf(row) + QStringLiteral(", ") + detailOf(row); }},
                 {kEffectRole, [this](const Row& row) { return detailOf(row); }},
                 {kSnapshotsRole, [this](const Row& row) { return marksOf(row, EventKind::kSnapshot); }},
                 {kSignOffsRole, [this](const Row& row) { return marksOf(row, EventKind::kSignOff); }}}}},
              parent),
      edits_(edits) {
  // Rows of another history would name states that are not there, and may be painted before the next refresh.
  connect(&edits_, &EditController::modelReset, this, [this] { setRows({}); });
}

void HistoryModel::refresh() {
  setRows(edits_.isOpen() ? editing::historyRows(edits_.history()) : std::vector<editing::HistoryRow>());
}

std::optional<int> HistoryModel::currentRow() const {
  const auto current =
      std::find_if(rows().begin(), rows().end(), [](const Row& row) { return row.place == RowPlace::kCurrent; });
  return current == rows().end() ? std::nullopt : std::optional(static_cast<int>(current - rows().begin()));
}

QString HistoryModel::labelOf(const editing::HistoryRow& row) const {
  return text(edits_.history().labelOf(row.state));
}

QString HistoryModel::detailOf(const editing::HistoryRow& row) const {
  const editing::Stamp& stamp = edits_.history().events()[edits_.history().states()[row.state].event].stamp;
  QStringList parts = {edits_.effectOf(row.state), timeText(stamp.utc_ms), text(stamp.author)};
  parts.removeAll(QString());
  return parts.join(QStringLiteral(" · "));
}

QString HistoryModel::tipOf(const editing::HistoryRow& row) const {
  const auto& events = edits_.history().events();
  QStringList lines = {labelOf(row), detailOf(row)};
  for (const std::size_t mark : row.marks) {
    const editing::Event& event = events[mark];
    const QString what = event.kind == EventKind::kSnapshot ? tr("Snapshot “%1”").arg(text(event.label))
                                                            : tr("Signed off: %1").arg(text(event.label));
    lines.append(tr("%1 · %2 · %3").arg(what, text(event.stamp.author), timeText(event.stamp.utc_ms)));
  }
  switch (row.place) {
    case RowPlace::kCurrent: lines.append(tr("The current model")); break;
    case RowPlace::kDone: lines.append(tr("A click goes back to it; nothing is lost")); break;
    case RowPlace::kUndone: lines.append(tr("Undone: a click brings it back")); break;
    case RowPlace::kBranch: lines.append(tr("An earlier branch. Click to return to it")); break;
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
