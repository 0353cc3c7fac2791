#include "core/render/low_pass.h"

#include <cmath>
#include <numbers>

namespace tactus::render {

namespace {

double withoutDust(double value) noexcept { return std::abs(value) < kSmallest ? 0 : value; }

}  // namespace

double decay(double elapsed_s, double constant_s) noexcept {
  const double x = elapsed_s / constant_s;
  return 1 / (1 + x * (1 + x * (0.5 + x / 6)));
}

LowPass filtered(LowPass filter, double sample, double corner_hz, double dt_s) noexcept {
  const double left = decay(dt_s, 1 / (2 * std::numbers::pi * corner_hz));
  LowPass next;
  next.first = withoutDust(sample + (filter.first - sample) * left);
  next.value = withoutDust(next.first + (filter.value - next.first) * left);
  return next;
}

}  // namespace tactus::render
