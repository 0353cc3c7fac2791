#include "core/haptics/hid/pid_input.h"

namespace tactus::haptics {

bool PidInput::take(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept {
  if (report.empty()) return false;
  const std::uint8_t id = report[0];
  bool taken = false;
  if (layout_.state && layout_.state->report_id == id) {
    takeState(report);
    taken = true;
  }
  bool moved = false;
  for (std::size_t axis = 0; axis < layout_.axes.size(); ++axis) {
    const auto& input = layout_.axes[axis];
    if (!input || input->report_id != id) continue;
    const ValueSlot& slot = input->slot;
    if (1 + (slot.bit_offset + slot.bit_size + 7) / 8 > report.size()) continue;
    const std::int64_t middle = (slot.logical_min + slot.logical_max + 1) / 2;
    sample_.counts[axis] = static_cast<double>(takeValue(report, slot) - middle);
    moved = true;
  }
  for (std::size_t i = 0; i < layout_.buttons.size(); ++i) {
    const auto& input = layout_.buttons[i];
    if (!input || input->report_id != id) continue;
    const std::uint32_t bit = std::uint32_t{1} << i;
    sample_.buttons = takeValue(report, input->slot) != 0 ? sample_.buttons | bit : sample_.buttons & ~bit;
    taken = true;
  }
  if (moved) {
    ++sample_.number;
    sample_.time_ns = now_ns;
  }
  return taken || moved;
}

void PidInput::takeState(std::span<const std::uint8_t> report) noexcept {
  const auto& state = *layout_.state;
  const auto is = [&](const std::optional<ValueSlot>& slot) { return slot && takeValue(report, *slot) != 0; };
  had_switch_ = had_switch_ || is(state.safety_switch);
  had_power_ = had_power_ || is(state.power);
  sample_.forces_held_back = is(state.paused) || (state.actuators_on && !is(state.actuators_on)) ||
                             (had_switch_ && !is(state.safety_switch)) || (had_power_ && !is(state.power));
}

}  // namespace tactus::haptics
