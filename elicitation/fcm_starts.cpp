#include "elicitation/fcm_starts.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace tactus::elicitation {
namespace {

/// Index of the entry of `data` below which the share `share` of the weight lies.
std::size_t quantileIndex(const WeightedValues& data, double total, double share) {
  double sum = 0;
  std::size_t i = 0;
  while (i + 1 < data.values.size() && sum + data.weights[i] <= share * total) sum += data.weights[i++];
  return i;
}

}  // namespace

std::vector<double> quantileStart(const WeightedValues& data, std::size_t clusters) {
  const double total = std::accumulate(data.weights.begin(), data.weights.end(), 0.0);
  std::vector<std::size_t> index(clusters);
  for (std::size_t k = 0; k < clusters; ++k) {
    index[k] = quantileIndex(data, total, (static_cast<double>(k) + 0.5) / static_cast<double>(clusters));
    if (k > 0) index[k] = std::max(index[k], index[k - 1] + 1);
  }
  // Equal quantiles were pulled apart upwards; push back what went over the end.
  std::size_t limit = data.values.size();
  for (std::size_t k = clusters; k-- > 0;) limit = index[k] = std::min(index[k], limit - 1);
  std::vector<double> centres(clusters);
  for (std::size_t k = 0; k < clusters; ++k) centres[k] = data.values[index[k]];
  return centres;
}

std::vector<double> equalWidthStart(const WeightedValues& data, std::size_t clusters) {
  const double low = data.values.front();
  const double width = (data.values.back() - low) / static_cast<double>(clusters);
  std::vector<double> centres(clusters);
  for (std::size_t k = 0; k < clusters; ++k) centres[k] = low + width * (static_cast<double>(k) + 0.5);
  return centres;
}

std::vector<double> spreadStart(const WeightedValues& data, std::size_t clusters, base::Random& random) {
  std::vector<double> share(data.weights.begin(), data.weights.end());
  std::vector<double> nearest(data.values.size(), std::numeric_limits<double>::infinity());
  std::vector<double> centres;
  while (centres.size() < clusters) {
    const double total = std::accumulate(share.begin(), share.end(), 0.0);
    double target = random.uniform() * total;
    std::size_t chosen = data.values.size();
    for (std::size_t i = 0; i < share.size() && (chosen == data.values.size() || target >= 0); ++i) {
      if (share[i] <= 0) continue;
      chosen = i;
      target -= share[i];
    }
    if (chosen == data.values.size()) break;
    centres.push_back(data.values[chosen]);
    for (std::size_t i = 0; i < share.size(); ++i) {
      const double distance = data.values[i] - centres.back();
      nearest[i] = std::min(nearest[i], distance * distance);
      share[i] = data.weights[i] * nearest[i];
    }
  }
  std::sort(centres.begin(), centres.end());
  return centres;
}

}  // namespace tactus::elicitation
