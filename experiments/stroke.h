// One insertion stroke in a stream of positions, and its verdict.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "experiments/speed_from_positions.h"

namespace tactus::experiments {

// Measures the distance and speed of forward motion during a force.

/// Forward travel, and the mean speed over it. Time is divided into blocks of 0.1 s. A block counts if the hand moved
/// forward at `least_mm_s` or faster. Tremor of 0.3 mm moves a resting hand by less than 0.6 mm per block, so it does
/// not count at the default of 10 mm/s. Add the samples from the full force to the answer; pauses and returns between
/// do no harm.
class ForwardMotion {
 public:
  explicit ForwardMotion(double least_mm_s) : least_mm_s_(least_mm_s) {}

  /// Adds a sample. Ignores a sample that is not finite or whose time does not rise.
  void add(const PositionSample& sample);

  double wayMm() const noexcept { return way_mm_; }
  /// Mean speed over the forward travel; 0 without travel.
  double speedMmS() const noexcept { return moving_s_ > 0 ? way_mm_ / moving_s_ : 0; }

 private:
  static constexpr double kBlockS = 0.1;

  double least_mm_s_;
  bool started_ = false;
  PositionSample block_start_;
  PositionSample last_;
  double way_mm_ = 0;
  double moving_s_ = 0;
};

/// The verdict on a stroke.
enum class StrokeVerdict {
  kAccepted,
  kTooShort,     ///< forward travel below `shortest_mm`
  kTooBrief,     ///< duration below `briefest_s`: too short to measure the speed
  kBackwards,    ///< the hand moved back by at least `shortest_mm`, beyond all its earlier positions
  kOutOfRange,   ///< a position lies outside the device's range
  kInterrupted,  ///< samples are missing, or the recording ended during the movement
  kRejected,     ///< rejected by the researcher afterwards; never set by the segmentation
};

/// `accepted`, `too_short`, `too_brief`, `backwards`, `out_of_range`, `interrupted`, `rejected`.
std::string_view name(StrokeVerdict verdict) noexcept;

/// The verdict with this name, or nothing.
std::optional<StrokeVerdict> strokeVerdict(std::string_view name) noexcept;

/// The settings for finding strokes. The defaults fit Table 1 of the paper (means of 31 to 257 mm/s) on a device with a
/// usable travel of about 100 mm (facts on the Touch: position counts of 0.055 mm).
struct StrokeSettings {
  /// A movement starts when the speed over `speed_window_s` rises to this value. A larger value misses slow strokes; a
  /// smaller one accepts fidgeting. Tremor of 0.3 mm at 12 Hz has 23 mm/s, of which 2 mm/s remain in the default
  /// window.
  double start_speed_mm_s = 12;
  /// A movement pauses when the speed over `speed_window_s` falls below this value, which is below `start_speed_mm_s`
  /// (hysteresis).
  double stop_speed_mm_s = 6;
  /// The speed at the ends of a stroke, measured without delay: a stroke lasts from its first to its last moment at
  /// this speed.
  double edge_speed_mm_s = 10;
  double speed_window_s = 0.156;   ///< 0.05 to 0.5; about two periods of tremor, so that most of it cancels
  double longest_pause_s = 0.3;    ///< a longer stop ends the stroke; a shorter one belongs to it
  double longest_reversal_mm = 3;  ///< a longer way back ends the stroke; a shorter one belongs to it
  double least_mm = 5;             ///< less forward travel is fidgeting, not a stroke
  double shortest_mm = 30;         ///< half of the usual 60 mm; a shorter stroke consists mostly of ramps
  double briefest_s = 0.1;         ///< the fastest level of Table 1 needs 0.13 s for 60 mm at its mean plus two SD
  double lowest_mm = -1000;        ///< range of the device along the insertion axis; the default accepts all positions
  double highest_mm = 1000;
  double longest_gap_s =
      0.05;  ///< a longer time between two samples interrupts; a mouse gives one each 0.008 to 0.03 s
};

/// Returns an error for invalid settings: numbers that are not finite or not positive, thresholds out of order, an
/// empty range, a range shorter than the shortest stroke.
base::Result<void> validate(const StrokeSettings& settings);

/// A stroke in a stream of positions.
struct Stroke {
  std::size_t first = 0;  ///< index of its first sample in the stream
  std::size_t last = 0;   ///< index after its last sample
  double start_s = 0;     ///< in the stream's time; may lie between samples
  double end_s = 0;
  double start_mm = 0;
  double end_mm = 0;
  StrokeVerdict verdict = StrokeVerdict::kAccepted;

  double lengthMm() const noexcept { return end_mm - start_mm; }  ///< forward travel; negative for a backward movement
  double durationS() const noexcept { return end_s - start_s; }
  bool operator==(const Stroke&) const = default;
};

/// One sentence for the participant: the problem and the request, without any speed. `Thank you.` if the stroke is
/// accepted.
std::string sentence(const Stroke& stroke, const StrokeSettings& settings);

/// The same for a verdict alone, e.g. of a stored record.
std::string sentence(StrokeVerdict verdict);

}  // namespace tactus::experiments
