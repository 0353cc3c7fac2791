// The force trace of a feel session as a table.
#pragma once

#include <optional>

#include "app/workbench/base/plot_table.h"
#include "core/haptics/device/device.h"

namespace tactus::workbench {

class FeelHistory;
class SceneController;

/// Time in s up to the newest sample at 0, the force felt, the fuzzy force F_d and the force that friction asks for, in
/// N, and in a replay the recorded force. The caption names `device`, on which it was felt, and says where that is a
/// simulated one.
PlotTable traceTable(const SceneController& scene, const FeelHistory& history,
                     const std::optional<haptics::DeviceInfo>& device);

}  // namespace tactus::workbench
