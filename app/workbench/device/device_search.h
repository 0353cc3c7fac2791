// Searches for haptic devices in the background, because drivers can be slow.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <string>

#include "app/devices/device_list.h"
#include "core/base/error.h"
#include "core/haptics/safety/thermal_budget.h"
#include "core/haptics/servo/servo.h"

namespace tactus::workbench {

// The loop that calls the servo: a thread of its own. Tests step it through virtual time instead.

class ServoLoop {
 public:
  virtual ~ServoLoop() = default;
  /// Starts the loop. Returns when the servo is ticking. Thread: gui.
  virtual base::Result<void> start() = 0;
  /// Stops the loop. Returns after the last tick, when the device has the order for zero force. Thread: gui.
  virtual void stop() noexcept = 0;
  /// The clock of the ticks, ns.
  virtual std::int64_t nowNs() const noexcept = 0;
  /// The scheduling priority of the loop, for the screen: `real-time thread`.
  virtual QString priorityText() const = 0;
};

/// Creates the loop of a servo. The servo outlives the loop.
using MakeServoLoop = std::function<std::unique_ptr<ServoLoop>(haptics::Servo&)>;

/// A haptics::ServoThread on the monotonic clock.
std::unique_ptr<ServoLoop> threadedLoop(haptics::Servo& servo);

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
