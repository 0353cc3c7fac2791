// Converts the clusters of insertion speeds to trapezoids (paper, Section 3.2, Fig. 8).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"

namespace tactus::elicitation {

// Where the membership in a cluster has fallen to a given value on the way to the next center.

/// The point between the center of `cluster` and the neighboring one `neighbor` (the index before or after it) where
/// the membership in `cluster` is alpha, rounded towards the cluster, so that it has at least alpha. The membership
/// falls all the way. `centres`: ascending, distinct. `m`: > 1. `alpha`: in (1/2, 1).
double membershipEdge(std::span<const double> centres, std::size_t cluster, std::size_t neighbor, double m,
                      double alpha);

/// Default membership at the ends of the speed ramps (alphaCutRamps). It gives the ramp that best fits the membership
/// between two centers.
inline constexpr double kDefaultAlpha = 0.95;

/// The transition from one term to the next: membership of the lower term 1 up to `p`, 0 from `q` on; p < q.
struct Ramp {
  double p = 0;
  double q = 0;

  bool operator==(const Ramp&) const = default;
};

/// One ramp for each gap of `centres` (ascending, distinct, any unit). p is the point of the gap where the membership
/// in the lower cluster has fallen to `alpha`; q is the point where that in the upper one has risen to it. So v_k <=
/// p_k < q_k <= v_k+1.
/// The paper only says "center points with membership 1, end points with membership 0". alpha = 1 follows this
/// literally: terms between two others become triangles. 0.95 gives the ramp that fits the membership best. Returns an
/// error if alpha is outside (1/2, 1].
base::Result<std::vector<Ramp>> alphaCutRamps(std::span<const double> centres, double m, double alpha);

/// The centers of a participant's speed terms.
enum class SpeedCentres {
  kClusters,  ///< the centers of the clusters of all samples, regardless of level (paper, Eq. 1)
  /// The mean speed of each level. The ramps use the memberships that Eq. 1 gives for these centers: m and alpha then
  /// only set the steepness, and nothing is fitted.
  kLevelMeans,
};

/// `clusters`, `level_means`: the values of `tactus build --centres`.
std::string_view name(SpeedCentres centres) noexcept;

enum class Averaging { kMean, kWeightedMean, kMedian };

/// `mean`, `weighted_mean`, `median`.
std::string_view name(Averaging averaging) noexcept;

/// The ramps averaged over participants, vertex by vertex; the order of the vertices is kept. `ramps`: one list of
/// equal length each, at least one. `weights` (>= 0, one > 0, as many as lists) are used by kWeightedMean alone.
std::vector<Ramp> averageRamps(std::span<const std::vector<Ramp>> ramps, std::span<const double> weights,
                               Averaging averaging);

/// Upper end of the speed universe: `default_max_mm_s`, or, if that is too small, the next multiple of 100 above all
/// ramps and `largest_centre_mm_s`.
double speedUniverseMax(double default_max_mm_s, double largest_centre_mm_s, std::span<const Ramp> ramps);

/// The terms of `variable` (ascending; one more than ramps), with trapezoids from the ramps and shoulders at the ends
/// of the universe.
std::vector<fuzzy::Term> speedTerms(const fuzzy::Variable& variable, std::span<const Ramp> ramps);

/// Drops the samples below `share` (0 to 1) of the peak speed of their stroke (participant, level, stroke), and so the
/// start and stop of each stroke. Keeps the order; 0 keeps all.
std::vector<study::SpeedSample> trimStrokes(std::span<const study::SpeedSample> samples, double share);

}  // namespace tactus::elicitation
