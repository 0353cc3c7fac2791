// Confidence intervals of one participant's speed centres and ramps, from drawing whole strokes anew.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/study/records.h"
#include "elicitation/speed/draw_interval.h"
#include "elicitation/speed/participant_speeds.h"
#include "elicitation/speed/speed_terms.h"
#include "elicitation/speed/stroke_resampling.h"

namespace tactus::elicitation {

/// Replicates for intervals that are to be printed; fewer serve while a person moves a slider.
inline constexpr std::size_t kBootstrapReplicates = 2000;
/// The intervals of the two ends of a ramp.
struct RampInterval {
  Interval p;
  Interval q;
};

/// What a participant's strokes say of the draws of each end of a ramp.
struct RampSpread {
  DrawSpread p;
  DrawSpread q;
};

struct SpeedIntervals {
  std::size_t replicates = 0;
  std::vector<Interval> centres;    ///< ascending
  std::vector<RampInterval> ramps;  ///< one for each gap
};

/// Adds replicates in batches of any size and knows the intervals after each, so that a first answer is there at once
/// and gets finer while there is time; whoever stops adding has cancelled. Which batches made the replicates does not
/// matter. One replicate of 24,000 samples takes some tens of microseconds.
/// Each replicate draws as many strokes as a level has, with replacement, level by level, and computes the centres of
/// their samples: clusters by going downhill from the participant's own centres (the valley is kept, no other minimum
/// is looked for), or the means of the levels in ascending order; then the ramps. A draw whose centres coincide, or
/// that has fewer different speeds than clusters, is drawn again; where that never ends, as with strokes of next to no
/// variation, the replicate has the participant's own centres.
/// Thread: any, one at a time.
class StrokeBootstrap {
 public:
  /// `samples` are those that gave `centres` (after trimming), all of one participant; `levels` and `settings` as for
  /// clusterSpeeds. Refused: a level with fewer than two strokes, because nothing can be drawn there.
  static base::Result<StrokeBootstrap> of(std::span<const study::SpeedSample> samples,
                                          std::span<const std::string> levels, std::span<const double> centres,
                                          const SpeedSettings& settings, std::uint64_t seed);

  void add(std::size_t replicates);
  std::size_t replicates() const { return ramps_.size(); }
  /// The centres and the ramps of every replicate so far.
  std::span<const std::vector<double>> centres() const { return centres_; }
  std::span<const std::vector<Ramp>> ramps() const { return ramps_; }
  /// Around the participant's own centres and ramps (drawInterval). Without replicates all lists are empty.
  SpeedIntervals intervals(double coverage = kCoverage) const;
  /// One for each gap.
  const std::vector<RampSpread>& rampSpreads() const { return ramp_spreads_; }
  /// What no centre or ramp of the person is below: 0 mm/s, or the lowest sample where the data go below it.
  double lowest() const { return std::min(0.0, strokes_.lowest()); }

 private:
  StrokeBootstrap(StrokeResampler strokes, std::vector<double> centres, const SpeedSettings& settings,
                  std::uint64_t seed);

  /// Of the strokes drawn; empty where they have fewer different speeds than clusters.
  std::vector<double> centresNow();
  std::vector<double> drawnCentres();
  /// The centres and then the ends of the ramps.
  std::vector<double> valuesOf(const std::vector<double>& centres) const;
  void setSpreads();

  StrokeResampler strokes_;
  std::vector<double> own_mm_s_;  // centres of all strokes
  std::vector<double> start_;     // the same, scaled
  SpeedSettings settings_;
  base::Random random_;
  std::vector<DrawSpread> centre_spreads_;
  std::vector<RampSpread> ramp_spreads_;
  std::vector<std::vector<double>> centres_;  // one list per replicate
  std::vector<std::vector<Ramp>> ramps_;
};

}  // namespace tactus::elicitation
