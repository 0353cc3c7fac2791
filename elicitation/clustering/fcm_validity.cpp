#include "elicitation/clustering/fcm_validity.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/check.h"
#include "elicitation/clustering/fcm.h"

namespace tactus::elicitation {
namespace {

/// A run of the sorted samples: those nearest to one center.
struct Run {
  std::size_t begin = 0;
  std::size_t end = 0;
  double mean = 0;

  std::size_t size() const { return end - begin; }
};

std::vector<Run> runsOf(const std::vector<double>& sorted, std::span<const double> centres) {
  std::vector<Run> runs(centres.size());
  std::size_t i = 0;
  for (std::size_t k = 0; k < centres.size(); ++k) {
    Run& run = runs[k];
    run.begin = i;
    const bool last = k + 1 == centres.size();
    while (i < sorted.size() && (last || sorted[i] - centres[k] <= centres[k + 1] - sorted[i])) ++i;
    run.end = i;
    // Deviations from the center keep the mean exact under a large offset.
    double sum = 0;
    for (std::size_t j = run.begin; j < run.end; ++j) sum += sorted[j] - centres[k];
    if (run.size() > 0) run.mean = centres[k] + sum / static_cast<double>(run.size());
  }
  return runs;
}

/// Mean distance from x to the nearest other run. All samples of another run lie on one side of x, so the distance is
/// that of the run's mean.
double distanceToOthers(const std::vector<Run>& runs, std::size_t own, double x) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (k != own && runs[k].size() > 0) least = std::min(least, std::abs(runs[k].mean - x));
  }
  return least;
}

struct Silhouettes {
  double weighted = 0;
  double weight = 0;
  double sum = 0;
};

void addSilhouettes(const std::vector<double>& sorted, const std::vector<Run>& runs, std::size_t own,
                    std::span<const double> centres, double m, Silhouettes& total) {
  const Run& run = runs[own];
  double run_sum = 0;  // of deviations from the run's mean, as the running sum below
  for (std::size_t i = run.begin; i < run.end; ++i) run_sum += sorted[i] - run.mean;

  std::vector<double> u(centres.size());
  double below_sum = 0;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    const double x = sorted[i] - run.mean;
    const auto below = static_cast<double>(i - run.begin);
    const auto above = static_cast<double>(run.end - i - 1);
    const double above_sum = run_sum - below_sum - x;
    double silhouette = 0;
    if (run.size() > 1) {
      const double inside = ((x * below - below_sum) + (above_sum - x * above)) / (below + above);
      const double outside = distanceToOthers(runs, own, sorted[i]);
      const double larger = std::max(inside, outside);
      if (larger > 0) silhouette = (outside - inside) / larger;
    }
    below_sum += x;

    fcmMemberships(sorted[i], centres, m, u);
    std::nth_element(u.begin(), u.begin() + 1, u.end(), std::greater<>());
    const double weight = u[0] - u[1];
    total.weighted += weight * silhouette;
    total.weight += weight;
    total.sum += silhouette;
  }
}

}  // namespace

FcmValidity fcmValidity(std::span<const double> samples, std::span<const double> centres, double m) {
  TACTUS_CHECK(!samples.empty() && !centres.empty());
  std::vector<double> sorted(samples.begin(), samples.end());
  std::sort(sorted.begin(), sorted.end());
  const auto n = static_cast<double>(sorted.size());
  const auto c = static_cast<double>(centres.size());

  std::vector<double> u(centres.size());
  double squares = 0;
  double entropy = 0;
  double spread = 0;
  for (const double x : sorted) {
    fcmMemberships(x, centres, m, u);
    for (std::size_t k = 0; k < u.size(); ++k) {
      squares += u[k] * u[k];
      if (u[k] > 0) entropy -= u[k] * std::log(u[k]);
      spread += (m == 2 ? u[k] * u[k] : std::pow(u[k], m)) * (x - centres[k]) * (x - centres[k]);
    }
  }

  FcmValidity out;
  out.partition_coefficient = squares / n;
  out.partition_entropy = entropy / n;
  const std::vector<Run> runs = runsOf(sorted, centres);
  for (const Run& run : runs) out.sizes.push_back(run.size());
  if (centres.size() == 1) return out;

  out.modified_coefficient = 1 - c / (c - 1) * (1 - out.partition_coefficient);
  double gap = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < centres.size(); ++k) gap = std::min(gap, centres[k] - centres[k - 1]);
  out.xie_beni = spread / n / gap / gap;

  if (std::count_if(runs.begin(), runs.end(), [](const Run& run) { return run.size() > 0; }) < 2) return out;
  Silhouettes total;
  for (std::size_t k = 0; k < runs.size(); ++k) addSilhouettes(sorted, runs, k, centres, m, total);
  out.crisp_silhouette = total.sum / n;
  if (total.weight > 0) out.fuzzy_silhouette = total.weighted / total.weight;
  return out;
}

}  // namespace tactus::elicitation
