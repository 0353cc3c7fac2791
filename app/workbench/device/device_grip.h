// How the hand holds and releases the tube: the user's choice, and the settings for the servo.
#pragma once

#include "core/haptics/device/device.h"
#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/servo/sample.h"

namespace tactus::workbench {

/// The device's own switch, or a latch. The latch is useful because a squeezed switch changes the feel.
struct DeviceGrip {
  bool latch = false;            ///< a first press holds the tube, a second one releases it
  double release_zone_mm = -20;  ///< with a latch: axis positions further out also release it

  bool operator==(const DeviceGrip&) const = default;
};

/// Whether a key or the mouse holds the tube, because the device has no button.
bool isHeldByKey(const haptics::DeviceInfo& device);

haptics::EnableSettings enableOf(const haptics::DeviceInfo& device, const DeviceGrip& grip);
/// The settings for a replay: the recorded hand is the button of the replaying device.
haptics::EnableSettings enableOfReplay();

/// Whether the switch is down: in `sample`, or, for a switch of the program, as `key_down` says.
bool isDown(const haptics::EnableSettings& enable, const haptics::Sample& sample, bool key_down);

}  // namespace tactus::workbench
