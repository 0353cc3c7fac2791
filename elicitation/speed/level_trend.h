// Whether speeds rise with the level that was asked for: the test of Jonckheere and Terpstra.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace tactus::elicitation {

struct LevelTrend {
  double j = 0;  ///< pairs of values from two groups in which the higher group has the larger value; a tie counts half
  double most_j = 0;   ///< all such pairs
  double p = 1;        ///< one-sided: the chance of `j` or more where the groups do not matter
  double least_p = 0;  ///< the p of the best order that these values allow; above 0.05 no order can be shown
  bool exact = true;   ///< p counts every arrangement; otherwise the normal approximation
};

/// Tests the order of `groups`, lowest first, against no order (Terpstra 1952, Jonckheere 1954), one finite value per
/// independent observation: the mean of a stroke, never a sample. The permutation distribution is exact, ties
/// included (3 levels of 4 strokes: 34,650 arrangements), up to about 3 groups of 20; beyond that the normal
/// approximation with the variance for ties (Hollander and Wolfe 1999, eq. 6.19), without continuity correction, and
/// least_p = 0. Groups without values are passed over; nothing where fewer than two have any.
std::optional<LevelTrend> jonckheereTerpstra(std::span<const std::vector<double>> groups);

}  // namespace tactus::elicitation
