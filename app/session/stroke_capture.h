// Cuts the recordings of insertion strokes out of a stream of positions.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "core/study/session_records.h"
#include "experiments/even_positions.h"
#include "experiments/stroke.h"
#include "experiments/stroke_segmentation.h"

namespace tactus::session {

/// A stroke with what was recorded around it: the arguments of Session::addStroke.
struct CapturedStroke {
  experiments::Stroke stroke;
  study::Recording recording;       ///< channels `time`, from 0, and `depth`
  std::size_t recording_first = 0;  ///< place of its first sample in the stream
};

/// Finds strokes while the samples come in (stroke_segmentation.h) and keeps the stream around each of them. A sample
/// whose time does not rise or that is not finite is left out. What comes before a stroke that was taken is forgotten;
/// all else is kept, 16 bytes a sample. Thread: any, one at a time. Real-time safe: no.
class StrokeCapture {
 public:
  /// What is kept before and after a stroke: enough to find it again in its recording.
  static constexpr double kAroundS = 0.35;

  /// The settings must be valid.
  explicit StrokeCapture(const experiments::StrokeSettings& settings = {})
      : finder_(settings), longest_gap_s_(settings.longest_gap_s) {}

  void add(const experiments::PositionSample& sample);
  /// Samples were lost behind the last one: a movement that is going on is `interrupted`, and no recording holds
  /// samples of both sides. A time without samples beyond `longest_gap_s` says the same by itself.
  void gap();
  /// The stream has ended.
  void finish() { finder_.finish(); }
  /// The next stroke, or nothing so far.
  std::optional<CapturedStroke> take();

 private:
  experiments::StrokeFinder finder_;
  std::deque<experiments::PositionSample> samples_;
  std::size_t first_ = 0;         ///< place of samples_[0] in the stream
  std::deque<std::size_t> gaps_;  ///< places of the first samples behind gaps
  double longest_gap_s_;
};

}  // namespace tactus::session
