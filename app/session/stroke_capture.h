// Cuts recordings of insertion strokes out of a stream of positions.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "core/study/session_records.h"
#include "experiments/speed_from_positions.h"
#include "experiments/stroke.h"
#include "experiments/stroke_segmentation.h"

namespace tactus::session {

/// A stroke and the recording around it: the arguments of Session::addStroke.
struct CapturedStroke {
  experiments::Stroke stroke;
  study::Recording recording;       ///< channels `time`, from 0, and `depth`
  std::size_t recording_first = 0;  ///< index of its first sample in the stream
};

/// Finds strokes while the samples arrive (stroke_segmentation.h), and keeps the stream around each stroke. Ignores a
/// sample whose time does not increase or that is not finite. Samples before a taken stroke are dropped; all others are
/// kept, 16 bytes each. Thread: any, one at a time. Real-time safe: no.
class StrokeCapture {
 public:
  /// The time kept before and after a stroke, s: enough to find the stroke again in its recording.
  static constexpr double kAroundS = 0.35;

  /// The settings must be valid.
  explicit StrokeCapture(const experiments::StrokeSettings& settings = {})
      : finder_(settings), longest_gap_s_(settings.longest_gap_s) {}

  void add(const experiments::PositionSample& sample);
  /// Samples were lost after the last one: a movement in progress is `interrupted`, and no recording holds samples from
  /// both sides. A pause longer than `longest_gap_s` between samples has the same effect.
  void gap();
  /// Ends the stream.
  void finish() { finder_.finish(); }
  /// The next stroke, or nothing if none is complete.
  std::optional<CapturedStroke> take();

 private:
  experiments::StrokeFinder finder_;
  std::deque<experiments::PositionSample> samples_;
  std::size_t first_ = 0;         ///< index of samples_[0] in the stream
  std::deque<std::size_t> gaps_;  ///< indices of the first samples after gaps
  double longest_gap_s_;
};

}  // namespace tactus::session
