// How the devices of this computer are opened and who drives them. Tests replace both.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/devices/device_list.h"
#include "app/workbench/device/servo_loop.h"
#include "core/base/error.h"
#include "core/haptics/safety/thermal_budget.h"

namespace tactus::workbench {

struct DeviceAccess {
  std::function<base::Result<devices::OpenedDevice>(const std::string& id)> open_device;
  MakeServoLoop make_loop;
  /// Whether the device `id` may be slow to start and stop. It then does so in the background, and the window stays
  /// responsive. Without this function no device counts as slow.
  std::function<bool(const std::string& id)> is_slow;
  /// The motor heat of each device, kept from run to run. Never null.
  std::shared_ptr<haptics::ThermalLedger> thermal = std::make_shared<haptics::ThermalLedger>();
};

/// The devices of this computer, each with its own servo thread.
DeviceAccess realDevices();

}  // namespace tactus::workbench
