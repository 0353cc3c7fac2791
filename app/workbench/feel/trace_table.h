// The force trace of a feel session as a table.
#pragma once

#include <optional>

#include "app/workbench/base/plot_table.h"
#include "core/haptics/device/device.h"

namespace tactus::workbench {

class FeelHistory;
class SceneController;

/// Columns: time, s, with the newest sample at 0; felt force, fuzzy force F_d and requested friction force, N; in a
/// replay also the recorded force. The caption names `device` and says if it is simulated.
PlotTable traceTable(const SceneController& scene, const FeelHistory& history,
                     const std::optional<haptics::DeviceInfo>& device);

}  // namespace tactus::workbench
