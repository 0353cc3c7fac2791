#include "app/workbench/collect/participant_table.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/collect/study_overview.h"
#include "app/workbench/study/connection/study_contents.h"

namespace tactus::workbench {
namespace {

struct ParticipantWords {
  Q_DECLARE_TR_FUNCTIONS(ParticipantWords)
};

std::vector<Column<ParticipantRow>> participantColumns() {
  using Row = ParticipantRow;
  // The view aligns its heads.
  const auto column = [](const QString& head, CellOf<Row> cell) -> Column<Row> { return {head, std::move(cell), {}}; };
  const auto code = [](const Row& row) { return harmless(row.code); };
  std::vector<Column<Row>> out = {column(ParticipantWords::tr("Participant"), code)};
  out.back().roles[Qt::AccessibleTextRole] = [code](const Row& row) {
    return row.simulated         ? ParticipantWords::tr("%1, SIMULATED").arg(code(row))
           : row.virtual_device  ? ParticipantWords::tr("%1, VIRTUAL").arg(code(row))
           : row.setup_unchecked ? ParticipantWords::tr("%1, SET-UP NOT CHECKED").arg(code(row))
                                 : code(row);
  };
  for (int i = 0; i < static_cast<int>(kCollectSteps); ++i) {
    const auto step = static_cast<CollectStep>(i);
    const auto spoken = [step](const Row& row) {
      return ParticipantWords::tr("%1: %2").arg(stepName(step), spokenState(row.at(step)));
    };
    out.push_back(column(stepName(step), [step](const Row& row) { return stateText(row.at(step)); }));
    out.back().roles = {{Qt::ToolTipRole, spoken}, {Qt::AccessibleTextRole, spoken}};
  }
  out.push_back(column(ParticipantWords::tr("Next step"), &nextText));
  out.back().roles[Qt::ToolTipRole] = [](const Row& row) { return harmless(row.trouble); };
  out.push_back(column(ParticipantWords::tr("Last seen"),
                       [](const Row& row) { return lastSeenText(row.last_seen_ms, utcNowMs()); }));
  out.push_back(column(ParticipantWords::tr("Language"), [](const Row& row) { return languageName(row.language); }));
  return withRole<Row>(std::move(out), Qt::AccessibleTextRole);
}

}  // namespace

ParticipantTable::ParticipantTable(CollectController& collect, QObject* parent)
    : Columns(participantColumns(), parent) {
  setRows(collect.overview().rows);
  // The same people in the same order keep their rows, and with them the selection.
  connect(&collect, &CollectController::changed, this, [this, &collect] {
    const auto& now = collect.overview().rows;
    const auto same = [](const ParticipantRow& one, const ParticipantRow& other) { return one.person == other.person; };
    std::equal(now.begin(), now.end(), rows().begin(), rows().end(), same) ? updateRows(now) : setRows(now);
  });
}

std::optional<CollectStep> ParticipantTable::stepOf(int column) {
  if (column < kFirstStep || column >= kNext) return std::nullopt;
  return static_cast<CollectStep>(column - kFirstStep);
}

int ParticipantTable::rowOf(const study::RecordId& person) const {
  const auto found =
      std::find_if(rows().begin(), rows().end(), [&](const ParticipantRow& one) { return one.person == person; });
  return found == rows().end() ? -1 : static_cast<int>(found - rows().begin());
}

}  // namespace tactus::workbench
