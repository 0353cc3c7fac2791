// Searches for haptic devices in the background, because drivers can be slow.
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <future>
#include <memory>
#include <string>

#include "app/devices/device_list.h"
#include "app/workbench/device/servo_loop.h"
#include "core/base/error.h"
#include "core/haptics/safety/thermal_budget.h"

namespace tactus::workbench {

/// How the devices of this computer are opened and who drives them. Tests replace both.
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

class DeviceSearch : public QObject {
  Q_OBJECT

 public:
  explicit DeviceSearch(QObject* parent = nullptr);

  /// The result of the last search; before the first search only the virtual device.
  const devices::DeviceList& list() const { return list_; }
  bool isSearching() const { return pending_.valid(); }

 public slots:
  /// Starts a search, which ends with `found`. Does nothing while a search is in progress.
  void search();

 signals:
  void searching();
  void found();

 private:
  void look();

  devices::DeviceList list_;
  std::future<devices::DeviceList> pending_;  ///< Its destructor waits for the search to end.
  QTimer poll_;
};

}  // namespace tactus::workbench
