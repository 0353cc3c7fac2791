#include "elicitation/agreement/krippendorff_alpha.h"

#include <vector>

#include "core/base/random.h"
#include "core/base/statistics.h"

namespace tactus::elicitation {

std::optional<AlphaInterval> alphaInterval(const RatingCounts& counts, AlphaLevel level,
                                           const AlphaIntervalSettings& settings) {
  const std::size_t units = counts.units.size();
  if (units < 2) return std::nullopt;
  base::Random random(settings.seed);
  std::vector<double> alphas;
  RatingCounts draw = counts;
  for (std::size_t i = 0; i < settings.draws; ++i) {
    if (settings.stop.stop_requested()) return std::nullopt;
    for (auto& unit : draw.units) unit = counts.units[static_cast<std::size_t>(random.below(static_cast<int>(units)))];
    if (const auto alpha = krippendorffAlpha(draw, level)) alphas.push_back(*alpha);
  }
  if (alphas.size() * 2 < settings.draws) return std::nullopt;
  const double tail = (1 - settings.level) / 2;
  return AlphaInterval{base::quantile(alphas, tail), base::quantile(alphas, 1 - tail), alphas.size()};
}

namespace {

/// Pairs of ratings within units: pairs of a category with another, and how often each category is in a pair.
struct Coincidences {
  std::vector<std::vector<double>> pairs;  ///< [c][k] for c < k
  std::vector<double> totals;
  double total = 0;
};

Coincidences coincidencesOf(const RatingCounts& counts) {
  const std::size_t categories = counts.categories;
  Coincidences out{std::vector(categories, std::vector<double>(categories)), std::vector<double>(categories), 0};
  for (const auto& unit : counts.units) {
    const auto ratings = static_cast<double>(ratingsOf(unit));
    if (ratings < 2) continue;
    for (std::size_t c = 0; c < categories; ++c) {
      out.totals[c] += unit[c];
      for (std::size_t k = c + 1; k < categories; ++k) {
        out.pairs[c][k] += static_cast<double>(unit[c]) * unit[k] / (ratings - 1);
      }
    }
    out.total += ratings;
  }
  return out;
}

/// Position of each category, so that the difference of two is that of their positions.
std::vector<double> positions(const std::vector<double>& totals, AlphaLevel level) {
  std::vector<double> out;
  double below = 0;
  for (std::size_t c = 0; c < totals.size(); ++c) {
    out.push_back(level == AlphaLevel::kOrdinal ? below + totals[c] / 2 : static_cast<double>(c));
    below += totals[c];
  }
  return out;
}

}  // namespace

OrReason<double> krippendorffAlpha(const RatingCounts& counts, AlphaLevel level) {
  const Coincidences seen = coincidencesOf(counts);
  if (!(seen.total > 0)) {
    return tl::unexpected(std::string("no unit has two ratings, so there is nothing to compare"));
  }
  const auto position = positions(seen.totals, level);
  double observed = 0;
  double expected = 0;
  for (std::size_t c = 0; c < counts.categories; ++c) {
    for (std::size_t k = c + 1; k < counts.categories; ++k) {
      const double difference = level == AlphaLevel::kNominal ? 1 : position[k] - position[c];
      observed += seen.pairs[c][k] * difference * difference;
      expected += seen.totals[c] * seen.totals[k] * difference * difference;
    }
  }
  if (!(expected > 0)) {
    return tl::unexpected(std::string("all ratings are the same, so nothing says how much chance alone would agree"));
  }
  return 1 - (seen.total - 1) * observed / expected;
}

}  // namespace tactus::elicitation
