// The velocity filter (two equal first-order low-passes), and the exponential decay for all relaxations of this folder.
#pragma once

namespace tactus::render {

/// The remaining share of a difference after `elapsed_s` of an exponential decay with time constant `constant_s`.
/// Computes exp(-x) as 1 / (1 + x + x²/2 + x³/6). For every x >= 0 this is in (0, 1], falling, and within x⁴/24 of
/// exp(-x). It uses arithmetic only, so all machines get the same bits.
/// `elapsed_s`: > 0. `constant_s`: >= 0; 0 gives 0. Thread: any. Real-time safe: yes.
double decay(double elapsed_s, double constant_s) noexcept;

/// Smaller values become 0, so that a filter at rest never computes with denormal numbers.
inline constexpr double kSmallest = 1e-12;

/// Two cascaded first-order low-passes. At a corner of 25 Hz the delay is 12.7 ms.
struct LowPass {
  double first = 0;
  double value = 0;  ///< the filtered signal

  bool operator==(const LowPass&) const = default;
};

/// The filter after one more sample, constant for `dt_s`. `corner_hz`: > 0, corner of each of the two stages.
/// Thread: any. Real-time safe: yes.
LowPass filtered(LowPass filter, double sample, double corner_hz, double dt_s) noexcept;

}  // namespace tactus::render
