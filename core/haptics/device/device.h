// What every haptic device offers: its state now, a force on the hand, and what it can do.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/haptics/device/vector3.h"

namespace tactus::haptics {

/// What a device says is wrong with it. Everything but kNone means that no force should be asked for; one that is on
/// may fade where docs/servo.md, "Trips", says so.
enum class DeviceFault : std::uint8_t {
  kNone,
  kLost,           ///< unplugged, or it does not answer any more
  kNotCalibrated,  ///< positions mean nothing yet
  kSwitchedOff,    ///< a switch, the device's own protection or another program holds the forces back
  kWarmMotors,     ///< the device's own thermal protection
  kForceLimited,   ///< the device refused or limited a force
  kFailed,         ///< anything else it reports
};
/// What is wrong, for a person, e.g. `the motors are too warm`.
std::string_view describe(DeviceFault fault) noexcept;

/// One sample of a device.
struct DeviceState {
  std::uint64_t number = 0;  ///< from 1, counts the samples; 0: there was none yet
  std::int64_t time_ns = 0;  ///< when it arrived, on the clock that the loop passes to `read`
  Vector3 position_mm;
  std::optional<Vector3> velocity_mm_s;  ///< the device's own, where it has one: a cross-check, never what is rendered
  std::uint32_t buttons = 0;             ///< bit 0 is the first button
  DeviceFault fault = DeviceFault::kNone;
  std::int64_t written_ns = 0;  ///< when a force last reached the device; 0: none did yet
};

/// What a device is and what it can do. Numbers that are not known are absent, never guessed.
struct DeviceInfo {
  std::string
      id;  ///< how a person names it on the command line: `virtual`, `hid:1209:ffb0:1234`, `openhaptics:Default Device`
  std::string name;        ///< as the device or its driver tells
  std::string serial;      ///< may be empty
  std::string backend;     ///< `virtual`, `replay`, `hid-pid`, `openhaptics`
  bool simulated = false;  ///< no hardware: everything recorded with it is marked as simulated
  int position_axes = 1;
  int force_axes = 1;
  int buttons = 1;
  double rate_hz = 1000;
  double max_force_n = 0;                    ///< the largest the device can give (its own limit)
  std::optional<double> continuous_force_n;  ///< what it can hold for ever
  std::optional<double> max_stiffness_n_mm;  ///< closed-loop, as its maker advises
  std::optional<double> count_mm;            ///< resolution of a position
  double damping_n_s_mm = 0;                 ///< b of the device itself, without a hand
  double delay_s = 0.001;                    ///< between a position and the force that answers it
  std::optional<double> friction_in_n;       ///< own dry friction against insertion, where it was measured
  std::optional<double> friction_out_n;
  /// > 0: for how long the device holds a command. Where the next one is later than this, it has let go by itself: the
  /// force is 0, and the safety layer begins anew. Where it is not known, too short is the safe side.
  double hold_s = 0.05;
  std::optional<double> quiet_after_s;  ///< a dead host means no force after this time
};

/// What a loop calls once per tick.
class Ticked {
 public:
  virtual ~Ticked() = default;
  /// Real-time safe: yes.
  virtual void tick(std::int64_t now_ns) noexcept = 0;
};

/// A device whose driver has a servo thread of its own: it calls `tick` from there, between a fresh sample and the
/// write.
class DeviceLoop {
 public:
  virtual ~DeviceLoop() = default;
  virtual base::Result<void> run(Ticked& ticked) = 0;
  /// Returns when `tick` will not be called any more; from then on the driver gives no force.
  virtual void end() noexcept = 0;
};

/// One open device. The destructor stops it. `start` and `stop` may block and belong to the thread that owns it; `read`
/// and `write` belong to the servo thread, never block and touch no memory that another thread could hold.
class HapticDevice {
 public:
  virtual ~HapticDevice() = default;

  virtual const DeviceInfo& info() const noexcept = 0;

  /// Starts what feeds `read` and `write`; the force is zero until the first `write`.
  virtual base::Result<void> start() = 0;
  /// Force zero, actuators off, threads ended; may be called twice.
  virtual void stop() noexcept = 0;

  /// The newest sample. `now_ns`: the time of this tick on the monotonic clock. Real-time safe: yes.
  virtual DeviceState read(std::int64_t now_ns) noexcept = 0;
  /// The force on the hand from now on, in the device's frame; the newest counts. Real-time safe: yes.
  virtual void write(const Vector3& force_n, std::int64_t now_ns) noexcept = 0;

  /// The loop of the driver where it has one; nothing: a ServoThread calls.
  virtual DeviceLoop* ownLoop() noexcept { return nullptr; }
};

}  // namespace tactus::haptics
