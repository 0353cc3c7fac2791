// The Jonckheere-Terpstra test: do speeds rise with the requested level?
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace tactus::elicitation {

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

}  // namespace tactus::elicitation
