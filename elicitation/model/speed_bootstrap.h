// Confidence intervals of all participants' speed centres and ramps, and of the averaged ramps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/model/model_builder.h"
#include "elicitation/speed/stroke_bootstrap.h"

namespace tactus::elicitation {

struct StudySpeedIntervals {
  std::size_t replicates = 0;
  std::vector<SpeedIntervals> participants;  ///< in the order of BuiltModel::speeds
  std::vector<RampInterval> averaged;        ///< of BuiltModel::averaged_ramps: these strokes, these participants
};

/// One StrokeBootstrap per participant, side by side: replicate i of the average is the average of everybody's
/// replicate i. The averaged intervals say how the strokes vary, not how other participants would. Their degrees of
/// freedom are those of all participants together (pooledSpread); the median counts each of them alike there.
/// Thread: any, one at a time.
class SpeedBootstrap {
 public:
  /// The speeds of `built`, which buildModel made of `study` with `settings`. The same seed gives the same replicates.
  /// Refused: no speeds, a level of a participant with fewer than two strokes.
  static base::Result<SpeedBootstrap> of(const study::Study& study, const BuiltModel& built,
                                         const BuildSettings& settings, std::uint64_t seed = 1);

  /// Adds replicates; small batches let a caller report, refine and stop.
  void add(std::size_t replicates);
  std::size_t replicates() const { return participants_.front().replicates(); }
  /// Without replicates all lists of intervals are empty.
  StudySpeedIntervals intervals(double coverage = kCoverage) const;

 private:
  SpeedBootstrap(std::vector<StrokeBootstrap> participants, std::vector<Ramp> averaged, std::vector<double> weights,
                 Averaging averaging);

  std::vector<StrokeBootstrap> participants_;
  std::vector<Ramp> averaged_;
  std::vector<double> weights_;
  Averaging averaging_;
};

}  // namespace tactus::elicitation
