// Speeds from quantized positions: four estimators with different trades of noise against lag.
#pragma once

#include <array>
#include <concepts>

#include "core/render/low_pass.h"

namespace tactus::haptics {

/// The common interface. `next` takes the position of a tick and returns the speed in mm/s; the first call returns 0.
/// `position_mm`: finite. `dt_s`: > 0, the time since the previous position. `reset` forgets all positions.
/// Copyable. Real-time safe: yes.
template <typename T>
concept VelocityEstimator = std::copyable<T> && requires(T estimator, double number) {
  { estimator.next(number, number) }
  noexcept->std::same_as<double>;
  { estimator.reset() }
  noexcept;
};

/// The last difference. Lag: half a tick. One count of 0.055 mm within 1 ms gives 55 mm/s.
class DifferenceVelocity {
 public:
  double next(double position_mm, double dt_s) noexcept;
  void reset() noexcept { *this = {}; }

 private:
  double position_mm_ = 0;
  bool any_ = false;
};

/// The difference, filtered by two equal first-order low-passes like in the renderer. Lag at 25 Hz and 1 kHz: 12.3 ms.
class LowPassVelocity {
 public:
  /// `corner_hz`: > 0, corner of each of the two stages.
  explicit LowPassVelocity(double corner_hz = 25) noexcept : corner_hz_(corner_hz) {}

  double next(double position_mm, double dt_s) noexcept;
  void reset() noexcept { *this = LowPassVelocity(corner_hz_); }

 private:
  double corner_hz_;
  DifferenceVelocity difference_;
  render::LowPass filter_;
};

/// First-order adaptive window (Janabi-Sharifi, Hayward and Chen 2000): the slope of a line through the latest
/// positions. The window holds as many positions as stay within a bound of the line. Fast motion gives a short window
/// and little lag; slow motion gives a long window and little noise. Lag: half the window.
class AdaptiveWindowVelocity {
 public:
  enum class Line {
    kEndFit,   ///< through the first and the last position of the window
    kBestFit,  ///< least squares
  };
  static constexpr int kLongestWindow = 15;

  /// `bound_mm`: >= 0, best 1 to 1.5 counts of the device. Below half a count, single counts show as speed; a larger
  /// bound adds lag. `window`: number of differences, [1, kLongestWindow].
  explicit AdaptiveWindowVelocity(Line line, double bound_mm = 0.055, int window = kLongestWindow) noexcept;

  double next(double position_mm, double dt_s) noexcept;
  void reset() noexcept { count_ = 0; }

  /// Number of differences used for the last speed; 0 before the first.
  int window() const noexcept { return used_; }

 private:
  Line line_;
  double bound_mm_;
  int window_;
  int used_ = 0;
  int count_ = 0;   ///< known positions, at most window_ + 1
  int newest_ = 0;  ///< index of the newest position in the two rings
  std::array<double, kLongestWindow + 1> position_mm_{};
  std::array<double, kLongestWindow + 1> dt_s_{};  ///< time since the previous position
};

static_assert(VelocityEstimator<DifferenceVelocity> && VelocityEstimator<LowPassVelocity> &&
              VelocityEstimator<AdaptiveWindowVelocity>);

}  // namespace tactus::haptics
