#include "elicitation/clustering/fcm_starts.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace tactus::elicitation {
namespace {

/// Index of the entry of `data` below which the share `share` of the weight lies.
std::size_t quantileIndex(const FcmEntries& entries, double total, double share) {
  double sum = 0;
  std::size_t i = 0;
  while (i + 1 < entries.values.size() && sum + entries.weights[i] <= share * total) sum += entries.weights[i++];
  return i;
}

/// Sums of squared distances of runs of entries from their means.
class RunCosts {
 public:
  explicit RunCosts(const FcmEntries& entries) : weight_{0}, sum_{0}, squares_{0} {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const double moment = entries.weights[i] * entries.values[i];
      weight_.push_back(weight_.back() + entries.weights[i]);
      sum_.push_back(sum_.back() + moment);
      squares_.push_back(squares_.back() + moment * entries.values[i]);
    }
  }
  double mean(std::size_t begin, std::size_t end) const {
    return (sum_[end] - sum_[begin]) / (weight_[end] - weight_[begin]);
  }
  double of(std::size_t begin, std::size_t end) const {
    return squares_[end] - squares_[begin] - (sum_[end] - sum_[begin]) * mean(begin, end);
  }

 private:
  std::vector<double> weight_, sum_, squares_;  // of the first i entries
};

/// Lengths for which to find the best beginning of the last run, and where that may lie.
struct RunSearch {
  std::size_t first, last;       // lengths
  std::size_t earliest, latest;  // beginnings
};

/// The best cost of one run more. The best beginning grows with the length, so the middle length divides the search.
void addRun(const RunCosts& costs, const std::vector<double>& cost, RunSearch search, std::vector<double>& next,
            std::vector<std::size_t>& from) {
  if (search.first > search.last) return;
  const std::size_t length = search.first + (search.last - search.first) / 2;
  for (std::size_t begin = search.earliest; begin <= std::min(search.latest, length - 1); ++begin) {
    const double sum = cost[begin] + costs.of(begin, length);
    if (sum < next[length]) {
      next[length] = sum;
      from[length] = begin;
    }
  }
  addRun(costs, cost, {search.first, length - 1, search.earliest, from[length]}, next, from);
  addRun(costs, cost, {length + 1, search.last, from[length], search.latest}, next, from);
}

}  // namespace

std::vector<double> quantileStart(const FcmEntries& entries, std::size_t clusters) {
  const double total = std::accumulate(entries.weights.begin(), entries.weights.end(), 0.0);
  std::vector<std::size_t> index(clusters);
  for (std::size_t k = 0; k < clusters; ++k) {
    index[k] = quantileIndex(entries, total, (static_cast<double>(k) + 0.5) / static_cast<double>(clusters));
    if (k > 0) index[k] = std::max(index[k], index[k - 1] + 1);
  }
  // Equal quantiles were pulled apart upwards; push back what went over the end.
  std::size_t limit = entries.values.size();
  for (std::size_t k = clusters; k-- > 0;) limit = index[k] = std::min(index[k], limit - 1);
  std::vector<double> centres(clusters);
  for (std::size_t k = 0; k < clusters; ++k) centres[k] = entries.values[index[k]];
  return centres;
}

std::vector<double> equalWidthStart(const FcmEntries& entries, std::size_t clusters) {
  const double low = entries.values.front();
  const double width = (entries.values.back() - low) / static_cast<double>(clusters);
  std::vector<double> centres(clusters);
  for (std::size_t k = 0; k < clusters; ++k) centres[k] = low + width * (static_cast<double>(k) + 0.5);
  return centres;
}

std::vector<double> bestRunsStart(const FcmEntries& entries, std::size_t clusters) {
  const RunCosts costs(entries);
  const std::size_t n = entries.size();
  // cost[i]: of the first i entries in the runs so far; from[k][i]: where the last of k + 1 runs begins.
  std::vector<double> cost(n + 1, 0.0);
  for (std::size_t i = 1; i <= n; ++i) cost[i] = costs.of(0, i);
  std::vector<std::vector<std::size_t>> from(clusters, std::vector<std::size_t>(n + 1, 0));
  for (std::size_t k = 1; k < clusters; ++k) {
    std::vector<double> next(n + 1, std::numeric_limits<double>::infinity());
    addRun(costs, cost, {k + 1, n, k, n - 1}, next, from[k]);
    cost = std::move(next);
  }
  std::vector<double> centres(clusters);
  std::size_t end = n;
  for (std::size_t k = clusters; k-- > 0;) {
    centres[k] = costs.mean(from[k][end], end);
    end = from[k][end];
  }
  return centres;
}

std::vector<double> spreadStart(const FcmEntries& entries, std::size_t clusters, base::Random& random) {
  std::vector<double> share(entries.weights.begin(), entries.weights.end());
  std::vector<double> nearest(entries.values.size(), std::numeric_limits<double>::infinity());
  std::vector<double> centres;
  while (centres.size() < clusters) {
    const double total = std::accumulate(share.begin(), share.end(), 0.0);
    double target = random.uniform() * total;
    std::size_t chosen = entries.values.size();
    for (std::size_t i = 0; i < share.size() && (chosen == entries.values.size() || target >= 0); ++i) {
      if (share[i] <= 0) continue;
      chosen = i;
      target -= share[i];
    }
    if (chosen == entries.values.size()) break;
    centres.push_back(entries.values[chosen]);
    for (std::size_t i = 0; i < share.size(); ++i) {
      const double distance = entries.values[i] - centres.back();
      nearest[i] = std::min(nearest[i], distance * distance);
      share[i] = entries.weights[i] * nearest[i];
    }
  }
  std::sort(centres.begin(), centres.end());
  return centres;
}

}  // namespace tactus::elicitation
