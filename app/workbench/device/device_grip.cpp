#include "app/workbench/device/device_grip.h"

namespace tactus::workbench {

using haptics::EnableKind;

bool isHeldByKey(const haptics::DeviceInfo& device) { return device.simulated || device.buttons == 0; }

haptics::EnableSettings enableOf(const haptics::DeviceInfo& device, const DeviceGrip& grip) {
  haptics::EnableSettings enable;
  enable.kind = grip.latch ? EnableKind::kLatch : isHeldByKey(device) ? EnableKind::kPedal : EnableKind::kButton;
  enable.release_zone_mm = grip.release_zone_mm;
  return enable;
}

haptics::EnableSettings enableOfReplay() {
  haptics::EnableSettings enable;
  enable.kind = EnableKind::kButton;
  // What was recorded is the hand after its debounce.
  enable.press_debounce_s = 0;
  return enable;
}

bool isDown(const haptics::EnableSettings& enable, const haptics::Sample& sample, bool key_down) {
  const bool button = (sample.buttons & enable.button_mask) != 0;
  switch (enable.kind) {
    case EnableKind::kPedal:
    case EnableKind::kKey:
      return key_down;
    case EnableKind::kLatch:
      return key_down || button;
    case EnableKind::kButton:
      break;
  }
  return button;
}

}  // namespace tactus::workbench
