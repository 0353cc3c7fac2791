// How far the raters of one unit agree.
#pragma once

#include <optional>
#include <vector>

namespace tactus::elicitation {

struct ItemConsensus {
  double entropy_bits = 0;  ///< of the shares of the categories: 0 where all say the same
  double consensus = 1;     ///< 1 where all say the same, 0 where half are at each end of the scale
  int spread_terms = 0;     ///< highest category minus lowest
};

/// From how often each category was chosen, the lowest first. The consensus is that of Tastle and Wierman 2007: with
/// categories X of shares p, mean mu and the width d of the scale, 1 + sum p log2(1 - |X - mu| / d); unlike the entropy
/// it knows that neighbours are closer than ends. Nothing with fewer than two ratings: one alone agrees with nobody.
std::optional<ItemConsensus> itemConsensus(const std::vector<int>& counts);

}  // namespace tactus::elicitation
