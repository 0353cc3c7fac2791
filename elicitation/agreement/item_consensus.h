// Agreement of the raters of one unit.
#pragma once

#include <optional>
#include <vector>

namespace tactus::elicitation {

struct ItemConsensus {
  double entropy_bits = 0;  ///< of the shares of the categories: 0 if all ratings are equal
  double consensus = 1;     ///< 1 if all ratings are equal, 0 if half are at each end of the scale
  int spread_terms = 0;     ///< highest category minus lowest
};

/// Consensus by Tastle and Wierman 2007. For categories X with shares p, mean mu and scale width d: 1 + sum p log2(1 -
/// |X - mu| / d). Unlike the entropy it takes into account that neighbors are closer than the ends. `counts`: ratings
/// per category, lowest first. Nothing for fewer than two ratings.
std::optional<ItemConsensus> itemConsensus(const std::vector<int>& counts);

}  // namespace tactus::elicitation
