// The recent load of the motors, and the force that they may give now.
#pragma once

#include <array>
#include <cstdint>

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

}  // namespace tactus::haptics
