// Trapezoids after implication, with corners more precise than a double.
#pragma once

#include <algorithm>

#include "core/fuzzy/membership.h"

namespace tactus::fuzzy {

/// A position as an unevaluated sum of two doubles. If clipping cuts a ramp that is a few ulps wide, the new corner
/// lies between two neighboring doubles.
struct Position {
  double high;
  double low = 0;  ///< less than half an ulp of `high`

  /// x + offset (Knuth's two-sum).
  static Position beside(double x, double offset) noexcept {
    const double sum = x + offset;
    const double part = sum - x;
    return {sum, (x - (sum - part)) + (offset - part)};
  }
  double minus(const Position& other) const noexcept { return (high - other.high) + (low - other.low); }
  bool operator==(const Position&) const = default;
  // By hand: the compiler makes long code of a default <=>, and centroids compare a lot.
  bool operator<(const Position& other) const noexcept {
    return high < other.high || (high == other.high && low < other.low);
  }
  bool operator>(const Position& other) const noexcept { return other < *this; }
  bool operator<=(const Position& other) const noexcept { return !(other < *this); }
  bool operator>=(const Position& other) const noexcept { return !(*this < other); }
};

/// A trapezoid after implication: 0 at `left`, `height` from `top_left` to `top_right`, 0 at `right`.
struct ImpliedTrapezoid {
  const MembershipFunction* function;
  double height;       ///< of the plateau, relative to the largest strength
  double ramp_height;  ///< height at which the ramps of the uncut term would reach membership 1
  Position left, top_left, top_right, right;

  /// `f` with its ramps cut at `share` of their height. `share` in (0, 1]: the strength for clipping, 1 for scaling.
  /// Thread: any. Real-time safe: yes.
  static ImpliedTrapezoid of(const MembershipFunction& f, double share, double height, double ramp_height) noexcept {
    return {&f,
            height,
            ramp_height,
            {f.a},
            std::min(Position::beside(f.a, share * (f.b - f.a)), {f.b}),
            std::max(Position::beside(f.d, -share * (f.d - f.c)), {f.c}),
            {f.d}};
  }

  /// Height at x in [left, right]. Thread: any. Real-time safe: yes.
  double at(const Position& x) const noexcept {
    const auto& f = *function;
    double share = 1;
    if (x < top_left) {
      share = x.minus(left) / (f.b - f.a);
    } else if (x > top_right) {
      share = right.minus(x) / (f.d - f.c);
    } else {
      return height;
    }
    return std::min(height, share * ramp_height);
  }
};

}  // namespace tactus::fuzzy
