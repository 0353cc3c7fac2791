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

/// Finds strokes while the samples come in.
///
/// A stroke begins where the hand's speed reaches `start_speed_mm_s` and ends where it stays under `stop_speed_mm_s`
/// for longer than `longest_pause_s`, or where the hand goes back by more than `longest_reversal_mm`. That is decided
/// on the slope over `speed_window_s`. Then both ends are measured again without delay on the movement without tremor
/// (smooth_motion.h): they are where its speed passes `edge_speed_mm_s`. Moving back to where the hand has been before
/// is a return and no stroke, and so is moving forward by less than `least_mm`.
///
/// Samples may come at any rate from about 60 Hz up, evenly or not. A sample whose time does not rise, that is not
/// finite or further away than a kilometre is left out, but counts for `first` and `last`. The strokes depend on the
/// samples only, not on when they are taken.
class StrokeFinder {
 public:
  /// The settings must be valid (a check of our own code; see `validate`).
  explicit StrokeFinder(const StrokeSettings& settings = {});

  /// Takes the next sample. Thread: any, one at a time. Real-time safe: no.
  void add(const PositionSample& sample);
  /// The stream has ended: what is open is closed, and a movement that is not over is `interrupted`.
  void finish();
  /// The next stroke, in the order of time, or nothing so far. A stroke comes about 0.7 s after its end.
  std::optional<Stroke> take();

  /// Whether the hand is moving forward, as far as it is known: for a screen.
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
  /// What is known since the last gap.
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

/// The strokes of a whole recording: the same as from a StrokeFinder that was fed and finished. Refuses settings that
/// `validate` refuses.
base::Result<std::vector<Stroke>> findStrokes(std::span<const PositionSample> samples,
                                              const StrokeSettings& settings = {});

}  // namespace tactus::experiments
