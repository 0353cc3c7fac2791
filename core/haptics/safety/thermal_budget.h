// The recent load of the motors, and the force that they may give now.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace tactus::haptics {

/// Keeps the mean of F² over every window of `window_s` at or below the square of the continuous rating. This holds if
/// the force stays at or below `ceilingN` and ticks are less than 2 s apart.
/// Method: F² may be at most (remaining budget) / 2 s. So the remaining budget shrinks exponentially and never reaches
/// 0. The energy is kept in 120 parts of the window; a part is dropped when all of it is older than the window. The
/// ceiling falls by at most F / 4 s and rises by 0.5 N/s, so the hand feels both as a slow fade.
/// Plain state of fixed size. Thread: servo. Real-time safe: yes.
class ThermalBudget {
 public:
  /// `held_n`: the force since the last call. `rating_n`: >= 0, allowed rms. `window_s`: > 0.
  void advance(std::int64_t now_ns, double held_n, double rating_n, double window_s) noexcept;

  /// As `advance`, with the last rating and window, and without a new ceiling.
  void spend(std::int64_t now_ns, double held_n) noexcept;

  /// As `advance`, at the time of the last call: a new rating or window takes effect. `rating_n` and `window_s` as
  /// there.
  void refresh(double rating_n, double window_s) noexcept { advance(now_ns_, 0, rating_n, window_s); }

  /// The reserve: an unchanged force would use up the budget in this time, s. A longer reserve makes the force fade
  /// earlier and more slowly. It must exceed the longest time that a device holds a force without a tick.
  static constexpr double kReserveS = 2;
  /// The longest time, s, for which the last force warms the motors of any device that gets no commands.
  static constexpr double kLongestHeldS = 2;
  /// How fast the ceiling comes back, N/s.
  static constexpr double kRecoveryNS = 0.5;

  /// What counts of the load so far while no force is given: `spent_n2s` until `until_s` after the last call.
  struct Cooling {
    double until_s = 0;
    double spent_n2s = 0;
  };
  static constexpr int kCoolingSteps = 121;
  /// Step `i` from 0; after the last one nothing counts. After the first `advance`.
  Cooling cooling(int i) const noexcept;

  /// The largest force allowed now; infinite before the first `advance`.
  double ceilingN() const noexcept { return ceiling_n_; }
  /// Used share of the budget, [0, 1].
  double share() const noexcept;

 private:
  static constexpr int kParts = kCoolingSteps - 1;

  void forgetUntil(std::int64_t part) noexcept;

  std::array<double, kParts + 1> spent_n2s_{};  ///< the parts of the window, plus the part that is leaving it
  double sum_n2s_ = 0;
  double budget_n2s_ = 0;
  double ceiling_n_ = 1e300;
  std::int64_t part_ns_ = 0;  ///< length of a part; 0 before the first call
  std::int64_t part_ = 0;     ///< number of the current part
  std::int64_t start_ns_ = 0;
  std::int64_t now_ns_ = 0;
};

// The recent motor load of each device, kept while the program runs.

/// Motors stay warm when a servo ends. The next servo on the same device continues with the budget stored here; the
/// time between counts as rest. All servos of a ledger use the same clock. The composition root owns the ledger of the
/// process and passes it on. Thread: any.
class ThermalLedger {
 public:
  /// The last stored budget of the device `id`; an unused one if the device is unknown.
  ThermalBudget of(const std::string& id) const;
  /// Stores the budget of a device. Call when the servo on it has ended.
  void keep(const std::string& id, const ThermalBudget& budget);

 private:
  mutable std::mutex mutex_;
  std::map<std::string, ThermalBudget> budgets_;
};

// How long motors must rest before they can hold a force.

/// A force that the servo is to give in full: the heat of the motors must not limit it.
struct PlannedHold {
  double force_n = 0;  ///< >= 0
  double ramp_s = 0;   ///< from zero to the force, linearly; >= 0
  double hold_s = 0;   ///< at the full force; >= 0
};

/// The shortest rest without force, s, counted from the last call of the budget, after which the ceiling of the budget
/// stays at or above `planned.force_n` through ramp and hold. A longer rest is as good. Nothing if cold motors cannot
/// hold it either. `rating_n`, `window_s`: as in ThermalBudget::advance.
/// Exact for the budget's rule (remaining energy / 2 s, parts of the window, recovery by 0.5 N/s); ticks of up to 2 ms
/// are counted in. Example: a Touch (0.88 N over 60 s) that held 1.7 N four times for 3 s, every 6 s, rests 37.4 s
/// before the fifth time. Thread: any. Real-time safe: yes.
std::optional<double> restBeforeS(ThermalBudget budget, const PlannedHold& planned, double rating_n,
                                  double window_s) noexcept;

/// The largest force, N, that cold motors can hold through `ramp_s` and `hold_s`.
double largestHoldN(double ramp_s, double hold_s, double rating_n, double window_s) noexcept;

}  // namespace tactus::haptics
