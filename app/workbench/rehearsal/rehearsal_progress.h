// How far a rehearsal has come, for programs that watch it from outside: a line for each thing that a screen asks.
#pragma once

#include <QByteArray>
#include <QString>

#include "app/workbench/participant/participant_state.h"
#include "app/workbench/rehearsal/screen_nurse.h"
#include "app/workbench/study/connection/session_snapshot.h"

namespace tactus::workbench {

/// `welcome`, `device_check`, `question`: a screen by name.
QString screenId(ParticipantScreen screen);

/// A JSON object on one line: the screen, what the nurse knows to be stored (`insertions`, `judgements`, `answers`,
/// `ratings`), `position` of a question (else 0), and `failed` while the disk refuses. `at`: null before the session.
QByteArray progressLine(const ParticipantState& state, const SessionSnapshot* at, const NurseMemory& memory);

}  // namespace tactus::workbench
