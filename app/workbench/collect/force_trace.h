// The force of the last seconds, commanded and delivered, as the monitor draws it.
#pragma once

#include <cstdint>
#include <deque>
#include <span>

#include "core/haptics/servo/sample.h"

namespace tactus::workbench {

class ForceTrace {
 public:
  static constexpr double kSeconds = 12;
  static constexpr std::int64_t kStepNs = 5'000'000;  ///< one point for each 5 ms: 2400 points

  struct Point {
    std::int64_t time_ns = 0;
    double commanded_n = 0;  ///< requested by the source
    double delivered_n = 0;  ///< after all limits
    double position_mm = 0;
  };

  void add(std::span<const haptics::Sample> samples);
  void clear();
  /// Oldest first.
  const std::deque<Point>& points() const { return points_; }
  /// Of the newest sample; null before the first.
  const Point* newest() const { return points_.empty() ? nullptr : &points_.back(); }
  /// The newest sample was limited: the force in the hand is not the commanded one.
  bool isCut() const;

 private:
  std::deque<Point> points_;
};

}  // namespace tactus::workbench
