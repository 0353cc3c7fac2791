// The heading of a participant's plot in the speed lab: the name in the participant's color, and how much data it
// shows.
#pragma once

#include <QString>
#include <cstddef>

#include "app/workbench/labs/speed/speed_result.h"

namespace tactus::workbench {

/// `S1`; says `simulated` where the data are.
QString subjectName(const SpeedSubject& subject);
/// `S1 · 5 312 of 6 004 samples`, with the same.
QString subjectTitle(const SpeedSubject& subject);

}  // namespace tactus::workbench
