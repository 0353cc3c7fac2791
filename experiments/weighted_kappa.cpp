#include "experiments/weighted_kappa.h"

namespace tactus::experiments {

std::optional<double> quadraticWeightedKappa(std::span<const std::pair<std::size_t, std::size_t>> pairs) {
  const auto squared = [](std::size_t a, std::size_t b) {
    const double difference = static_cast<double>(a) - static_cast<double>(b);
    return difference * difference;
  };
  double observed = 0;
  double by_chance = 0;
  for (const auto& pair : pairs) {
    observed += squared(pair.first, pair.second);
    for (const auto& other : pairs) by_chance += squared(pair.first, other.second);
  }
  if (by_chance == 0) return std::nullopt;
  return 1 - observed * static_cast<double>(pairs.size()) / by_chance;
}

}  // namespace tactus::experiments
