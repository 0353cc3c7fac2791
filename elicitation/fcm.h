// Fuzzy C-Means clustering of one column of numbers (paper, Eq. 1; Bezdek 1981).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace tactus::elicitation {

/// A variable of a model has at most 64 terms, so more clusters have no use.
inline constexpr std::size_t kMostClusters = 64;

struct FcmSettings {
  std::size_t clusters = 3;  ///< c, 1 to kMostClusters
  double m = 2;              ///< fuzziness, 1 < m <= 100; above 5 the centres pin to samples, which is warned of
  /// How many starts are tried: quantiles, equal widths, then seeded ones. More find the global minimum more surely.
  int starts = 16;
  std::uint64_t seed = 1;
  /// Largest change of a centre in the last step, as a share of the data's range.
  double tolerance = 1e-13;
  /// Steps of one descent; a descent that needs more is reported as not converged.
  int most_iterations = 1000;
};

enum class FcmStop {
  kConverged,       ///< the last step moved no centre by more than the tolerance
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
  int iterations = 0;                     ///< of the descent that was kept
  FcmStop stop = FcmStop::kConverged;
  std::vector<FcmMinimum> other_minima;  ///< found from other starts, ascending J
  std::vector<std::string> warnings;     ///< one sentence each
};

/// The centres with the lowest J that the starts lead to. Offsets and scales of the data do not matter: it is shifted
/// by its median and scaled by a power of two first. Deterministic. Memory: one sorted copy of the data. Refused: no
/// samples, NaN or infinity (with its position from 1), m outside (1, 100], clusters outside 1 to 64, fewer distinct
/// values than clusters, clusters that doubles cannot tell apart (the centres are always distinct).
base::Result<FcmResult> fuzzyCMeans(std::span<const double> samples, const FcmSettings& settings = {});

/// Memberships of `x` in the clusters: positive, with sum 1; on a centre 1 for that cluster. Never 0/0.
/// `memberships` has the size of `centres`, m > 1.
void fcmMemberships(double x, std::span<const double> centres, double m, std::span<double> memberships) noexcept;

}  // namespace tactus::elicitation
