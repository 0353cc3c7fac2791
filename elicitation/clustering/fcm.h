// Fuzzy C-Means clustering of one column of numbers (paper, Eq. 1; Bezdek 1981).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace tactus::elicitation {

/// A variable of a model has at most 64 terms, so more clusters have no use.
inline constexpr std::size_t kMostClusters = 64;

/// How far a clustering has come.
struct FcmProgress {
  int passes = 0;     ///< over all samples so far
  double change = 1;  ///< largest change of a centre in the last step, as a share of the data's range
};

struct FcmSettings {
  std::size_t clusters = 3;  ///< c, 1 to kMostClusters
  double m = 2;              ///< fuzziness, 1 < m <= 100; above 5 the centres pin to samples, which is warned of
  /// How many starts are tried: quantiles, the best division into runs, equal widths, then seeded ones. More find the
  /// global minimum more surely.
  int starts = 16;
  std::uint64_t seed = 1;
  /// A descent ends when its centres are estimated to be this near to where it leads, as a share of the smallest
  /// distance of two centres, or when J falls no more.
  double tolerance = 1e-13;
  /// Steps of one descent; a descent that needs more is reported as not converged.
  int most_iterations = 1000;
  /// Called before each pass over the samples or their stand-in, in the caller's thread; false cancels the run.
  std::function<bool(const FcmProgress&)> keep_going = {};
};

enum class FcmStop {
  kConverged,       ///< the centres are within the tolerance of where the descent leads
  kExact,           ///< as many distinct values as clusters: the centres are the values
  kIterationLimit,  ///< the iterations ran out
};

/// `converged`, `exact`, `iteration_limit`.
std::string_view name(FcmStop stop) noexcept;

/// A local minimum of J that is not the one kept.
struct FcmMinimum {
  std::vector<double> centres;
  double objective_ratio = 1;  ///< its J by the J of the one kept
};

struct FcmResult {
  std::vector<double> centres;  ///< ascending, in the unit of the data
  double m = 2;
  /// J, the sum of u^m (x - v)^2; absent where it lies outside double's normal range.
  std::optional<double> objective;
  std::optional<double> objective_log10;  ///< absent where J = 0
  int iterations = 0;                     ///< of the descent that was kept, on stand-ins and on all samples
  int passes = 0;                         ///< over all samples; 0 where a stand-in of joined equal values is exact
  FcmStop stop = FcmStop::kConverged;
  std::vector<FcmMinimum> other_minima;  ///< found from other starts, ascending J
  std::vector<std::string> warnings;     ///< one sentence each
};

/// The centres with the lowest J that the starts lead to. Offsets and scales of the data do not matter: it is shifted
/// by about its median and scaled by a power of two on the way. Deterministic, with the same bits on every x86-64
/// processor. Memory: the samples are neither copied nor sorted and no membership is kept; beside them there is a
/// stand-in of at most 65,536 values with weights and O(c^2) sums. Time: one look over the samples, one read for the
/// stand-in, and for data that are not quantised usually one or two passes.
/// Other minima of data longer than 2048 are those of the stand-in unless their J is within 1 % of the one kept.
/// Refused: no samples, NaN or infinity (with its position from 1), m outside (1, 100], clusters outside 1 to 64, fewer
/// distinct values than clusters, clusters that doubles cannot tell apart (the centres are always distinct). A run that
/// keep_going stops is an error of the kind kCancelled.
/// Thread: any; no threads inside. Real-time safe: no.
base::Result<FcmResult> fuzzyCMeans(std::span<const double> samples, const FcmSettings& settings = {});

/// The same for samples with weights: J is the sum of w u^m (x - v)^2, so a weight of 2 counts like the sample twice.
/// `weights` has one finite number of at least 0 for each sample. A sample of weight 0 does not count, but must be
/// finite. Refused beside the above: another number of weights, a weight below 0 or not finite (with its position), no
/// weight above 0.
base::Result<FcmResult> fuzzyCMeans(std::span<const double> samples, std::span<const double> weights,
                                    const FcmSettings& settings);

/// Memberships of `x` in the clusters: positive, with sum 1; on a centre 1 for that cluster. Never 0/0.
/// `memberships` has the size of `centres`, m > 1.
void fcmMemberships(double x, std::span<const double> centres, double m, std::span<double> memberships) noexcept;

}  // namespace tactus::elicitation
