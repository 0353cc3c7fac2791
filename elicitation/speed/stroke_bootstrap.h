// Confidence intervals of one participant's speed centers and ramps, by a bootstrap over whole strokes.
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
#include "elicitation/speed/stroke_sums.h"

namespace tactus::elicitation {

/// Number of replicates for printed intervals. Fewer are enough while the user moves a slider.
inline constexpr std::size_t kBootstrapReplicates = 2000;
/// The intervals of the two ends of a ramp.
struct RampInterval {
  Interval p;
  Interval q;
};

/// The spreads of the two ends of a ramp (DrawSpread).
struct RampSpread {
  DrawSpread p;
  DrawSpread q;
};

struct SpeedIntervals {
  std::size_t replicates = 0;
  std::vector<Interval> centres;    ///< ascending
  std::vector<RampInterval> ramps;  ///< one per gap
};

/// Adds replicates in batches of any size and gives the intervals after each batch, so that a first result is available
/// at once and improves over time. The caller cancels by adding no more. The batch sizes do not affect the result. One
/// replicate of 24,000 samples takes some tens of microseconds.
/// Each replicate draws, for each level, as many strokes as the level has, with replacement. Then it computes the
/// centers of their samples and the ramps. Cluster centers come from one descent from where Newton's step from the
/// participant's own centers leads, or from those if it leads far; other minima are not searched. Level means are
/// sorted. If centers coincide, or there are fewer different speeds than clusters, the draw is repeated. If that does
/// not end (strokes with almost no variation), the replicate uses the participant's own centers. Thread: any, one at a
/// time.
class StrokeBootstrap {
 public:
  /// `samples`: those that gave `centres` (after trimming), of one participant. `levels`, `settings`: as for
  /// clusterSpeeds. Returns an error for a level with fewer than two strokes, because there is no choice to draw from.
  static base::Result<StrokeBootstrap> of(std::span<const study::SpeedSample> samples,
                                          std::span<const std::string> levels, std::span<const double> centres,
                                          const SpeedTermSettings& settings, std::uint64_t seed);

  void add(std::size_t replicates);
  std::size_t replicates() const { return ramps_.size(); }
  /// The centers and the ramps of every replicate so far.
  std::span<const std::vector<double>> centres() const { return centres_; }
  std::span<const std::vector<Ramp>> ramps() const { return ramps_; }
  /// Intervals around the participant's own centers and ramps (drawInterval). Empty lists without replicates.
  SpeedIntervals intervals(double coverage = kCoverage) const;
  /// One per gap.
  const std::vector<RampSpread>& rampSpreads() const { return ramp_spreads_; }
  /// Lower bound of centers and ramps: 0 mm/s, or the lowest sample if that is below 0.
  double lowest() const { return std::min(0.0, strokes_.lowest()); }

 private:
  StrokeBootstrap(StrokeResampler strokes, std::vector<double> centres, const SpeedTermSettings& settings,
                  std::uint64_t seed);

  /// The centers of the drawn strokes; empty if they have fewer different speeds than clusters.
  std::vector<double> centresNow();
  std::vector<double> drawnCentres();
  /// The centers, then the ends of the ramps.
  std::vector<double> valuesOf(const std::vector<double>& centres) const;
  void setSpreads();

  StrokeResampler strokes_;
  std::vector<double> own_mm_s_;  // centers of all strokes
  std::vector<double> start_;     // the same, scaled
  StrokeSums sums_;               // at start_, for clusters
  SpeedTermSettings settings_;
  base::Random random_;
  std::vector<DrawSpread> centre_spreads_;
  std::vector<RampSpread> ramp_spreads_;
  std::vector<std::vector<double>> centres_;  // one list per replicate
  std::vector<std::vector<Ramp>> ramps_;
};

}  // namespace tactus::elicitation
