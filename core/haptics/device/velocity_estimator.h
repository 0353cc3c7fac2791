// Speeds from counted positions: four ways that trade noise against lag.
#pragma once

#include <array>
#include <concepts>

#include "core/render/low_pass.h"

namespace tactus::haptics {

/// What they share: `next` takes the position of a tick and gives the speed, mm/s; the first position gives 0.
/// `position_mm` must be finite; `dt_s` > 0, the time since the position before. `reset` forgets all positions.
/// Copyable. Real-time safe: yes.
template <typename T>
concept VelocityEstimator = std::copyable<T> && requires(T estimator, double number) {
  { estimator.next(number, number) }
  noexcept->std::same_as<double>;
  { estimator.reset() }
  noexcept;
};

/// The last difference. Lag: half a tick. One count of 0.055 mm within 1 ms is 55 mm/s.
class DifferenceVelocity {
 public:
  double next(double position_mm, double dt_s) noexcept;
  void reset() noexcept { *this = {}; }

 private:
  double position_mm_ = 0;
  bool any_ = false;
};

/// The difference through the renderer's two equal first-order low-passes. Lag at 25 Hz and 1 kHz: 12.3 ms.
class LowPassVelocity {
 public:
  /// `corner_hz` > 0, of each of the two stages.
  explicit LowPassVelocity(double corner_hz = 25) noexcept : corner_hz_(corner_hz) {}

  double next(double position_mm, double dt_s) noexcept;
  void reset() noexcept { *this = LowPassVelocity(corner_hz_); }

 private:
  double corner_hz_;
  DifferenceVelocity difference_;
  render::LowPass filter_;
};

/// First-order adaptive window (Janabi-Sharifi, Hayward and Chen 2000): the slope of a line through as many of the
/// latest positions as stay within a bound of it. Fast motion gives a short window and little lag, slow motion a long
/// one and little noise. Lag: half the window.
class AdaptiveWindowVelocity {
 public:
  enum class Line {
    kEndFit,   ///< through the first and the last position of the window
    kBestFit,  ///< least squares
  };
  static constexpr int kLongestWindow = 15;

  /// `bound_mm` >= 0: 1 to 1.5 counts of the device; below half a count it sees single counts, above it lags.
  /// `window` in [1, kLongestWindow]: differences in it.
  explicit AdaptiveWindowVelocity(Line line, double bound_mm = 0.055, int window = kLongestWindow) noexcept;

  double next(double position_mm, double dt_s) noexcept;
  void reset() noexcept { count_ = 0; }

  /// Differences in the window of the last speed; 0 before there was one.
  int window() const noexcept { return used_; }

 private:
  Line line_;
  double bound_mm_;
  int window_;
  int used_ = 0;
  int count_ = 0;   ///< positions that are known, at most window_ + 1
  int newest_ = 0;  ///< place of the newest in the two rings
  std::array<double, kLongestWindow + 1> position_mm_{};
  std::array<double, kLongestWindow + 1> dt_s_{};  ///< time between a position and the one before it
};

static_assert(VelocityEstimator<DifferenceVelocity> && VelocityEstimator<LowPassVelocity> &&
              VelocityEstimator<AdaptiveWindowVelocity>);

}  // namespace tactus::haptics
