#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>

#include "core/analysis/term_conversion.h"
#include "core/base/statistics.h"
#include "core/base/text.h"
#include "elicitation/speed/participant_speeds.h"

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

namespace {

// Below these the clusters are something else than the levels: strokes simulated to the paper's Table 1 give an index
// of about 0.6 for participants whose levels are apart and 0.1 where the "slow" cluster is the start and stop of
// strokes.
constexpr double kLowRandIndex = 0.3;
constexpr double kLowAccuracy = 0.6;

double pairs(std::size_t count) { return 0.5 * static_cast<double>(count) * (static_cast<double>(count) - 1); }

double adjustedRandIndex(const std::vector<std::vector<std::size_t>>& counts) {
  double together = 0;
  double in_levels = 0;
  double in_clusters = 0;
  std::size_t all = 0;
  std::vector<std::size_t> columns(counts.empty() ? 0 : counts.front().size());
  for (const auto& row : counts) {
    std::size_t row_sum = 0;
    for (std::size_t k = 0; k < row.size(); ++k) {
      together += pairs(row[k]);
      row_sum += row[k];
      columns[k] += row[k];
    }
    in_levels += pairs(row_sum);
    all += row_sum;
  }
  for (const std::size_t column : columns) in_clusters += pairs(column);
  if (all < 2) return 1;
  const double chance = in_levels * in_clusters / pairs(all);
  const double most = (in_levels + in_clusters) / 2;
  return most == chance ? 1 : (together - chance) / (most - chance);
}

std::size_t nearestCentre(std::span<const double> centres, double x) {
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < centres.size(); ++k) {
    if (std::abs(x - centres[k]) < std::abs(x - centres[nearest])) nearest = k;
  }
  return nearest;
}

}  // namespace

LevelConfusion levelConfusion(std::span<const study::SpeedSample> samples, std::span<const std::string> levels,
                              std::span<const double> centres, const std::string& participant) {
  LevelConfusion out;
  out.levels.assign(levels.begin(), levels.end());
  out.counts.assign(levels.size(), std::vector<std::size_t>(centres.size()));
  std::size_t right = 0;
  std::size_t counted = 0;
  for (const auto& sample : samples) {
    const auto level = std::find(levels.begin(), levels.end(), sample.level);
    if (level == levels.end()) {
      ++out.other_levels;
      continue;
    }
    const auto row = static_cast<std::size_t>(level - levels.begin());
    const std::size_t cluster = nearestCentre(centres, sample.speed_mm_s);
    ++out.counts[row][cluster];
    ++counted;
    right += row == cluster ? 1 : 0;
  }
  if (out.other_levels > 0) {
    out.warnings.push_back("Participant " + participant + ": " + std::to_string(out.other_levels) +
                           " speed samples have a level that is not one of " + base::joined(levels, ", ") + ".");
  }
  if (counted == 0) return out;
  out.accuracy = static_cast<double>(right) / static_cast<double>(counted);
  out.adjusted_rand_index = adjustedRandIndex(out.counts);
  std::vector<std::string> low;
  if (out.adjusted_rand_index < kLowRandIndex) {
    low.push_back("adjusted Rand index " + base::formatFixed(out.adjusted_rand_index, 2) + ", below 0.3");
  }
  if (out.accuracy < kLowAccuracy) {
    low.push_back("accuracy " + base::formatFixed(out.accuracy, 2) + ", below 0.6");
  }
  if (!low.empty()) {
    out.warnings.push_back("Participant " + participant +
                           ": the samples nearest to each center are not those of the level that was asked for (" +
                           base::joined(low, "; ") +
                           "); the slow cluster may be the start and stop of the strokes, which trimming removes.");
  }
  return out;
}

std::vector<LevelSpeeds> levelSpeeds(std::span<const study::SpeedSample> samples, std::span<const std::string> levels) {
  std::vector<LevelSpeeds> out;
  for (const auto& level : levels) {
    std::vector<double> all;
    std::vector<std::vector<double>> strokes;
    std::map<int, std::size_t> places;
    for (const auto& sample : samples) {
      if (sample.level != level) continue;
      all.push_back(sample.speed_mm_s);
      const auto place = places.try_emplace(sample.stroke, strokes.size()).first->second;
      if (place == strokes.size()) strokes.emplace_back();
      strokes[place].push_back(sample.speed_mm_s);
    }
    LevelSpeeds one{.level = level, .samples = all.size(), .stroke_means_mm_s = {}};
    if (!all.empty()) one.mean_mm_s = base::mean(all);
    one.sd_mm_s = base::standardDeviation(all);
    for (const auto& stroke : strokes) one.stroke_means_mm_s.push_back(base::mean(stroke));
    out.push_back(std::move(one));
  }
  return out;
}

std::optional<double> separation(const LevelSpeeds& one, const LevelSpeeds& other) {
  if (one.samples == 0 || other.samples == 0 || one.samples + other.samples < 3) return std::nullopt;
  const auto freedom = [](const LevelSpeeds& level) { return static_cast<double>(level.samples) - 1; };
  const double pooled =
      std::sqrt((freedom(one) * one.sd_mm_s * one.sd_mm_s + freedom(other) * other.sd_mm_s * other.sd_mm_s) /
                (freedom(one) + freedom(other)));
  if (pooled == 0) return std::nullopt;
  return std::abs(one.mean_mm_s - other.mean_mm_s) / pooled;
}

namespace {

constexpr double kLowSeparation = 1;    // below it two levels share most of their speeds
constexpr double kSignificance = 0.05;  // the usual level

std::string fixed1(double value) { return base::formatFixed(value, 1); }

void warnOfSeparation(LevelDiagnostics& out, const std::string& who) {
  for (std::size_t k = 0; k < out.separations.size(); ++k) {
    if (!out.separations[k] || *out.separations[k] >= kLowSeparation) continue;
    out.warnings.push_back(who + ": the levels " + out.levels[k].level + " and " + out.levels[k + 1].level +
                           " are hardly apart (d' " + base::formatFixed(*out.separations[k], 2) + ", below 1).");
  }
}

void warnOfCentres(LevelDiagnostics& out, std::span<const double> centres, const std::string& who) {
  for (std::size_t k = 0; k < centres.size() && k < out.levels.size(); ++k) {
    const LevelSpeeds& level = out.levels[k];
    if (level.samples == 0 || std::abs(centres[k] - level.mean_mm_s) <= level.sd_mm_s) continue;
    out.warnings.push_back(who + ": the center for " + level.level + ", " + fixed1(centres[k]) +
                           " mm/s, lies outside the mean ± SD of that level, " + fixed1(level.mean_mm_s) + " ± " +
                           fixed1(level.sd_mm_s) + " mm/s.");
  }
}

void warnOfTrend(LevelDiagnostics& out, const std::string& who) {
  if (!out.trend || out.trend->p <= kSignificance || out.trend->least_p > kSignificance) return;
  out.warnings.push_back(who + ": the means of the strokes do not clearly rise with the level (Jonckheere-Terpstra J " +
                         base::formatNumber(out.trend->j) + " of " + base::formatNumber(out.trend->most_j) + ", p " +
                         base::formatFixed(out.trend->p, 2) + ").");
}

}  // namespace

LevelDiagnostics levelDiagnostics(std::span<const study::SpeedSample> samples, std::span<const std::string> levels,
                                  std::span<const double> centres, const std::string& participant) {
  LevelDiagnostics out;
  out.levels = levelSpeeds(samples, levels);
  for (std::size_t k = 0; k + 1 < out.levels.size(); ++k) {
    out.separations.push_back(separation(out.levels[k], out.levels[k + 1]));
  }
  std::vector<std::vector<double>> strokes;
  for (const auto& level : out.levels) strokes.push_back(level.stroke_means_mm_s);
  out.trend = jonckheereTerpstra(strokes);
  out.confusion = levelConfusion(samples, levels, centres, participant);
  out.warnings = out.confusion.warnings;
  const std::string who = "Participant " + participant;
  warnOfSeparation(out, who);
  warnOfCentres(out, centres, who);
  warnOfTrend(out, who);
  return out;
}

std::size_t termAt(const fuzzy::Variable& speed, double speed_mm_s) {
  return analysis::strongestTerm(speed, std::clamp(speed_mm_s, speed.min, speed.max)).value_or(0);
}

std::optional<std::string> sameTermNote(std::span<const LevelSpeeds> levels, const fuzzy::Variable& averaged,
                                        const fuzzy::Variable& own, const std::string& participant) {
  std::vector<std::string> means;
  std::vector<std::string> own_terms;
  std::size_t term = 0;
  for (const auto& level : levels) {
    if (level.samples == 0) continue;
    const std::size_t reads = termAt(averaged, level.mean_mm_s);
    if (!means.empty() && reads != term) return std::nullopt;
    term = reads;
    means.push_back(level.level + " " + fixed1(level.mean_mm_s));
    own_terms.push_back(own.terms[termAt(own, level.mean_mm_s)].id);
  }
  if (means.size() < 2) return std::nullopt;
  return "Participant " + participant + ": with the averaged terms the mean speeds of all levels (" +
         base::joined(means, ", ") + " mm/s) read as " + averaged.terms[term].id +
         "; with speed terms of the participant's own they read as " + base::joined(own_terms, ", ") + ".";
}

}  // namespace tactus::elicitation
