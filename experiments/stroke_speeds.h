// The speeds of recorded strokes, and their mean and standard deviation per stroke and level.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/study/records.h"
#include "core/study/session_records.h"
#include "experiments/speed_from_positions.h"

namespace tactus::experiments {

/// The content of Table 1: mean and standard deviation of the insertion speed, per participant and level.
struct SpeedSummary {
  std::string participant;
  std::string level;
  std::size_t strokes = 0;
  std::size_t samples = 0;
  double mean_mm_s = 0;
  double sd_mm_s = 0;  ///< n - 1 in the denominator; 0 for one sample
};

/// One summary per participant and level, over all samples of their strokes (paper, Table 1), in the order of first
/// appearance in `samples`.
std::vector<SpeedSummary> summarizeSpeeds(std::span<const study::SpeedSample> samples);

/// The motion between the first and the last sample of a stroke, in steps of 1 ms, from `depth` (and `time`, if
/// recorded) as in speed_from_positions.h. Time and depth start at 0; all values are rounded to a millionth. A
/// recording with a channel `speed`, as in imported tables, is used unchanged. Returns an error for a recording without
/// `depth`, a stroke outside its recording, or positions that speedFromPositions refuses.
base::Result<std::vector<MotionSample>> strokeMotion(const study::StrokeRecord& record);

/// The speeds of strokeMotion, mm/s. A recording with only the channel `speed` is enough.
base::Result<std::vector<double>> strokeSpeeds(const study::StrokeRecord& record);

/// Mean and standard deviation of the speeds of one stroke, or of all strokes of a level as in Table 1.
struct SpeedStatistics {
  std::string level;
  int number = 0;  ///< number of the stroke; 0 for a whole level
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

/// The speeds of one session: its accepted strokes without a later correction, without practice. For the researcher,
/// never for the participant.
base::Result<SessionSpeeds> speedStatistics(std::span<const study::StrokeRecord> records);

}  // namespace tactus::experiments
