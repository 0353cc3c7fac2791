// How the hand takes the tube and lets go of it, as a person chooses it and as the servo is told.
#pragma once

#include "core/haptics/device/device.h"
#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/servo/sample.h"

namespace tactus::workbench {

/// With what the device has, or with a latch, because a squeezed switch spoils the feel.
struct FeelGrip {
  bool latch = false;            ///< a press takes the tube, the next one lets go
  double release_zone_mm = -20;  ///< with a latch: axis positions further out than this let go too

  bool operator==(const FeelGrip&) const = default;
};

/// The tube is held with a key or the mouse, because the device has no button.
bool isHeldByKey(const haptics::DeviceInfo& device);

haptics::EnableSettings enableOf(const haptics::DeviceInfo& device, const FeelGrip& grip);
/// The hand of a recording, which comes as the button of the device that replays it.
haptics::EnableSettings enableOfReplay();

/// What takes the tube is down: in `sample`, or as `key_down` for what the program sees.
bool isDown(const haptics::EnableSettings& enable, const haptics::Sample& sample, bool key_down);

}  // namespace tactus::workbench
