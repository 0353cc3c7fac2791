// Finds insertion strokes in a stream of positions.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "experiments/even_positions.h"
#include "experiments/movement_detector.h"
#include "experiments/stroke.h"

namespace tactus::experiments {

/// Finds strokes while samples arrive.
///
/// A stroke starts when the hand's speed reaches `start_speed_mm_s`. It ends when the speed stays below
/// `stop_speed_mm_s` for longer than `longest_pause_s`, or when the hand moves back by more than `longest_reversal_mm`.
/// This decision uses the slope over `speed_window_s`. Then both ends are measured again without delay, on the movement
/// without tremor (smooth_motion.h), at its speed `edge_speed_mm_s`. A movement back to earlier positions is a return,
/// not a stroke. Neither is a forward movement of less than `least_mm`.
///
/// Samples may arrive at any rate above about 60 Hz, evenly or not. A sample is ignored if its time does not rise, it
/// is not finite, or it is further away than a kilometer; it still counts for `first` and `last`. The strokes depend on
/// the samples only, not on the times of the calls.
class StrokeFinder {
 public:
  /// The settings must be valid (checked as our own bug; see `validate`).
  explicit StrokeFinder(const StrokeSettings& settings = {});

  /// Adds the next sample. Thread: any, one at a time. Real-time safe: no.
  void add(const PositionSample& sample);
  /// Ends the stream. A movement in progress becomes `interrupted`.
  void finish();
  /// The next stroke in time order; nothing if there is none yet. A stroke is available about 0.7 s after its end.
  std::optional<Stroke> take();

  /// Whether the hand is currently moving forward, as far as known. For display.
  bool moving() const noexcept { return stretch_ && stretch_->detector.movingForward(); }

 private:
  struct Taken {
    PositionSample sample;
    std::size_t index;
  };
  struct Edge {
    double time_s;
    double position_mm;
  };
  /// The data since the last gap.
  struct Stretch {
    Stretch(const StrokeSettings& settings, const PositionSample& first, double lowest_been_mm)
        : positions(first), detector(settings, lowest_been_mm) {}
    EvenPositions positions;
    MovementDetector detector;
    std::deque<Taken> samples;
    std::deque<Movement> to_measure;
  };

  void endStretch();
  void advance(bool ended);
  void measure(const Movement& movement);
  Edge edgeOf(const Movement& movement, bool at_start) const;
  StrokeVerdict verdictOf(const Stroke& stroke, const Movement& movement) const;
  void forget();

  StrokeSettings settings_;
  std::optional<Stretch> stretch_;
  std::optional<double> lowest_been_mm_;
  std::size_t sample_count_ = 0;
  std::deque<Stroke> strokes_;
};

/// The strokes of a whole recording, equal to those of a StrokeFinder. Returns the error of `validate` for invalid
/// settings.
base::Result<std::vector<Stroke>> findStrokes(std::span<const PositionSample> samples,
                                              const StrokeSettings& settings = {});

}  // namespace tactus::experiments
