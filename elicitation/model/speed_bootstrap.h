// Confidence intervals of all participants' speed centers and ramps, and of the averaged ramps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
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
  std::vector<RampInterval> averaged;        ///< of BuiltModel::averaged_ramps, for these strokes of these participants
};

/// One StrokeBootstrap per participant. Replicate i of the average is the average of all participants' replicates i.
/// The averaged intervals describe the variation of strokes, not of participants. Their degrees of freedom are those of
/// all participants together (pooledSpread). For the median, each participant counts equally.
/// Thread: any, one at a time, but for addTo.
class SpeedBootstrap {
 public:
  /// The speeds of `built`, made by buildModel from `study` with `settings`. The same seed gives the same replicates.
  /// `keep_going`: asked before each participant; false ends with an error of kind kCancelled. The samples are only
  /// read here; none is kept.
  /// Returns an error for no speeds, or a participant's level with fewer than two strokes.
  static base::Result<SpeedBootstrap> of(const study::Study& study, const BuiltModel& built,
                                         const BuildSettings& settings, std::uint64_t seed = 1,
                                         const std::function<bool()>& keep_going = {});

  /// Adds replicates. With small batches a caller can report, refine and stop.
  void add(std::size_t replicates);
  std::size_t participants() const { return participants_.size(); }
  /// Adds them to one participant alone, several participants at once from several threads, which gives the same
  /// replicates. All must have equally many before anything else is called.
  void addTo(std::size_t participant, std::size_t replicates) { participants_[participant].add(replicates); }
  std::size_t replicates() const { return participants_.front().replicates(); }
  /// The intervals so far; empty lists without replicates.
  StudySpeedIntervals intervals(double coverage = kCoverage) const;

 private:
  SpeedBootstrap(std::vector<StrokeBootstrap> participants, std::vector<Ramp> averaged, std::span<const double> weights,
                 Averaging averaging);

  std::vector<StrokeBootstrap> participants_;
  std::vector<Ramp> averaged_;
  std::vector<double> weights_;
  Averaging averaging_;
};

}  // namespace tactus::elicitation
