#include "core/haptics/device/velocity_estimator.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace tactus::haptics {
namespace {

/// A position and its time, seen from the newest.
struct Point {
  double ago_s = 0;
  double behind_mm = 0;
};

struct Fit {
  double offset_mm = 0;
  double slope_mm_s = 0;
};

/// What a least-squares line through points needs; all points are near 0, so nothing cancels.
struct Sums {
  int count = 0;
  double t = 0, y = 0, tt = 0, ty = 0;

  void add(const Point& point) noexcept {
    ++count;
    t += point.ago_s;
    y += point.behind_mm;
    tt += point.ago_s * point.ago_s;
    ty += point.ago_s * point.behind_mm;
  }
  Fit fit() const noexcept {
    const double slope_mm_s = (count * ty - t * y) / (count * tt - t * t);
    return {(y - slope_mm_s * t) / count, slope_mm_s};
  }
};

}  // namespace

double DifferenceVelocity::next(double position_mm, double dt_s) noexcept {
  const double speed_mm_s = any_ ? (position_mm - position_mm_) / dt_s : 0;
  position_mm_ = position_mm;
  any_ = true;
  return speed_mm_s;
}

double LowPassVelocity::next(double position_mm, double dt_s) noexcept {
  filter_ = render::filtered(filter_, difference_.next(position_mm, dt_s), corner_hz_, dt_s);
  return filter_.value;
}

AdaptiveWindowVelocity::AdaptiveWindowVelocity(Line line, double bound_mm, int window) noexcept
    : line_(line), bound_mm_(bound_mm), window_(window) {
  TACTUS_CHECK(bound_mm >= 0 && window >= 1 && window <= kLongestWindow);
}

double AdaptiveWindowVelocity::next(double position_mm, double dt_s) noexcept {
  const int room = window_ + 1;
  newest_ = (newest_ + 1) % room;
  position_mm_[static_cast<std::size_t>(newest_)] = position_mm;
  dt_s_[static_cast<std::size_t>(newest_)] = dt_s;
  count_ = std::min(count_ + 1, room);

  std::array<Point, kLongestWindow + 1> points;
  int place = newest_;
  for (int i = 1; i < count_; ++i) {
    const double ago_s = points[static_cast<std::size_t>(i) - 1].ago_s + dt_s_[static_cast<std::size_t>(place)];
    place = (place + room - 1) % room;
    points[static_cast<std::size_t>(i)] = {ago_s, position_mm - position_mm_[static_cast<std::size_t>(place)]};
  }

  used_ = 0;
  double speed_mm_s = 0;
  Sums sums;
  sums.add(points[0]);
  for (int window = 1; window < count_; ++window) {
    const Point& first = points[static_cast<std::size_t>(window)];
    sums.add(first);
    const Fit line = line_ == Line::kEndFit ? Fit{0, first.behind_mm / first.ago_s} : sums.fit();
    const auto within = [&](const Point& point) {
      return std::abs(point.behind_mm - line.offset_mm - line.slope_mm_s * point.ago_s) <= bound_mm_;
    };
    // Two positions always lie on their line, whatever rounding says.
    if (window > 1 && !std::all_of(points.begin(), points.begin() + window + 1, within)) break;
    used_ = window;
    speed_mm_s = line.slope_mm_s;
  }
  return speed_mm_s;
}

}  // namespace tactus::haptics
