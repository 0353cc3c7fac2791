// The objective J of fuzzy C-means (paper, Eq. 1) against the iteration of the textbook's algorithm.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace tactus::workbench {

struct ObjectiveTrace {
  std::vector<double> objective;  ///< at the start, then after each iteration, (mm/s)²
  bool converged = false;         ///< the centers moved by less than a millionth of the data's range
};

/// Alternates memberships and centers (Bezdek 1981) from the quantiles (k + 1/2) / c of `samples`, up to 100 times. It
/// finds the nearest minimum and needs more iterations than elicitation::fuzzyCMeans, which follows J's curvature;
/// what both end at is the same where the start leads to the lowest minimum. Empty for samples that cannot be
/// clustered, or if `keep_going` says no.
ObjectiveTrace objectiveTrace(std::span<const double> samples, std::size_t clusters, double m,
                              const std::function<bool()>& keep_going);

}  // namespace tactus::workbench
