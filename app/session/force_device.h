// What a device can hold: the forces of the force experiment against its limits, and the pause before each.
#pragma once

#include <string_view>

#include "core/base/error.h"
#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/safety/thermal_budget.h"
#include "experiments/force_protocol.h"

namespace tactus::session {

/// Whether a hand can feel the forces of this device (SessionRecord::device): not those of the virtual one, of a replay
/// or a dummy. True for an empty name, where nothing is known.
bool givesForce(std::string_view device);

/// Refuses settings with a force that the device never gives in full: above its force cap, or held for longer than even
/// cold motors can. Such a step could never be scored. Ignores series that are off.
base::Result<void> requireHolds(const experiments::ForceSettings& settings, const haptics::LimitSettings& limits);

/// The time without force before the step of `plan`, s: the pause of the settings, or longer where the motors need it
/// to hold the force in full. Each time that the participant feels the force again needs its own. `budget`: of the
/// device now (ThermalFollower). A force without a time limit is taken to be held for 10 s.
double pauseBeforeS(const experiments::ForcePlan& plan, const haptics::ThermalBudget& budget,
                    const haptics::LimitSettings& limits);

}  // namespace tactus::session
