// One insertion stroke that was found in a stream of positions, and what becomes of it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace tactus::experiments {

/// What becomes of a stroke.
enum class StrokeVerdict {
  kAccepted,
  kTooShort,     ///< the way forward is shorter than `shortest_mm`
  kTooBrief,     ///< the movement lasted less than `briefest_s`: the speed cannot be measured
  kBackwards,    ///< the hand went back by `shortest_mm` or more, behind every place where it had been before
  kOutOfRange,   ///< a position lies outside the device's range
  kInterrupted,  ///< samples are missing, or the recording stopped before the movement did
  kRejected,     ///< taken back by the researcher afterwards; never given by the segmentation
};

/// `accepted`, `too_short`, `too_brief`, `backwards`, `out_of_range`, `interrupted`, `rejected`.
std::string_view name(StrokeVerdict verdict) noexcept;

/// The verdict called `name`, or nothing.
std::optional<StrokeVerdict> strokeVerdict(std::string_view name) noexcept;

/// How strokes are found. Each number can be set; the defaults fit Table 1 of the paper (means of 31 to 257 mm/s) on a
/// device with a usable way of about 100 mm (facts on the Touch: position counts of 0.055 mm).
struct StrokeSettings {
  /// A movement begins when the speed over `speed_window_s` rises to this. Larger: slow strokes are missed; smaller:
  /// fidgeting becomes a movement. Tremor of 0.3 mm at 12 Hz leaves 2 mm/s of its 23 mm/s in the default window.
  double start_speed_mm_s = 12;
  /// A movement pauses when the speed over `speed_window_s` falls below this; below `start_speed_mm_s` (hysteresis).
  double stop_speed_mm_s = 6;
  /// The speed at which a stroke begins and ends, measured without delay: its first and last moment at this speed.
  double edge_speed_mm_s = 10;
  double speed_window_s = 0.156;   ///< 0.05 to 0.5; about two periods of tremor, so that most of it cancels
  double longest_pause_s = 0.3;    ///< a longer stop ends the stroke; a shorter one is part of it
  double longest_reversal_mm = 3;  ///< going back further ends the stroke; less is part of it
  double least_mm = 5;             ///< a shorter way forward is fidgeting and no stroke at all
  double shortest_mm = 30;         ///< half of the usual 60 mm; a shorter way has little but ramps
  double briefest_s = 0.1;         ///< the fastest level of Table 1 needs 0.13 s for 60 mm at its mean plus two SD
  double lowest_mm = -1000;        ///< the device's range along the insertion axis; the default refuses nothing
  double highest_mm = 1000;
  double longest_gap_s =
      0.05;  ///< a longer time between two samples interrupts; a mouse gives one each 0.008 to 0.03 s
};

/// Refuses settings that make no sense: numbers that are not finite or not positive, thresholds out of order, an empty
/// range, a range shorter than the shortest stroke.
base::Result<void> validate(const StrokeSettings& settings);

/// A stroke in a stream of positions.
struct Stroke {
  std::size_t first = 0;  ///< index of its first sample, counted over all samples of the stream
  std::size_t last = 0;   ///< one past its last sample
  double start_s = 0;     ///< between samples, in the stream's time
  double end_s = 0;
  double start_mm = 0;
  double end_mm = 0;
  StrokeVerdict verdict = StrokeVerdict::kAccepted;

  double lengthMm() const noexcept { return end_mm - start_mm; }  ///< way forward; negative where it went backwards
  double durationS() const noexcept { return end_s - start_s; }
  bool operator==(const Stroke&) const = default;
};

/// One sentence for the person who moved: what was wrong and what is wanted, without any speed. `Thank you.` where the
/// stroke was accepted.
std::string sentence(const Stroke& stroke, const StrokeSettings& settings);

/// The same where only the verdict is known, as in a stored record.
std::string sentence(StrokeVerdict verdict);

}  // namespace tactus::experiments
