// The speeds of recorded strokes, and their mean and standard deviation per stroke and per level.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/study/session_records.h"
#include "experiments/speed_from_positions.h"

namespace tactus::experiments {

/// The motion between the first and the last sample of a stroke, each 1 ms, from `depth` (and `time`, where it was
/// recorded) as in speed_from_positions.h: time and depth from 0 at the stroke's start, all rounded to a millionth. A
/// recording with a channel `speed`, as imported tables have it, is taken as it is. Refused: a recording without
/// `depth`, a stroke that lies outside its recording, positions that speedFromPositions refuses.
base::Result<std::vector<MotionSample>> strokeMotion(const study::StrokeRecord& record);

/// The speeds of strokeMotion, mm/s. The channel `speed` is enough for them.
base::Result<std::vector<double>> strokeSpeeds(const study::StrokeRecord& record);

/// Mean and standard deviation of the speeds of one stroke, or of all strokes of a level as in Table 1.
struct SpeedStatistics {
  std::string level;
  int number = 0;  ///< of the stroke; 0 for a whole level
  std::size_t strokes = 0;
  std::size_t samples = 0;
  double mean_mm_s = 0;
  double sd_mm_s = 0;  ///< n - 1 in the denominator; 0 for one sample

  bool operator==(const SpeedStatistics&) const = default;
};

struct SessionSpeeds {
  std::vector<SpeedStatistics> strokes;  ///< in the order of the records
  std::vector<SpeedStatistics> levels;  ///< over all samples of the level's strokes, in the order of their first stroke
};

/// Of one session: its accepted strokes that no later record corrects; practice is left out. For researchers, never for
/// the participant.
base::Result<SessionSpeeds> speedStatistics(std::span<const study::StrokeRecord> records);

}  // namespace tactus::experiments
