// How much force the motors have given lately, and how much they may give now.
#pragma once

#include <array>
#include <cstdint>

namespace tactus::haptics {

/// The mean of F² over every window of `window_s` stays at or below the square of the continuous rating, wherever the
/// window begins, as long as the force stays at or below `ceilingN` and ticks are less than 2 s apart.
/// The way: F² may be at most (what is left of the budget) / 2 s, so that what is left shrinks exponentially and is
/// never used up. Energy is kept in 120 parts of the window, and a part is forgotten only when all of it is older than
/// the window. The ceiling falls with F / 4 s at most and rises with 0.5 N/s, so both are felt as a slow fade.
/// Plain state of fixed size. Thread: servo. Real-time safe: yes.
class ThermalBudget {
 public:
  /// `held_n` was the force since the last call. `rating_n` >= 0: rms allowed; `window_s` > 0.
  void advance(std::int64_t now_ns, double held_n, double rating_n, double window_s) noexcept;

  /// As `advance`, with the rating and the window of the last call and without a new ceiling.
  void spend(std::int64_t now_ns, double held_n) noexcept;

  /// The largest force for now; infinite before the first `advance`.
  double ceilingN() const noexcept { return ceiling_n_; }
  /// Share of the budget in use, [0, 1].
  double share() const noexcept;

 private:
  static constexpr int kParts = 120;

  void forgetUntil(std::int64_t part) noexcept;

  std::array<double, kParts + 1> spent_n2s_{};  ///< the window in parts, and the part that is leaving it
  double sum_n2s_ = 0;
  double budget_n2s_ = 0;
  double ceiling_n_ = 1e300;
  std::int64_t part_ns_ = 0;  ///< length of a part; 0: nothing happened yet
  std::int64_t part_ = 0;     ///< number of the present part
  std::int64_t start_ns_ = 0;
  std::int64_t now_ns_ = 0;
};

}  // namespace tactus::haptics
