#include "core/haptics/safety/enable_switch.h"

#include <cmath>

#include "core/haptics/device/seconds.h"

namespace tactus::haptics {

void EnableSwitch::rest() noexcept {
  on_ = false;
  ready_ = false;
  spent_ = false;
}

void EnableSwitch::update(const SwitchInput& input, const EnableSettings& settings) noexcept {
  const bool another = settings.kind != kind_ || settings.button_mask != button_mask_;
  kind_ = settings.kind;
  button_mask_ = settings.button_mask;
  if (another || input.armed != armed_) {
    if (armed_ && !input.armed) let_go_ = false;
    rest();
  }
  armed_ = input.armed;
  if (!input.down) {
    changed_ns_ = input.now_ns;  // it may have been let go meanwhile
    return;
  }

  const bool down = *input.down;
  if (down != down_ || another) changed_ns_ = input.now_ns;
  if (!down && !armed_) let_go_ = true;
  if (!down) ready_ = true;
  if (!armed_) {
    on_ = false;
  } else if (ready_ && kind_ == EnableKind::kLatch) {
    latched(input, settings, down);
  } else if (ready_) {
    held(input, settings, down);
  }
  down_ = down;
}

void EnableSwitch::held(const SwitchInput& input, const EnableSettings& settings, bool down) noexcept {
  if (!down) {
    on_ = false;
    spent_ = false;
  } else if (!spent_ && secondsBetween(changed_ns_, input.now_ns) >= settings.press_debounce_s) {
    spent_ = true;
    on_ = !settings.start_zone_mm || std::abs(input.position_mm) <= *settings.start_zone_mm;
  }
}

void EnableSwitch::latched(const SwitchInput& input, const EnableSettings& settings, bool down) noexcept {
  const double since_s = secondsBetween(changed_ns_, input.now_ns);
  const bool outside = !(input.position_mm >= settings.release_zone_mm);
  if (outside) on_ = false;
  if (!down) {
    // The press that switched on has ended for good once its contact no longer bounces.
    if (since_s >= settings.press_debounce_s) spent_ = false;
  } else if (on_ && !spent_) {
    on_ = false;  // switching off needs no debounce
    spent_ = true;
  } else if (!spent_ && since_s >= settings.press_debounce_s) {
    spent_ = true;
    on_ = !outside && (!settings.start_zone_mm || std::abs(input.position_mm) <= *settings.start_zone_mm);
  }
}

}  // namespace tactus::haptics
