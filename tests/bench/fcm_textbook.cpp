#include "tests/bench/fcm_textbook.h"

#include <algorithm>
#include <cmath>

namespace tactus::bench {

std::vector<double> textbookFcm(const std::vector<double>& samples, std::size_t clusters, double m) {
  const std::size_t n = samples.size();
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
  std::vector<double> centres(clusters);
  for (std::size_t k = 0; k < clusters; ++k) {
    centres[k] = *low + (*high - *low) * (static_cast<double>(k) + 0.5) / static_cast<double>(clusters);
  }
  std::vector<double> u(n * clusters, 0.0);
  double change = 1;
  while (change > 1e-9) {
    change = 0;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < clusters; ++k) {
        double sum = 0;
        for (std::size_t l = 0; l < clusters; ++l) {
          sum += std::pow(std::abs(samples[i] - centres[k]) / std::abs(samples[i] - centres[l]), 2 / (m - 1));
        }
        change = std::max(change, std::abs(1 / sum - u[i * clusters + k]));
        u[i * clusters + k] = 1 / sum;
      }
    }
    for (std::size_t k = 0; k < clusters; ++k) {
      double weight = 0;
      double moment = 0;
      for (std::size_t i = 0; i < n; ++i) {
        const double share = std::pow(u[i * clusters + k], m);
        weight += share;
        moment += share * samples[i];
      }
      centres[k] = moment / weight;
    }
  }
  std::sort(centres.begin(), centres.end());
  return centres;
}

}  // namespace tactus::bench
