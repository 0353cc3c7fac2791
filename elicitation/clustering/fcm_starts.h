// The starts of a clustering's descents (part of fcm.h).
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/base/random.h"
#include "elicitation/clustering/fcm.h"
#include "elicitation/clustering/fcm_data.h"

namespace tactus::elicitation {

/// The descent from a start to a local minimum of J (part of fcm.h).
struct FcmDescent {
  std::vector<double> centres;  ///< ascending, scaled
  double objective = 0;         ///< J of the scaled data
  int iterations = 0;
  bool converged = false;
  bool minimum = false;  ///< J curves upward in every direction at the centers
  bool canceled = false;
};

/// The kind of the first step of a descent.
enum class FcmBeginning {
  kAnywhere,     ///< a step of Bezdek's iteration, which never raises J
  kNearMinimum,  ///< a Newton step
};

/// Called before each pass with the largest change of a center in the last step. False stops the descent.
using FcmBeforePass = std::function<bool(double change)>;

/// Descends from `centres` (distinct, ascending). The matrix of a step lies between J's second derivatives (Newton,
/// which reaches full precision) and the metric of Bezdek's iteration (which never raises J). Each rejected step moves
/// it towards Bezdek's. The descent ends if the estimated remaining distance is below settings.tolerance of the range
/// and, near a smooth minimum, below the rounding of the sums. The last step then needs no pass of its own.
FcmDescent descend(const FcmData& data, std::vector<double> centres, FcmBeginning beginning,
                   const FcmSettings& settings, const FcmBeforePass& before_pass);

// All functions need more entries than clusters and return ascending, distinct centers.

/// The quantiles (k + 1/2) / clusters, moved apart if they coincide.
std::vector<double> quantileStart(const FcmEntries& entries, std::size_t clusters);

/// The middles of equal parts of the range.
std::vector<double> equalWidthStart(const FcmEntries& entries, std::size_t clusters);

/// The means of the best division into runs, with each value in exactly one cluster: the limit of J for m near 1. Found
/// with certainty by dynamic programming (Fisher 1958). O(clusters * entries * log entries).
std::vector<double> bestRunsStart(const FcmEntries& entries, std::size_t clusters);

/// Random values, drawn with a probability that grows with the squared distance from the values drawn before (Arthur
/// and Vassilvitskii 2007), so that outliers can be chosen. Fewer centers if the remaining values are too close to
/// separate.
std::vector<double> spreadStart(const FcmEntries& entries, std::size_t clusters, base::Random& random);

}  // namespace tactus::elicitation
