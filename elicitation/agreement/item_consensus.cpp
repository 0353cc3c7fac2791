#include "elicitation/agreement/item_consensus.h"

#include <cmath>

#include "elicitation/agreement/ratings.h"

namespace tactus::elicitation {

std::optional<ItemConsensus> itemConsensus(const std::vector<int>& counts) {
  const auto total = static_cast<double>(ratingsOf(counts));
  if (total < 2) return std::nullopt;
  double sum = 0;
  int lowest = -1;
  int highest = 0;
  for (int k = 0; k < static_cast<int>(counts.size()); ++k) {
    if (counts[static_cast<std::size_t>(k)] == 0) continue;
    if (lowest < 0) lowest = k;
    highest = k;
    sum += static_cast<double>(k) * counts[static_cast<std::size_t>(k)];
  }
  ItemConsensus out;
  out.spread_terms = highest - lowest;
  if (out.spread_terms == 0) return out;
  const double mean = sum / total;
  const auto width = static_cast<double>(counts.size() - 1);
  for (int k = lowest; k <= highest; ++k) {
    const double share = counts[static_cast<std::size_t>(k)] / total;
    if (share == 0) continue;
    out.entropy_bits -= share * std::log2(share);
    out.consensus += share * std::log2(1 - std::abs(k - mean) / width);
  }
  return out;
}

}  // namespace tactus::elicitation
