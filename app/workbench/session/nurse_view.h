// The participant's screens in the words of the researcher's monitor.
#pragma once

#include "app/workbench/collect/monitor_controller.h"
#include "app/workbench/participant/kit/participant_state.h"

namespace tactus::workbench {

/// `force`: what the session asks her to feel now; null: nothing.
NurseView nurseView(const ParticipantState& state, const experiments::ForcePlan* force);

}  // namespace tactus::workbench
