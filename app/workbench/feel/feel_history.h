// The last seconds of what was felt, thin enough to be drawn sixty times a second.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "core/haptics/servo/sample.h"

namespace tactus::workbench {

/// What stands in the force trace for a few ticks.
struct TracePoint {
  double time_s = 0;                 ///< since the start of the run
  double model_n = 0;                ///< fuzzy force F_d
  double friction_n = 0;             ///< resistance that the friction asks for
  double force_n = 0;                ///< resistance that the hand feels, after all limits
  std::optional<double> recorded_n;  ///< the one of the recording whose movement is replayed, at this time
};

/// The force of a recording that is replayed.
struct RecordedForce {
  std::vector<double> time_s;   ///< since the start of the run, rising
  std::vector<double> force_n;  ///< one for each
};

/// Keeps the last kTraceS seconds. The tick with the largest friction of every kTraceStepS stands for all of them, so
/// that no peak is lost.
class FeelHistory {
 public:
  static constexpr double kTraceS = 10;
  static constexpr double kTraceStepS = 0.004;

  void clear();
  /// What the next samples are shown beside, until `clear`.
  void setRecorded(RecordedForce recorded) { recorded_ = std::move(recorded); }
  bool hasRecorded() const { return !recorded_.time_s.empty(); }
  /// Samples in the order of their time.
  void add(const haptics::Sample& sample);

  const std::deque<TracePoint>& trace() const { return trace_; }
  /// Time of the newest sample since the first one, s.
  double nowS() const { return now_s_; }

 private:
  std::optional<double> recordedAt(double time_s) const;

  std::deque<TracePoint> trace_;
  RecordedForce recorded_;
  bool any_ = false;
  std::int64_t start_ns_ = 0;
  double now_s_ = 0;
  std::int64_t step_ = 0;  ///< number of the step that the last point stands for
};

}  // namespace tactus::workbench
