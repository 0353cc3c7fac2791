// Confidence intervals of one participant's speed centers and ramps, by a bootstrap over whole strokes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/study/records.h"
#include "elicitation/speed/participant_speeds.h"
#include "elicitation/speed/speed_terms.h"

namespace tactus::elicitation {

// Quantiles of Student's t distribution.

/// The `share` quantile, `share` in [0, 1], of Student's t distribution with `degrees` > 0 (any real number); infinite
/// at 0 and 1. Relative error below 1e-10.
double studentQuantile(double share, double degrees);

// Converts the spread of bootstrap draws to an interval with the stated coverage, for few strokes and many.

/// Default probability with which an interval contains the true value.
inline constexpr double kCoverage = 0.95;

/// The method of all speed intervals, for reports.
inline constexpr std::string_view kIntervalMethod = "student_t_of_draws";

struct Interval {
  double low = 0;
  double high = 0;
};

/// The information that the strokes of a value give about its draws. n strokes drawn from n vary by (n - 1) / n of the
/// variance of n new strokes. That variance has n - 1 degrees of freedom.
struct DrawSpread {
  double widening = 1;  ///< factor for the variance of the draws: n / (n - 1)
  double degrees = 1;   ///< degrees of freedom: n - 1
};

/// For n >= 2 strokes.
DrawSpread spreadOf(std::size_t strokes);

/// For a value whose variance is the sum of independent parts, from strokes of one person. `variances`: variance (>= 0)
/// of the draws of each part. `parts`: the spread of each part. The degrees of freedom are the harmonic mean, weighted
/// by the widened variances. If all variances are 0: the smallest degrees.
DrawSpread mixedSpread(std::span<const double> variances, std::span<const DrawSpread> parts);

/// The same for the mean of several persons, whose variances are estimated independently (Welch 1947, Satterthwaite
/// 1946). Gives more degrees of freedom than each person has.
DrawSpread pooledSpread(std::span<const double> variances, std::span<const DrawSpread> persons);

/// value +- t * sqrt(widening) * standard deviation of `draws`, where t has the degrees of freedom of `spread`. The
/// lower end is at least `lowest`, the smallest possible value. `coverage`: [0, 1).
/// For a nominal 95 % and 4, 6 and 12 strokes per level, it covers 92 to 97 %; the middle 95 % of the draws cover 77 to
/// 90 % (Hesterberg 2015; tests/elicitation/interval_coverage_test.cpp).
Interval drawInterval(double value, const std::vector<double>& draws, const DrawSpread& spread, double lowest,
                      double coverage);

// Draws whole strokes of one participant within each level, in a form that is fast to cluster again.

/// Samples within a stroke are not independent, so an interval must draw strokes, not samples. Strokes are stored as
/// histograms of kBins bins over the range of all samples, each bin with its mean. The error is of second order in the
/// bin width: below 0.001 mm/s of a center for speeds of 0 to 500 mm/s.
class StrokeResampler {
 public:
  static constexpr std::size_t kBins = 512;

  /// `samples`: of one participant, all finite, at least two different speeds, each of a level in `levels`.
  StrokeResampler(std::span<const study::SpeedSample> samples, std::span<const std::string> levels);

  /// The first level with fewer than two strokes: its index and its number of strokes. Nothing if every level has two.
  std::optional<std::pair<std::size_t, std::size_t>> levelWithoutChoice() const;

  /// Draws as many strokes as each level has, with replacement.
  void draw(base::Random& random);
  /// Takes every stroke once.
  void takeAll();
  /// Takes one stroke once and no other (indices from 0).
  void takeOnly(std::size_t level, std::size_t stroke);
  /// Takes every stroke once except this one (indices from 0).
  void leaveOut(std::size_t level, std::size_t stroke);
  /// The number of strokes of each level.
  std::vector<std::size_t> strokeCounts() const;
  /// How often each stroke of each level is taken.
  std::span<const std::vector<double>> times() const { return times_; }

  /// The samples of the drawn strokes, ascending, scaled to [-1, 1], and the number of samples that each represents.
  std::span<const double> values() const { return values_; }
  std::span<const double> weights() const { return weights_; }
  double toScaled(double speed_mm_s) const { return (speed_mm_s - middle_mm_s_) / half_range_mm_s_; }
  double toOriginal(double scaled) const { return middle_mm_s_ + half_range_mm_s_ * scaled; }
  /// The lowest of all samples, in mm/s.
  double lowest() const { return toOriginal(-1); }

  /// The mean of each level's samples in the drawn strokes, in mm/s, exact. Every level must have strokes.
  std::vector<double> levelMeans() const;

 private:
  struct StrokeBins {
    double count = 0;
    double sum = 0;                    // of scaled speeds
    std::size_t first = 0;             // bin of its lowest speed
    std::vector<double> counts, sums;  // of each bin from there to that of its highest speed
  };

  void collect();

  double middle_mm_s_ = 0;
  double half_range_mm_s_ = 1;
  std::vector<std::vector<StrokeBins>> levels_;
  std::vector<std::vector<double>> times_;   // number of draws of each stroke
  std::vector<double> bin_count_, bin_sum_;  // scratch
  std::vector<double> values_, weights_;
};

// Newton's first step towards the centers of drawn strokes, without a pass over their samples (part of
// stroke_bootstrap.h).

/// The sums of a clustering at fixed centers, stroke by stroke. Those of drawn strokes are their sum, each as often as
/// it was drawn.
class StrokeSums {
 public:
  StrokeSums() = default;
  /// `centres`: of all strokes, scaled as `strokes` has them, ascending. Leaves `strokes` with every stroke taken once.
  StrokeSums(StrokeResampler& strokes, std::span<const double> centres, double m);

  /// Where Newton's step leads from the centers; the centers themselves if it leads far or out of the data.
  std::vector<double> firstStep(std::span<const std::vector<double>> times);

 private:
  std::vector<double> centres_;
  double longest_ = 0;                                  // that a step may be
  std::vector<std::vector<std::vector<double>>> sums_;  // level, stroke: pull, then curvature (FcmSums)
  std::vector<double> matrix_, step_;                   // scratch
};

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
