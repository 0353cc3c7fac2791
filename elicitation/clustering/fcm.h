// Fuzzy C-Means clustering of one column of numbers (paper, Eq. 1; Bezdek 1981).
//
// Words: a start is a first guess of the centers. A descent leads from a start to a local minimum of J.
// Entries are a short weighted substitute for the samples. Example: 24,000 samples with 300 distinct values make 300
// entries.
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

/// A variable of a model has at most 64 terms, so more clusters are not useful.
inline constexpr std::size_t kMostClusters = 64;

/// The progress of a clustering.
struct FcmProgress {
  int passes = 0;     ///< over all samples so far
  double change = 1;  ///< largest change of a center in the last step, as a share of the data's range
};

struct FcmSettings {
  std::size_t clusters = 3;  ///< c, 1 to kMostClusters
  double m = 2;              ///< fuzziness, 1 < m <= 100; above 5 the centers stick to samples, which gives a warning
  /// Number of starts: quantiles, the best division into runs, equal widths, then random ones from the seed. A larger
  /// number finds the global minimum more reliably.
  int starts = 16;
  std::uint64_t seed = 1;
  /// A descent ends if the estimated distance of its centers from the minimum is below this share of the smallest
  /// distance between two centers, or if J no longer falls.
  double tolerance = 1e-13;
  /// Limit of steps in one descent. A descent that needs more is reported as not converged.
  int most_iterations = 1000;
  /// Called before each pass over samples or entries, in the caller's thread. False cancels the run.
  std::function<bool(const FcmProgress&)> keep_going = {};
};

enum class FcmStop {
  kConverged,       ///< the centers are within the tolerance of the minimum
  kExact,           ///< as many distinct values as clusters: the centers are the values
  kIterationLimit,  ///< the descent reached the limit of iterations
};

/// `converged`, `exact`, `iteration_limit`.
std::string_view name(FcmStop stop) noexcept;

/// A local minimum of J other than the result.
struct FcmMinimum {
  std::vector<double> centres;
  double objective_ratio = 1;  ///< its J divided by the J of the result
};

struct FcmResult {
  std::vector<double> centres;  ///< ascending, in the unit of the data
  double m = 2;
  /// J, the sum of u^m (x - v)^2. Empty if it lies outside the normal range of double.
  std::optional<double> objective;
  std::optional<double> objective_log10;  ///< empty if J = 0
  int iterations = 0;                     ///< of the descent to the result, on entries and on all samples
  int passes = 0;                         ///< over all samples; 0 if the entries are exact
  FcmStop stop = FcmStop::kConverged;
  std::vector<FcmMinimum> other_minima;  ///< found from other starts, by ascending J
  std::vector<std::string> warnings;     ///< one sentence each
};

/// Returns the centers with the lowest J that any start leads to. Offset and scale of the data do not matter: the data
/// are shifted by about their median and scaled by a power of two. Deterministic, with equal bits on every x86-64
/// processor.
/// Memory: samples are not copied or sorted, and memberships are not stored. There are at most 65,536 weighted entries
/// and O(c^2) sums. Time: one check of the samples, one read for the entries, and, for unquantized data, usually one or
/// two passes.
/// For more than 2048 samples, the other minima are those of the entries unless their J is within 1 % of the result's.
/// Returns an error for: no samples, NaN or infinity (with its position from 1), m outside (1, 100], clusters outside 1
/// to 64, fewer distinct values than clusters, clusters that doubles cannot separate (the centers are always distinct).
/// If keep_going stops the run: an error of kind kCancelled.
/// Thread: any; no threads inside. Real-time safe: no.
base::Result<FcmResult> fuzzyCMeans(std::span<const double> samples, const FcmSettings& settings = {});

/// The same for weighted samples: J is the sum of w u^m (x - v)^2, so a sample of weight 2 counts like two samples.
/// `weights`: one finite number >= 0 per sample. A sample of weight 0 does not count but must be finite. Also returns
/// an error for: another number of weights, a weight below 0 or not finite (with its position), no weight above 0.
base::Result<FcmResult> fuzzyCMeans(std::span<const double> samples, std::span<const double> weights,
                                    const FcmSettings& settings);

/// The memberships of `x` in the clusters: positive, with sum 1. On a center: 1 for that cluster. Never 0/0.
/// `memberships`: written here, as long as `centres`. `m`: > 1.
void fcmMemberships(double x, std::span<const double> centres, double m, std::span<double> memberships) noexcept;

}  // namespace tactus::elicitation
