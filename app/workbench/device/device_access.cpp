#include "app/workbench/device/device_access.h"

namespace tactus::workbench {

DeviceAccess realDevices() {
  // A device behind a driver may take seconds; the virtual one is there at once.
  DeviceAccess access;
  access.open_device = [](const std::string& id) { return devices::open(id, devices::settingsOfProcess()); };
  access.make_loop = threadedLoop;
  access.is_slow = [](const std::string& id) { return id != "virtual"; };
  return access;
}

}  // namespace tactus::workbench
