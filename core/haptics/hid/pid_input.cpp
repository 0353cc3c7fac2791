#include "core/haptics/hid/pid_input.h"

#include <algorithm>

namespace tactus::haptics {

PidInput::PidInput(const PidLayout& layout, std::span<const std::int64_t> blocks) : layout_(layout) {
  effect_count_ = std::min(blocks.size(), effects_.size());
  for (std::size_t i = 0; i < effect_count_; ++i) effects_[i].block = blocks[i];
}

bool PidInput::watchEffects(std::int64_t now_ns, std::int64_t started_ns, std::int64_t duration_ns) noexcept {
  const auto silent = [](const Effect& effect) { return effect.had_played && !effect.plays; };
  const bool any_silent = std::any_of(effects_.begin(), effects_.end(), silent);
  const bool should_play = now_ns - started_ns >= kSettleNs && now_ns - started_ns < duration_ns;
  // In between it is not known: a start is on its way, or the effects have run out.
  if (should_play || !any_silent) effect_stopped_ = any_silent;
  const bool before = sample_.forces_held_back;
  sample_.forces_held_back = switched_off_ || effect_stopped_;
  return sample_.forces_held_back != before;
}

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
  switched_off_ = is(state.paused) || (state.actuators_on && !is(state.actuators_on)) ||
                  (had_switch_ && !is(state.safety_switch)) || (had_power_ && !is(state.power));
  takePlaying(report);
  sample_.forces_held_back = switched_off_ || effect_stopped_;
}

void PidInput::takePlaying(std::span<const std::uint8_t> report) noexcept {
  const auto& state = *layout_.state;
  if (!state.playing) return;
  const bool plays = takeValue(report, *state.playing) != 0;
  const std::int64_t block = state.block ? takeValue(report, *state.block) : 0;
  for (std::size_t i = 0; i < effect_count_; ++i) {
    Effect& effect = effects_[i];
    // Without a block it is about all of them.
    if (block != 0 && block != effect.block) continue;
    effect.plays = plays;
    effect.had_played = effect.had_played || plays;
  }
}

}  // namespace tactus::haptics
