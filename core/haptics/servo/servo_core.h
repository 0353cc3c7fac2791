// One tick of the servo as a plain calculation. Input: a device's state and the orders. Output: a sample with the
// force.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/haptics/device/device.h"
#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/safety/safety.h"
#include "core/haptics/servo/sample.h"
#include "core/haptics/sources/force_source.h"
#include "core/haptics/sources/servo_scene.h"
#include "core/render/insertion.h"

namespace tactus::haptics {

// The orders of the program to the servo. The program posts a complete set; the next tick uses it.

/// Immutable after posting. Only a difference from the previous orders has an effect; posting the same orders again
/// changes nothing.
struct ServoOrders {
  ForceSource source = ForceSource::kOff;
  /// Forces are possible. A change from false to true starts the fade-in and clears a latched trip; the hand has to let
  /// go first.
  bool armed = false;
  std::shared_ptr<const ServoScene> scene;  ///< kInsertion without a scene gives no force
  Stimulus stimulus;
  std::uint64_t placement = 0;  ///< a new number starts a new placement: the tube is out, at `start_depth_mm`
  double start_depth_mm = 0;
  AxisMapping axis;  ///< a new axis: the force fades along the old axis and starts along the new one at the next press
  EnableSettings enable;
  LimitSettings limits;  ///< of the device
  /// 1 : scale, >= 1. The hand gets the force of the source divided by it.
  double scale = 1;
};

/// The input of one tick.
struct ServoTick {
  std::int64_t now_ns = 0;  ///< monotonic; only differences matter
  DeviceState device;
  const ServoOrders* orders = nullptr;  ///< never null; in effect from this tick on
  std::uint64_t orders_number = 0;      ///< the number stored in samples
  bool pedal = false;                   ///< a pedal or a key of the program is down
  bool stop = false;                    ///< Stop was pressed since the last tick
  std::int64_t heartbeat_ns = 0;        ///< time of the program's last heartbeat; 0: no heartbeat expected
};

/// All state between two ticks. Copyable, without clock or thread. Uses orders and scene during the tick only.
class ServoCore {
 public:
  /// `device`: its data give the stiffest spring that it can render. Its rate is > 0, its delay and damping are >= 0.
  /// `thermal`: the load of its motors so far.
  explicit ServoCore(const DeviceInfo& device, const ThermalBudget& thermal = {});

  /// Runs one tick. Thread: servo. Real-time safe: yes.
  Sample tick(const ServoTick& tick) noexcept;
  /// The force for the device, of its last tick.
  auto deviceForce(const Sample& sample) const noexcept { return axis_.forceOnHand(sample.force_n / sample.scale); }

  /// The device was told to give no force by another way than a tick. Call between two ticks.
  void toldNothing() noexcept { safety_.toldNothing(); }

  /// The axis in effect. It is that of the orders, except for at most 30 ms while a force along the previous axis
  /// fades.
  const AxisMapping& axis() const noexcept { return axis_; }
  const Trip& tripped() const noexcept { return safety_.tripped(); }
  const render::SceneCounters& counters() const noexcept { return insertion_.counters(); }
  /// Used share of the thermal budget, [0, 1].
  double thermalShare() const noexcept { return safety_.thermalShare(); }
  /// The load of the motors after the last force has ended, if no tick follows.
  ThermalBudget thermal() const noexcept { return safety_.thermal(); }
  /// How many times the force restarted after a gap between commands.
  std::uint64_t restarts() const noexcept { return safety_.restarts(); }

 private:
  double sources(const ServoTick& tick, double position_mm, double dt_s) noexcept;
  void takeScale(double scale) noexcept;
  Sample sampleOf(const ServoTick& tick) const noexcept;

  double period_s_;
  double largest_stiffness_n_mm_;  ///< of the device
  double scale_ = 1;               ///< in effect
  Safety safety_;
  render::Insertion insertion_;
  StimulusSource stimulus_;
  std::uint64_t ticks_ = 0;
  std::int64_t last_ns_ = 0;                ///< of the last tick
  bool sampled_ = false;                    ///< the device had a sample at the last tick
  std::optional<std::uint64_t> placement_;  ///< of the last tick
  AxisMapping axis_;                        ///< in effect
  double force_n_ = 0;                      ///< of the last tick, on the hand
};

/// The stiffest spring that stays passive on `device` with a pinch grip, N/mm: half of b / (T / 2 + delay), with b =
/// device + 1.7 N s/m (Colgate and Schenkel 1997; delay as in docs/servo.md). At most the stiffness that the
/// manufacturer recommends.
double largestStiffnessNMm(const DeviceInfo& device) noexcept;

}  // namespace tactus::haptics
