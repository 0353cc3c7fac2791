// The last seconds of what was felt, thin enough to be drawn sixty times a second.
#pragma once

#include <cstdint>
#include <deque>

#include "core/haptics/sample.h"

namespace tactus::workbench {

/// What stands in the force trace for a few ticks.
struct TracePoint {
  double time_s = 0;      ///< since the start of the run
  double model_n = 0;     ///< fuzzy force F_d
  double friction_n = 0;  ///< resistance that the friction asks for
  double force_n = 0;     ///< resistance that the hand feels, after all limits
};

/// Keeps the last kTraceS seconds. The tick with the largest friction of every kTraceStepS stands for all of them, so
/// that no peak is lost.
class FeelHistory {
 public:
  static constexpr double kTraceS = 10;
  static constexpr double kTraceStepS = 0.004;

  void clear();
  /// Samples in the order of their time.
  void add(const haptics::Sample& sample);

  const std::deque<TracePoint>& trace() const { return trace_; }
  /// Time of the newest sample since the first one, s.
  double nowS() const { return now_s_; }

 private:
  std::deque<TracePoint> trace_;
  bool any_ = false;
  std::int64_t start_ns_ = 0;
  double now_s_ = 0;
  std::int64_t step_ = 0;  ///< number of the step that the last point stands for
};

}  // namespace tactus::workbench
