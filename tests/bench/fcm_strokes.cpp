#include "tests/bench/fcm_strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/random.h"

#include "tests/reference/fcm_reference.h"

namespace tactus::bench {

std::vector<double> simulatedStrokes(std::size_t samples) {
  constexpr std::array kMeans_mm_s = {46.0, 129.2, 256.7};
  constexpr std::size_t kStrokes = 12;
  base::Random random(20);
  std::array<double, kStrokes> peaks_mm_s{};
  // A minimum-jerk movement peaks at 1.875 times its mean speed.
  for (std::size_t s = 0; s < kStrokes; ++s) peaks_mm_s[s] = 1.875 * kMeans_mm_s[s / 4] * (1 + 0.1 * random.normal());
  std::vector<double> speeds_mm_s(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    const double place = static_cast<double>(i) * kStrokes / static_cast<double>(samples);
    const double stroke = std::floor(place);
    const double t = place - stroke;
    const double bell = 16 * t * t * (1 - t) * (1 - t);
    speeds_mm_s[i] = peaks_mm_s[static_cast<std::size_t>(stroke)] * bell + 2 * random.normal();
  }
  return speeds_mm_s;
}

std::vector<long double> referenceCentres(const std::vector<double>& samples, std::size_t clusters, double m) {
  constexpr int kMostIterations = 2000;
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
  std::vector<long double> centres(clusters);
  for (std::size_t k = 0; k < clusters; ++k) {
    centres[k] = *low + (*high - *low) * (static_cast<long double>(k) + 0.5L) / static_cast<long double>(clusters);
  }
  // On every hundredth sample first, to save steps on all of them.
  std::vector<double> some;
  for (std::size_t i = 0; i < samples.size(); i += 100) some.push_back(samples[i]);
  centres = reference::fcmFixedPoint({some, {}, m}, std::move(centres), kMostIterations).centres;
  return reference::fcmFixedPoint({samples, {}, m}, std::move(centres), kMostIterations).centres;
}

double largestError(std::vector<double> centres, const std::vector<long double>& reference) {
  if (centres.size() != reference.size()) return std::numeric_limits<double>::infinity();
  std::sort(centres.begin(), centres.end());
  long double largest = 0;
  for (std::size_t k = 0; k < centres.size(); ++k) largest = std::max(largest, std::abs(centres[k] - reference[k]));
  return static_cast<double>(largest);
}

}  // namespace tactus::bench
