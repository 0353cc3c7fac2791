// The interface of a haptic device: its state, a force on the hand, and its properties.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace tactus::haptics {

// Times of the monotonic clock in seconds.

/// The time from `from_ns` to `to_ns`, s. Returns 0 if the clock ran backwards. Real-time safe: yes.
constexpr double secondsBetween(std::int64_t from_ns, std::int64_t to_ns) noexcept {
  return to_ns > from_ns ? 1e-9 * static_cast<double>(to_ns - from_ns) : 0;
}

// Three numbers along the axes of a haptic device.

/// A vector in the device's frame: x to the right, y up, z toward the user.
struct Vector3 {
  double x = 0;
  double y = 0;
  double z = 0;

  bool operator==(const Vector3&) const = default;
};

inline double dot(const Vector3& a, const Vector3& b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector3 operator*(double factor, const Vector3& v) noexcept {
  return {factor * v.x, factor * v.y, factor * v.z};
}
inline Vector3 operator+(const Vector3& a, const Vector3& b) noexcept { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector3 operator-(const Vector3& a, const Vector3& b) noexcept { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

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
  std::string calibrated_utc;  ///< when it was calibrated with Tactus, e.g. 2026-11-21T08:00:00Z; may be empty
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

// The axes of a device's frame that have motors, and the share of a direction that lies along them.

/// x, y, z of the device's frame; true if there is a motor.
using DrivenAxes = std::array<bool, 3>;

/// Axes by number of motors: the first pushes to the right, the second toward the user, the third up (HID's X, Y and
/// Z).
constexpr DrivenAxes drivenAxes(int force_axes) noexcept { return {force_axes >= 1, force_axes >= 3, force_axes >= 2}; }

/// The part of `v` along the motors.
constexpr Vector3 drivenPart(const Vector3& v, const DrivenAxes& driven) noexcept {
  return {driven[0] ? v.x : 0, driven[1] ? v.y : 0, driven[2] ? v.z : 0};
}

/// The cosine of the angle between `direction` (length 1) and its part along the motors, 0 to 1. If the motors push
/// with 1 N, this is the force along the direction in N.
inline double drivenShare(const Vector3& direction, const DrivenAxes& driven) noexcept {
  const Vector3 part = drivenPart(direction, driven);
  return std::sqrt(dot(part, part));
}

/// The program refuses an insertion axis with a smaller share (26 degrees). The motors have to push harder by the
/// inverse of the share, and the hand also feels the force across the axis: at this share it is 48 % of the force along
/// the axis.
inline constexpr double kLeastDrivenShare = 0.9;

// Converts between a device's frame and the insertion axis: one number for the position, one for the force.

/// A unit direction and a zero point. The default direction is level and points away from the user, so that the weight
/// of hand and stylus does not act along the axis.
class AxisMapping {
 public:
  AxisMapping() = default;
  /// `inwards`: direction of insertion, of any length > 0. `origin_mm`: the point where the axis position is 0. Returns
  /// an error if a number is not finite or `inwards` has the length 0.
  static base::Result<AxisMapping> make(const Vector3& inwards, const Vector3& origin_mm = {});

  const Vector3& inwards() const noexcept { return inwards_; }
  const Vector3& originMm() const noexcept { return origin_mm_; }

  /// Position along the axis, positive inwards. Real-time safe: yes.
  double positionMm(const Vector3& position_mm) const noexcept { return dot(position_mm - origin_mm_, inwards_); }
  double speedMmS(const Vector3& velocity_mm_s) const noexcept { return dot(velocity_mm_s, inwards_); }
  /// The force on the hand for a resistance against insertion. Real-time safe: yes.
  Vector3 forceOnHand(double resistance_n) const noexcept { return -resistance_n * inwards_; }

 private:
  Vector3 inwards_{0, 0, -1};
  Vector3 origin_mm_;
};

}  // namespace tactus::haptics
