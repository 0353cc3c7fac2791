// Intervals of real numbers whose ends are rounded outward: what is computed with them is certain.
//
// Every operation widens its ends by one and a half of the last digit, which is more than the rounding to nearest can
// take away. No rounding mode is set, so no optimization can undo it.
#pragma once

#include <algorithm>
#include <cmath>

namespace tactus::contracts {

/// At most `x` of real arithmetic, where `x` was computed with one rounding.
inline double down(double x) noexcept { return x - (std::abs(x) * 0x1.8p-52 + 0x1p-1074); }
inline double up(double x) noexcept { return x + (std::abs(x) * 0x1.8p-52 + 0x1p-1074); }

/// All numbers from `low` to `high`, both finite.
struct Interval {
  double low = 0;
  double high = 0;

  Interval() = default;
  Interval(double x) noexcept : low(x), high(x) {}
  Interval(double from, double to) noexcept : low(from), high(to) {}

  double middle() const noexcept { return std::clamp(low + (high - low) / 2, low, high); }
  double width() const noexcept { return high - low; }
  bool contains(double x) const noexcept { return low <= x && x <= high; }
  bool isZero() const noexcept { return low == 0 && high == 0; }
};

inline Interval operator-(const Interval& x) noexcept { return {-x.high, -x.low}; }
inline Interval operator+(const Interval& x, const Interval& y) noexcept {
  return {down(x.low + y.low), up(x.high + y.high)};
}
inline Interval operator-(const Interval& x, const Interval& y) noexcept { return x + -y; }
inline Interval operator*(const Interval& x, const Interval& y) noexcept {
  const double a = x.low * y.low, b = x.low * y.high, c = x.high * y.low, d = x.high * y.high;
  return {down(std::min(std::min(a, b), std::min(c, d))), up(std::max(std::max(a, b), std::max(c, d)))};
}
/// `y` above 0.
inline Interval operator/(const Interval& x, const Interval& y) noexcept {
  return {down(x.low / (x.low < 0 ? y.low : y.high)), up(x.high / (x.high < 0 ? y.high : y.low))};
}

/// The smallest interval around both.
inline Interval hull(const Interval& x, const Interval& y) noexcept {
  return {std::min(x.low, y.low), std::max(x.high, y.high)};
}
/// What both contain; `x` where rounding leaves nothing.
inline Interval common(const Interval& x, const Interval& y) noexcept {
  const Interval both{std::max(x.low, y.low), std::min(x.high, y.high)};
  return both.low <= both.high ? both : x;
}

}  // namespace tactus::contracts
