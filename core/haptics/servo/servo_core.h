// One tick of the servo as a plain calculation: a device's state and the orders in, a sample with the force out.
#pragma once

#include <cstdint>
#include <optional>

#include "core/haptics/device/device.h"
#include "core/haptics/safety/safety.h"
#include "core/haptics/servo/sample.h"
#include "core/haptics/servo/servo_orders.h"
#include "core/haptics/sources/insertion_source.h"
#include "core/haptics/sources/stimulus_source.h"

namespace tactus::haptics {

/// What a tick is told.
struct ServoTick {
  std::int64_t now_ns = 0;  ///< monotonic; only differences mean something
  DeviceState device;
  const ServoOrders* orders = nullptr;  ///< never null; those in force from this tick on
  std::uint64_t orders_number = 0;      ///< as samples carry it
  bool pedal = false;                   ///< pedal or key of the program is down
  bool stop = false;                    ///< Stop was pressed since the last tick
  std::int64_t heartbeat_ns = 0;        ///< last sign of life of the program; 0: none is expected
};

/// All state between two ticks; copyable, no clock, no thread. Orders and scene are read during the tick only.
class ServoCore {
 public:
  /// `device` tells how stiff a spring it can render; its rate is > 0, its delay and damping are >= 0.
  /// `thermal`: what its motors have given so far.
  explicit ServoCore(const DeviceInfo& device, const ThermalBudget& thermal = {});

  /// Thread: servo. Real-time safe: yes. The force for the device is `axis().forceOnHand(sample.force_n)`.
  Sample tick(const ServoTick& tick) noexcept;

  /// The device was told to give no force, by another way than a tick. Between two ticks.
  void toldNothing() noexcept { safety_.toldNothing(); }

  /// The axis in force: that of the orders, but for the at most 30 ms in which a force along another one fades.
  const AxisMapping& axis() const noexcept { return axis_; }
  const Trip& tripped() const noexcept { return safety_.tripped(); }
  const SceneCounters& counters() const noexcept { return insertion_.counters(); }
  /// Share of the thermal budget in use, [0, 1].
  double thermalShare() const noexcept { return safety_.thermalShare(); }
  /// What the motors have given once the last force is over, should no tick follow.
  ThermalBudget thermal() const noexcept { return safety_.thermal(); }
  /// How often the force began anew after a gap between commands.
  std::uint64_t restarts() const noexcept { return safety_.restarts(); }

 private:
  double sources(const ServoTick& tick, double position_mm, double dt_s) noexcept;
  Sample sampleOf(const ServoTick& tick) const noexcept;

  double period_s_;
  Safety safety_;
  InsertionSource insertion_;
  StimulusSource stimulus_;
  std::uint64_t ticks_ = 0;
  std::int64_t last_ns_ = 0;                ///< of the last tick
  bool sampled_ = false;                    ///< the device had a sample at the last tick
  std::optional<std::uint64_t> placement_;  ///< of the last tick
  AxisMapping axis_;                        ///< in force
  double force_n_ = 0;                      ///< of the last tick
};

/// The stiffest spring that stays passive on `device` with a pinch grip: half of b / (T / 2 + delay), b = device + 1.7
/// N s/m (Colgate and Schenkel 1997, with delay as in docs/servo.md), N/mm; no more than the device's maker advises.
double largestStiffnessNMm(const DeviceInfo& device) noexcept;

}  // namespace tactus::haptics
