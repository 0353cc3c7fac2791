// The interface of a haptic device: its state, a force on the hand, and its properties.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/haptics/device/vector3.h"

namespace tactus::haptics {

/// The fault that a device reports. For any fault but kNone, the caller should not ask for force. A force already
/// present may fade if docs/servo.md, "Trips", says so.
enum class DeviceFault : std::uint8_t {
  kNone,
  kLost,           ///< unplugged, or it no longer answers
  kNotCalibrated,  ///< positions have no meaning yet
  kSwitchedOff,    ///< a switch, the device's own protection or another program blocks the forces
  kWarmMotors,     ///< the device's own thermal protection
  kForceLimited,   ///< the device refused or limited a force
  kFailed,         ///< any other fault
};
/// The fault in words for the user, e.g. `the motors are too warm`.
std::string_view describe(DeviceFault fault) noexcept;

/// One sample of a device.
struct DeviceState {
  std::uint64_t number = 0;  ///< number of the sample, from 1; 0: no sample yet
  std::int64_t time_ns = 0;  ///< arrival time, on the clock that the loop passes to `read`
  Vector3 position_mm;
  std::optional<Vector3> velocity_mm_s;  ///< the device's own estimate, if any: a cross-check, never rendered
  std::uint32_t buttons = 0;             ///< bit 0 is the first button
  DeviceFault fault = DeviceFault::kNone;
  std::int64_t written_ns = 0;  ///< time at which a force last reached the device; 0: never
};

/// Identity and properties of a device. An unknown number is absent, never guessed.
struct DeviceInfo {
  std::string id;       ///< its name on the command line: `virtual`, `hid:1209:ffb0:1234`, `openhaptics:Default Device`
  std::string name;     ///< as reported by the device or its driver
  std::string serial;   ///< may be empty
  std::string backend;  ///< `virtual`, `replay`, `hid-pid`, `openhaptics`
  bool simulated = false;  ///< no hardware; all recordings with it are marked as simulated
  int position_axes = 1;
  int force_axes = 1;
  int buttons = 1;
  double rate_hz = 1000;
  double max_force_n = 0;                    ///< the largest force of the device (its own limit)
  std::optional<double> continuous_force_n;  ///< the largest force that it can hold permanently
  std::optional<double> max_stiffness_n_mm;  ///< closed loop, as recommended by the manufacturer
  std::optional<double> count_mm;            ///< resolution of a position
  double damping_n_s_mm = 0;                 ///< b of the device alone, without a hand
  double delay_s = 0.001;                    ///< between a position and the force that responds to it
  std::optional<double> friction_in_n;       ///< dry friction of the device against insertion, if measured
  std::optional<double> friction_out_n;
  /// > 0: time for which the device holds a command. If the next command comes later, the device has dropped the force
  /// to 0 by itself, and the safety layer starts again from 0. If the time is unknown, use a short one: that is the
  /// safe side.
  double hold_s = 0.05;
  std::optional<double> quiet_after_s;  ///< if the host dies, the device gives no force after this time
};

/// The callee of a loop, called once per tick.
class Ticked {
 public:
  virtual ~Ticked() = default;
  /// Real-time safe: yes.
  virtual void tick(std::int64_t now_ns) noexcept = 0;
};

/// The loop of a driver that has a servo thread of its own. The driver calls `tick` on that thread, between a fresh
/// sample and the write.
class DeviceLoop {
 public:
  virtual ~DeviceLoop() = default;
  virtual base::Result<void> run(Ticked& ticked) = 0;
  /// Returns after the last call of `tick`. From then on the driver gives no force.
  virtual void end() noexcept = 0;
};

/// One open device. The destructor stops it. The owner's thread calls `start` and `stop`, which may block. The servo
/// thread calls `read` and `write`, which never block and never touch memory that another thread could lock.
class HapticDevice {
 public:
  virtual ~HapticDevice() = default;

  virtual const DeviceInfo& info() const noexcept = 0;

  /// Starts the data flow for `read` and `write`. The force is zero until the first `write`.
  virtual base::Result<void> start() = 0;
  /// Sets the force to zero, switches the actuators off and ends the threads. May be called twice.
  virtual void stop() noexcept = 0;

  /// The newest sample. `now_ns`: the time of this tick on the monotonic clock. Real-time safe: yes.
  virtual DeviceState read(std::int64_t now_ns) noexcept = 0;
  /// Sets the force on the hand, in the device's frame. A newer force replaces an older one. Real-time safe: yes.
  virtual void write(const Vector3& force_n, std::int64_t now_ns) noexcept = 0;

  /// The loop of the driver, if it has one. Null: a ServoThread calls the servo.
  virtual DeviceLoop* ownLoop() noexcept { return nullptr; }
};

}  // namespace tactus::haptics
