// The words of stage Collect: steps of a participant and how far they are.
#pragma once

#include <QString>
#include <cstdint>

#include "app/workbench/collect/study_overview.h"

namespace tactus::workbench {

/// `Device check`, as short as a column.
QString stepName(CollectStep step);
/// `done`, `12 of 45`, `open`, `skipped`, `imported`; empty for what is no part of the session.
QString stateText(const StepState& state);
/// The same for a reader of the screen, which has no empty cells.
QString spokenState(const StepState& state);
/// What to do next with the participant: a step, `all done`, or that the session was ended.
QString nextText(const ParticipantRow& row);
/// `today 14:05`, `2026-11-20`, `never`; `now_ms`: the present, UTC.
QString lastSeenText(std::int64_t last_seen_ms, std::int64_t now_ms);

}  // namespace tactus::workbench
