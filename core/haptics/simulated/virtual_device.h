// A haptic device without hardware: a simulated mass in a simulated hand, scripted or moved by mouse and keyboard.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/haptics/device/device.h"
#include "core/haptics/simulated/hand_plan.h"
#include "core/haptics/simulated/pausing_clock.h"

namespace tactus::haptics {

// A hand on a one-axis haptic device, as masses, springs and dampers.

/// A hand: a mass on the device, tied to its wish by a spring and a damper. SI units, as published.
struct SimulatedHand {
  std::string_view name;
  double mass_kg = 0;  ///< moves with the device
  double damping_n_s_m = 0;
  double stiffness_n_m = 0;
  double arm_mass_kg = 0;  ///< > 0: an arm of this mass lies between, and the two numbers above describe its grip
  double arm_damping_n_s_m = 0;
  double arm_stiffness_n_m = 0;
};

inline constexpr SimulatedHand kNobody{"none"};
inline constexpr SimulatedHand kPinch{"pinch", 0.10, 1.5, 100};
inline constexpr SimulatedHand kArm{"arm", 0.55, 6.45, 135};  ///< van Beek 2016, one typical trial
/// Speich, Shao and Goldfarb 2005: grip and arm.
inline constexpr SimulatedHand kFiveParameters{"five-parameter", 0, 7.9, 375, 1.46, 4.5, 48.8};

/// All presets.
std::span<const SimulatedHand> handPresets() noexcept;
/// The preset of this name, or null.
const SimulatedHand* findHand(std::string_view name) noexcept;

/// The mechanics that the hand feels with the device switched off. Defaults: a Touch, at its tip.
struct DeviceMechanics {
  double mass_kg = 0.045;        ///< > 0
  double damping_n_s_m = 0.2;    ///< >= 0
  double dry_friction_n = 0.05;  ///< >= 0
};

/// Semi-implicit Euler. Dry friction is an impulse that can stop the motion but not reverse it. The error is of first
/// order in the step length (measured in docs/devices.md). Copyable, deterministic, without a clock.
class SimulatedBody {
 public:
  /// Device and arm start at `position_mm` with `speed_mm_s`.
  SimulatedBody(const SimulatedHand& hand, const DeviceMechanics& device, double position_mm = 0,
                double speed_mm_s = 0) noexcept;

  /// `wish` and `resistance_n` (positive against insertion) are constant for `dt_s` > 0. Steps of 10 us resolve all
  /// presets.
  /// Thread: any. Real-time safe: yes.
  void step(const HandTarget& wish, double resistance_n, double dt_s) noexcept;

  double positionMm() const noexcept { return 1e3 * x_; }
  double speedMmS() const noexcept { return 1e3 * v_; }

 private:
  SimulatedHand hand_;
  DeviceMechanics device_;
  double x_, v_, arm_x_, arm_v_;  ///< m, m/s
};

// Settings of a virtual device: its mechanics, its hand, its delays, and its injected faults.

/// The faults that can be injected.
enum class InjectedFault : std::uint8_t {
  kUnplugged,   ///< the device reports kLost, and no force acts on the hand
  kStalled,     ///< no new samples, and no force reaches the device
  kStuckValue,  ///< samples continue, the position stays constant
  kNotANumber,  ///< samples continue, the position is NaN
  kWarmMotors,  ///< the device reports kWarmMotors but still gives the force
};

/// `unplugged`, `stalled`, `stuck_value`, `not_a_number`, `warm_motors`.
std::string_view name(InjectedFault fault) noexcept;
/// The fault of this name; empty for any other text.
std::optional<InjectedFault> faultNamed(std::string_view text) noexcept;

/// One fault in simulated time, to the millisecond.
struct FaultEvent {
  InjectedFault fault = InjectedFault::kStalled;
  double start_s = 0;
  double duration_s = std::numeric_limits<double>::infinity();
};

/// Defaults: a Touch, held in a pinch grip, on a fast bus.
struct VirtualDeviceSettings {
  DeviceMechanics mechanics;
  SimulatedHand hand = kPinch;
  HandPlan plan;  ///< empty: `setTarget` and `setButton` move the hand
  double start_mm = 0;

  double count_mm = 0.055;             ///< positions are multiples of this; 0: exact
  double delay_s = 0.001;              ///< [0, 0.1], between a position and the force that responds to it
  double dropped_share = 0;            ///< [0, 1]: share of the samples at 1 kHz that do not arrive
  double stalls_per_s = 0;             ///< [0, 1000]: rate of random InjectedFault::kStalled
  int shortest_stall_ms = 2;           ///< a stall lasts at least this long …
  int longest_stall_ms = 5;            ///< … and at most this long
  std::uint64_t seed = 1;              ///< of dropped samples and stalls
  std::vector<FaultEvent> faults;      ///< in any order; they may overlap
  double max_force_n = 3.3;            ///< > 0; a larger force is cut, and the device reports kForceLimited
  double continuous_force_n = 0.88;    ///< > 0; reported only, the motors do not warm up by themselves
  double quiet_after_s = 0.1;          ///< > 0: without a fresh force for this time the device gives none
  Vector3 inwards{0, 0, -1};           ///< unit length: direction of the axis in the device's frame
  int steps_per_ms = 100;              ///< [1, 1000], a divisor of 1000000
  double live_time_constant_s = 0.03;  ///< > 0: time constant with which a live hand follows its target
  double live_speed_mm_s = 250;  ///< > 0: largest speed of a live hand's wish; the pinch adds a third when it rings
};

/// Checks the settings, which may come from scenario files. Returns an error with the place `device: <member>` if a
/// value is out of range.
base::Result<void> check(const VirtualDeviceSettings& settings);

// A haptic device with a hand on it, in simulated time. VirtualDevice runs it by the clock of the servo.

/// Forces on their way to a device. Each has its own arrival time; the newest arrived force counts.
struct ForceOnTheWay {
  double force_n = 0;
  std::int64_t arrives_ns = 0;
};

/// First in, first out, in order of arrival. If the queue is full, a new force replaces the last one. Real-time safe:
/// yes.
class ForceQueue {
 public:
  /// `arrives_ns`: not less than that of the previous force.
  void push(ForceOnTheWay force) noexcept {
    if (count_ == kRoom) --count_;
    waiting_[(first_ + count_++) % kRoom] = force;
  }

  /// The newest force that has arrived by `now_ns`. Removes it and all earlier ones from the queue.
  std::optional<ForceOnTheWay> take(std::int64_t now_ns) noexcept {
    std::optional<ForceOnTheWay> newest;
    while (count_ > 0 && waiting_[first_].arrives_ns <= now_ns) {
      newest = waiting_[first_];
      first_ = (first_ + 1) % kRoom;
      --count_;
    }
    return newest;
  }

 private:
  static constexpr std::size_t kRoom = 512;  ///< 0.1 s of delay at 5 kHz
  std::array<ForceOnTheWay, kRoom> waiting_{};
  std::size_t first_ = 0;
  std::size_t count_ = 0;
};

/// Copyable. The same settings and calls give the same bits. Times are ns since the start of the simulation. The hand's
/// plan, dropped samples, stalls and faults change once per millisecond. Forces arrive between any two steps. Thread:
/// any, one at a time. Real-time safe: all but the constructor.
class DeviceSimulation {
 public:
  /// `settings`: must pass `check` and contain a plan.
  explicit DeviceSimulation(VirtualDeviceSettings settings);

  /// Advances in whole steps up to `until_ns`; less than one step is missing.
  void advance(std::int64_t until_ns) noexcept;

  /// Writes a force along the insertion axis at `at_ns`, positive against insertion. It acts after the delay.
  void push(double resistance_n, std::int64_t at_ns) noexcept;

  /// The newest sample. If a sample was dropped or stalled, the previous one remains.
  DeviceState sample() noexcept;

  const SimulatedBody& body() const noexcept { return body_; }
  /// The resistance in effect during the last step.
  double forceInEffectN() const noexcept { return force_n_; }
  /// The time at which the newest force reached the device; empty if none did.
  std::optional<std::int64_t> writtenNs() const noexcept { return written_ns_; }

 private:
  bool has(InjectedFault fault) const noexcept { return ((faults_ >> static_cast<int>(fault)) & 1U) != 0; }
  void beginMillisecond() noexcept;
  double arrivingForce() noexcept;

  VirtualDeviceSettings settings_;
  std::int64_t step_ns_;
  double step_s_;
  std::int64_t delay_ns_;
  std::int64_t quiet_after_ns_;

  SimulatedBody body_;
  base::Random random_;
  ForceQueue on_the_way_;
  HandTarget wish_;
  std::int64_t time_ns_ = 0;
  std::int64_t millisecond_ = 0;    ///< the next one to start
  std::int64_t stalled_until_ = 0;  ///< a millisecond
  std::uint32_t faults_ = 0;        ///< InjectedFault as bits
  bool dropped_ = false;            ///< samples of this millisecond do not arrive
  double told_n_ = 0;               ///< the newest force that has reached the device
  std::optional<std::int64_t> written_ns_;
  DeviceFault force_fault_ = DeviceFault::kNone;
  double force_n_ = 0;
  DeviceState sample_;
};

// A hand that the user moves with mouse or keyboard. Its wish follows a target smoothly.

/// Any thread may call the setters; the simulating thread calls `next`. Real-time safe: yes.
class LiveHand {
 public:
  /// Time constant and largest speed of the follower, both > 0.
  LiveHand(double time_constant_s, double largest_speed_mm_s) noexcept
      : time_constant_s_(time_constant_s), largest_speed_mm_s_(largest_speed_mm_s) {}

  /// Ignored if not finite.
  void setTarget(double position_mm) noexcept;
  void setButton(bool down) noexcept { button_.store(down, std::memory_order_relaxed); }

  /// Moves the follower to `position_mm` at once, at rest.
  void place(double position_mm) noexcept;
  /// The wish one millisecond later. Critically damped, without overshoot.
  HandTarget next() noexcept;

 private:
  double time_constant_s_;
  double largest_speed_mm_s_;
  double position_mm_ = 0;
  double speed_mm_s_ = 0;
  std::atomic<double> target_mm_{0};
  std::atomic<bool> button_{false};
};

/// The simulation follows the clock passed to `read`: virtual time in tests, the monotonic clock in the workbench. The
/// first `read` after `start` is simulated time 0. Between two reads at most kLongestCatchUpNs are simulated; the rest
/// of a longer pause is skipped.
class VirtualDevice final : public HapticDevice {
 public:
  /// Returns the error of `check` if the settings are invalid.
  static base::Result<std::unique_ptr<VirtualDevice>> make(VirtualDeviceSettings settings = {});

  const DeviceInfo& info() const noexcept override { return info_; }
  /// Restarts: time 0, the device at `start_mm`, the same random numbers. A live hand follows its target from there.
  base::Result<void> start() override;
  /// Sets the force to zero. Samples stay unchanged.
  void stop() noexcept override;
  DeviceState read(std::int64_t now_ns) noexcept override;
  void write(const Vector3& force_n, std::int64_t now_ns) noexcept override;

  /// Sets the target of a live hand along the axis. Ignored if not finite. No effect on a scripted hand.
  /// Thread: any. Real-time safe: yes.
  void setTarget(double position_mm) noexcept { live_.setTarget(position_mm); }
  void setButton(bool down) noexcept { live_.setButton(down); }

  /// The true position at the last `read`: not quantized, not delayed, without faults. Thread: any. Real-time safe:
  /// yes.
  double truePositionMm() const noexcept { return true_position_mm_.load(std::memory_order_relaxed); }
  double trueSpeedMmS() const noexcept { return true_speed_mm_s_.load(std::memory_order_relaxed); }
  /// The resistance in effect just before the last `read`: with delay, limit and silence of the device.
  double trueForceN() const noexcept { return true_force_n_.load(std::memory_order_relaxed); }

 private:
  explicit VirtualDevice(VirtualDeviceSettings settings);

  VirtualDeviceSettings settings_;
  DeviceInfo info_;
  LiveHand live_;
  std::optional<DeviceSimulation> simulation_;  ///< since the first `start`
  bool running_ = false;
  PausingClock clock_;
  DeviceState last_;                        ///< times on the clock of `read`
  std::optional<std::int64_t> written_ns_;  ///< simulated time of the force that `last_.written_ns` refers to
  std::atomic<double> true_position_mm_{0};
  std::atomic<double> true_speed_mm_s_{0};
  std::atomic<double> true_force_n_{0};
};

}  // namespace tactus::haptics
