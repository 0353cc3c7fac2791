#include "elicitation/speed/level_trend.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace tactus::elicitation {
namespace {

// Additions that the exact distribution may cost: about a tenth of a second.
constexpr double kMostAdditions = 1e8;

using Counts = std::vector<std::size_t>;

/// Twice the statistic, an integer.
std::size_t twiceJ(const std::vector<std::vector<double>>& groups) {
  std::size_t twice = 0;
  for (std::size_t low = 0; low < groups.size(); ++low) {
    for (std::size_t high = low + 1; high < groups.size(); ++high) {
      for (const double a : groups[low]) {
        for (const double b : groups[high]) twice += a < b ? 2 : (a == b ? 1 : 0);
      }
    }
  }
  return twice;
}

std::size_t pairsOfGroups(const Counts& sizes) {
  std::size_t pairs = 0;
  std::size_t lower = 0;
  for (const std::size_t size : sizes) {
    pairs += lower * size;
    lower += size;
  }
  return pairs;
}

/// How often each value occurs among all groups, in ascending order of the values.
Counts tieBlocks(const std::vector<std::vector<double>>& groups) {
  std::vector<double> all;
  for (const auto& group : groups) all.insert(all.end(), group.begin(), group.end());
  std::sort(all.begin(), all.end());
  Counts blocks;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i == 0 || all[i] != all[i - 1]) blocks.push_back(0);
    ++blocks.back();
  }
  return blocks;
}

/// The permutation distribution of 2J. The values are dealt out to the groups from the smallest up, equal ones at once;
/// all that matters of the past is how many each group has got.
class ExactDistribution {
 public:
  explicit ExactDistribution(Counts sizes) : sizes_(std::move(sizes)), width_(2 * pairsOfGroups(sizes_) + 1) {}

  /// The number of arrangements for each 2J; empty where that would cost too much.
  std::vector<double> of(const Counts& tie_blocks) {
    std::size_t states = 1;
    for (const std::size_t size : sizes_) {
      // Asked each time, before the product can overflow.
      if (static_cast<double>(states) * static_cast<double>(size + 1) * static_cast<double>(width_) > kMostAdditions) {
        return {};
      }
      states *= size + 1;
    }
    by_state_.assign(states, {});
    by_state_[0].assign(width_, 0.0);
    by_state_[0][0] = 1;
    Counts used(sizes_.size(), 0);
    Layer layer = {used};
    for (const std::size_t block : tie_blocks) {
      Layer next;
      for (const Counts& from : layer) {
        const std::vector<double> counts = std::move(by_state_[indexOf(from)]);
        by_state_[indexOf(from)].clear();
        Counts to = from;
        deal(counts, from, to, 0, block, 1, 0, next);
        if (additions_ > kMostAdditions) return {};
      }
      layer = std::move(next);
    }
    return by_state_.back();
  }

 private:
  using Layer = std::vector<Counts>;

  std::size_t indexOf(const Counts& used) const {
    std::size_t index = 0;
    for (std::size_t g = 0; g < sizes_.size(); ++g) index = index * (sizes_[g] + 1) + used[g];
    return index;
  }

  /// Deals `left` equal values to the groups from `group` on; `ways` and `gain` are those of the groups before it.
  void deal(const std::vector<double>& counts, const Counts& from, Counts& to, std::size_t group, std::size_t left,
            double ways, std::size_t gain, Layer& next) {
    if (group == sizes_.size()) {
      if (left > 0) return;
      auto& target = by_state_[indexOf(to)];
      if (target.empty()) {
        target.assign(width_, 0.0);
        next.push_back(to);
      }
      for (std::size_t twice = 0; twice + gain < width_; ++twice) target[twice + gain] += ways * counts[twice];
      additions_ += static_cast<double>(width_);
      return;
    }
    std::size_t below = 0;  // values that lower groups had before
    std::size_t equal = 0;  // values that lower groups get now
    for (std::size_t g = 0; g < group; ++g) {
      below += from[g];
      equal += to[g] - from[g];
    }
    const std::size_t most = std::min(left, sizes_[group] - from[group]);
    double choices = 1;  // ways to choose `given` of the `left` values
    for (std::size_t given = 0; given <= most; ++given) {
      to[group] = from[group] + given;
      deal(counts, from, to, group + 1, left - given, ways * choices, gain + given * (2 * below + equal), next);
      choices *= static_cast<double>(left - given) / static_cast<double>(given + 1);
    }
    to[group] = from[group];
  }

  Counts sizes_;
  std::size_t width_;
  double additions_ = 0;
  std::vector<std::vector<double>> by_state_;
};

/// Sum of n(n - 1)...(2n + 5) and of the falling products, as the variance needs them.
struct TieSums {
  double fives = 0;
  double pairs = 0;
  double triples = 0;

  explicit TieSums(const Counts& counts) {
    for (const std::size_t count : counts) {
      const auto n = static_cast<double>(count);
      fives += n * (n - 1) * (2 * n + 5);
      pairs += n * (n - 1);
      triples += n * (n - 1) * (n - 2);
    }
  }
};

double normalP(double j, const Counts& sizes, const Counts& tie_blocks) {
  const TieSums all({std::accumulate(sizes.begin(), sizes.end(), std::size_t{0})});
  const TieSums groups(sizes);
  const TieSums ties(tie_blocks);
  double variance = (all.fives - groups.fives - ties.fives) / 72;
  if (all.triples > 0) variance += groups.triples * ties.triples / (36 * all.triples);
  variance += groups.pairs * ties.pairs / (8 * all.pairs);
  if (variance <= 0) return 1;
  const double mean = static_cast<double>(pairsOfGroups(sizes)) / 2;
  return std::erfc((j - mean) / std::sqrt(2 * variance)) / 2;
}

}  // namespace

std::optional<LevelTrend> jonckheereTerpstra(std::span<const std::vector<double>> groups) {
  std::vector<std::vector<double>> filled;
  Counts sizes;
  for (const auto& group : groups) {
    if (group.empty()) continue;
    filled.push_back(group);
    sizes.push_back(group.size());
  }
  if (filled.size() < 2) return std::nullopt;

  const std::size_t twice = twiceJ(filled);
  LevelTrend trend;
  trend.j = static_cast<double>(twice) / 2;
  trend.most_j = static_cast<double>(pairsOfGroups(sizes));
  const Counts ties = tieBlocks(filled);
  const std::vector<double> counts = ExactDistribution(sizes).of(ties);
  if (counts.empty()) {
    trend.exact = false;
    trend.p = normalP(trend.j, sizes, ties);
    return trend;
  }
  const double all = std::accumulate(counts.begin(), counts.end(), 0.0);
  trend.p = std::accumulate(counts.begin() + static_cast<std::ptrdiff_t>(twice), counts.end(), 0.0) / all;
  trend.least_p = *std::find_if(counts.rbegin(), counts.rend(), [](double count) { return count > 0; }) / all;
  return trend;
}

}  // namespace tactus::elicitation
