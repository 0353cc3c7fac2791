// The insertion speeds of each participant: clusters, ramps, and the averaged terms.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/clustering/fcm.h"
#include "elicitation/clustering/fcm_validity.h"
#include "elicitation/speed/speed_terms.h"

namespace tactus::elicitation {

// Diagnostics of one participant: how well the speeds separate the levels.

/// The Jonckheere-Terpstra test: do speeds rise with the requested level?
struct LevelTrend {
  double j = 0;  ///< pairs of values from two groups in which the higher group has the larger value; a tie counts 1/2
  double most_j = 0;   ///< all such pairs
  double p = 1;        ///< one-sided: probability of at least `j` if the groups do not matter
  double least_p = 0;  ///< p of the best order of these values; above 0.05 the test cannot show any order
  bool exact = true;   ///< p counts every arrangement; false: normal approximation
};

/// Tests the order of `groups`, lowest first, against no order (Terpstra 1952, Jonckheere 1954). `groups`: one finite
/// value per independent observation, i.e. the mean of a stroke, never a sample.
/// Up to about 3 groups of 20, the permutation distribution is exact, including ties (3 levels of 4 strokes: 34,650
/// arrangements). Beyond that: the normal approximation with the variance for ties (Hollander and Wolfe 1999, eq.
/// 6.19), without continuity correction, and least_p = 0. Skips empty groups; nothing if fewer than two have values.
std::optional<LevelTrend> jonckheereTerpstra(std::span<const std::vector<double>> groups);

// Compares the clusters of a participant's speeds with the requested levels.

/// A table of requested levels against clusters. The clustering itself ignores the levels.
struct LevelConfusion {
  std::vector<std::string> levels;               ///< as given, slow to fast
  std::vector<std::vector<std::size_t>> counts;  ///< counts[level][cluster]: samples by nearest center
  std::size_t other_levels = 0;                  ///< samples of a level that is not in `levels`
  double accuracy = 0;                           ///< share of the samples whose cluster is that of their level
  double adjusted_rand_index = 0;                ///< agreement beyond chance (Hubert and Arabie 1985); 1 is perfect
  std::vector<std::string> warnings;             ///< one sentence each, naming `participant`
};

/// The table of one participant's samples for `centres` (ascending). Warns if the adjusted Rand index is below 0.3 or
/// the accuracy below 0.6.
LevelConfusion levelConfusion(std::span<const study::SpeedSample> samples, std::span<const std::string> levels,
                              std::span<const double> centres, const std::string& participant);

// The speeds of a participant at each requested level, and the separation of neighboring levels.

/// One level over all its samples, as in Table 1 of the paper.
struct LevelSpeeds {
  std::string level;
  std::size_t samples = 0;
  double mean_mm_s = 0;                   ///< 0 without samples
  double sd_mm_s = 0;                     ///< n - 1 in the denominator; 0 for fewer than two samples
  std::vector<double> stroke_means_mm_s;  ///< one per stroke, in the order of first appearance
};

/// One entry per level of `levels`. `samples`: of one participant; samples of other levels are skipped.
std::vector<LevelSpeeds> levelSpeeds(std::span<const study::SpeedSample> samples, std::span<const std::string> levels);

/// d' = |difference of the means| / pooled standard deviation of the samples (each variance weighted by its samples -
/// 1). Nothing if a level has no samples or no sample varies.
std::optional<double> separation(const LevelSpeeds& one, const LevelSpeeds& other);

struct LevelDiagnostics {
  std::vector<LevelSpeeds> levels;                 ///< slow to fast
  std::vector<std::optional<double>> separations;  ///< d' of each level and the next (level_diagnostics.h)
  std::optional<LevelTrend> trend;                 ///< of the stroke means; empty for fewer than two levels
  LevelConfusion confusion;
  std::vector<std::string> warnings;  ///< one sentence each, naming the participant and the numbers
};

/// Diagnoses one participant's samples against `centres` (ascending, one per level). `levels`: slow to fast. Warns for:
/// the warnings of levelConfusion, d' below 1, a center outside the mean ± SD of its level, stroke means that do not
/// rise with the level (p above 0.05, if there are enough strokes to show it).
LevelDiagnostics levelDiagnostics(std::span<const study::SpeedSample> samples, std::span<const std::string> levels,
                                  std::span<const double> centres, const std::string& participant);

/// Index of the term of `speed` with the largest membership at `speed_mm_s` (clamped to the universe); on a tie the
/// lower one. `speed`: at least one term.
std::size_t termAt(const fuzzy::Variable& speed, double speed_mm_s);

/// A sentence saying that the means of all levels belong to one and the same term of `averaged`, and their terms in the
/// participant's `own` terms. Nothing if that is not so, or if only one level has samples.
std::optional<std::string> sameTermNote(std::span<const LevelSpeeds> levels, const fuzzy::Variable& averaged,
                                        const fuzzy::Variable& own, const std::string& participant);

// The speed samples of each participant of a study, without copies: a study of 200 participants has millions.

/// Where a study holds the samples of a participant side by side, as study files do, nothing is copied.
/// Thread: any, after the constructor.
class ParticipantSamples {
 public:
  /// `samples` outlive this and stay unchanged.
  explicit ParticipantSamples(std::span<const study::SpeedSample> samples);
  ParticipantSamples(const ParticipantSamples&) = delete;
  ParticipantSamples& operator=(const ParticipantSamples&) = delete;

  /// Those of `participant`, in the study's order; none for an unknown one.
  std::span<const study::SpeedSample> of(std::string_view participant) const;

 private:
  struct Found {
    std::span<const study::SpeedSample> all;
    std::vector<study::SpeedSample> copied;  ///< behind `all` if they lie apart in the study
  };
  std::unordered_map<std::string_view, Found> found_;
};

/// What trimStrokes keeps of `samples`: `samples` themselves for a share of 0, otherwise copies in `room`.
std::span<const study::SpeedSample> keptSamples(std::span<const study::SpeedSample> samples, double share,
                                                std::vector<study::SpeedSample>& room);

struct SpeedTermSettings {
  SpeedCentres centres = SpeedCentres::kClusters;
  double alpha = kDefaultAlpha;  ///< (1/2, 1], membership at the start and end of a ramp (alphaCutRamps)
  FcmSettings fcm;               ///< `clusters` is set to the number of speed terms; m applies to both kinds of centers
  double trim = 0;               ///< [0, 1): samples below this share of their stroke's peak speed are dropped
};

/// Whether both give the same clusters: all is equal but alpha, which acts on the ramps alone.
bool clusterAlike(const SpeedTermSettings& a, const SpeedTermSettings& b);

/// The results for one participant's speeds.
struct ParticipantSpeeds {
  std::string participant;
  bool simulated = false;
  std::size_t samples = 0;            ///< before trimming
  std::size_t kept = 0;               ///< after trimming; all following members use these samples
  std::vector<double> centres;        ///< of the clusters, or the means of the levels; ascending
  double m = 2;                       ///< fuzziness of the memberships around the centers
  std::optional<FcmResult> clusters;  ///< empty if the centers are the means of the levels
  FcmValidity validity;
  std::vector<Ramp> ramps;
  LevelDiagnostics diagnostics;
};

/// One entry per participant with speeds, in the participants' order. The centers become the terms of `speed` in
/// ascending order.
/// Returns an error that names the participant for: settings out of range, a level that is not a term of `speed`,
/// speeds that cannot be clustered, a center below the universe of `speed`. For level means also: a level without
/// samples, or means that do not rise with the level.
/// `go_on`: asked before each participant with the share that is done, [0, 1]; false ends with an error of kind
/// kCancelled.
base::Result<std::vector<ParticipantSpeeds>> clusterSpeeds(const study::Study& study, const fuzzy::Variable& speed,
                                                           const SpeedTermSettings& settings,
                                                           const std::function<bool(double share)>& go_on = {});

/// `speed` with a universe that contains all participants, and with the terms of the averaged ramps.
fuzzy::Variable averagedSpeed(const fuzzy::Variable& speed, std::span<const ParticipantSpeeds> participants,
                              std::span<const Ramp> averaged);

}  // namespace tactus::elicitation
