// The last seconds of the samples, reduced enough to be drawn sixty times a second.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "core/haptics/servo/sample.h"

namespace tactus::workbench {

/// One point of the force trace; it stands for a few ticks.
struct TracePoint {
  double time_s = 0;                 ///< since the start of the run
  double model_n = 0;                ///< fuzzy force F_d
  double friction_n = 0;             ///< resistance that the friction model asks for
  double force_n = 0;                ///< resistance at the hand, after all limits
  std::optional<double> recorded_n;  ///< force of the replayed recording at this time
};

/// The force of the replayed recording.
struct RecordedForce {
  std::vector<double> time_s;   ///< since the start of the run, ascending
  std::vector<double> force_n;  ///< one per time
};

/// Keeps the last kTraceS seconds. In every kTraceStepS the tick with the largest friction stands for all, so that no
/// peak is lost.
class FeelHistory {
 public:
  static constexpr double kTraceS = 10;
  static constexpr double kTraceStepS = 0.004;

  void clear();
  /// The force to draw beside the next samples, until `clear`.
  void setRecorded(RecordedForce recorded) { recorded_ = std::move(recorded); }
  bool hasRecorded() const { return !recorded_.time_s.empty(); }
  /// Adds a sample. Times must ascend.
  void add(const haptics::Sample& sample);

  const std::deque<TracePoint>& trace() const { return trace_; }
  /// Time from the first to the newest sample, s.
  double nowS() const { return now_s_; }

 private:
  std::optional<double> recordedAt(double time_s) const;

  std::deque<TracePoint> trace_;
  RecordedForce recorded_;
  bool any_ = false;
  std::int64_t start_ns_ = 0;
  double now_s_ = 0;
  std::int64_t step_ = 0;  ///< index of the step of the last point
};

}  // namespace tactus::workbench
