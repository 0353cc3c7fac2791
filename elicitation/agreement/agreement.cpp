#include "elicitation/agreement/agreement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/check.h"
#include "elicitation/agreement/agreement_data.h"

namespace tactus::elicitation {

double chiSquareUpperTail(double chi_square, int degrees) {
  TACTUS_CHECK(chi_square >= 0 && degrees >= 1);
  const double half = chi_square / 2;
  if (half == 0) return 1;
  // Term k is exp(-half) half^k / Gamma(k + 1), for k = 0, 1, … or 1/2, 3/2, … below degrees / 2. In logarithms,
  // because with many degrees the factors leave the range of double although their product does not.
  const bool odd = degrees % 2 == 1;
  double sum = odd ? std::erfc(std::sqrt(half)) : 0;
  double k = odd ? 0.5 : 0;
  double log_term = -half;
  if (odd) log_term += 0.5 * std::log(half) - 0.5 * std::log(std::numbers::pi / 4);
  for (; 2 * k < degrees; k += 1, log_term += std::log(half / k)) sum += std::exp(log_term);
  return std::min(sum, 1.0);
}

namespace {

std::vector<std::size_t> ratersWithRatings(const Ratings& ratings) {
  std::vector<std::size_t> out;
  for (std::size_t rater = 0; rater < ratings.raters(); ++rater) {
    for (std::size_t unit = 0; unit < ratings.units(); ++unit) {
      if (!ratings.at(unit, rater)) continue;
      out.push_back(rater);
      break;
    }
  }
  return out;
}

std::vector<std::size_t> completeUnits(const Ratings& ratings, const std::vector<std::size_t>& raters) {
  std::vector<std::size_t> out;
  for (std::size_t unit = 0; unit < ratings.units(); ++unit) {
    const bool complete = std::all_of(raters.begin(), raters.end(), [&ratings, unit](std::size_t rater) {
      return ratings.at(unit, rater).has_value();
    });
    if (complete) out.push_back(unit);
  }
  return out;
}

double cubeMinus(double n) { return n * n * n - n; }

}  // namespace

OrReason<KendallW> kendallW(const Ratings& ratings) {
  const auto raters = ratersWithRatings(ratings);
  if (raters.size() < 2) return tl::unexpected(std::string("the measure wants two raters or more"));
  const auto units = completeUnits(ratings, raters);
  if (units.size() < 2) {
    return tl::unexpected("the measure wants two units or more that every rater rated, and there " +
                          std::string(units.empty() ? "is none" : "is one"));
  }
  const auto n = static_cast<double>(units.size());
  const auto m = static_cast<double>(raters.size());

  std::vector<double> rank_sums(units.size());
  double ties = 0;  // over all raters and groups of t equal ratings: t^3 - t
  for (const std::size_t rater : raters) {
    std::vector<double> chosen(ratings.categories());
    for (const std::size_t unit : units) chosen[*ratings.at(unit, rater)] += 1;
    std::vector<double> mid_rank;
    double below = 0;
    for (const double count : chosen) {
      mid_rank.push_back(below + (count + 1) / 2);
      below += count;
      ties += cubeMinus(count);
    }
    for (std::size_t i = 0; i < units.size(); ++i) rank_sums[i] += mid_rank[*ratings.at(units[i], rater)];
  }
  double spread = 0;
  for (const double sum : rank_sums) spread += std::pow(sum - m * (n + 1) / 2, 2);
  const double largest = m * (m * cubeMinus(n) - ties);  // of 12 * spread
  if (!(largest > 0)) {
    return tl::unexpected(std::string("every rater gave all units the same term, so there is no order to compare"));
  }
  KendallW out;
  out.w = 12 * spread / largest;
  out.degrees = static_cast<int>(units.size()) - 1;
  out.chi_square = m * (n - 1) * out.w;
  out.p = chiSquareUpperTail(out.chi_square, out.degrees);
  out.raters = raters.size();
  out.units = units.size();
  out.dropped_units = ratings.units() - units.size();
  return out;
}

namespace {

tl::unexpected<std::string> because(std::string reason) { return tl::unexpected(std::move(reason)); }

}  // namespace

OrReason<FleissKappa> fleissKappa(const RatingCounts& counts) {
  if (counts.units.empty()) return because("there is no rating");
  long long fewest = ratingsOf(counts.units.front());
  long long most = fewest;
  for (const auto& unit : counts.units) {
    fewest = std::min(fewest, ratingsOf(unit));
    most = std::max(most, ratingsOf(unit));
  }
  if (fewest != most) {
    return because("the measure wants the same number of ratings for every unit, and they run from " +
                   std::to_string(fewest) + " to " + std::to_string(most));
  }
  if (most < 2) return because("no unit has two ratings, so there is nothing to compare");

  const auto units = static_cast<double>(counts.units.size());
  const auto raters = static_cast<double>(most);
  std::vector<double> chosen(counts.categories);
  double agreeing_pairs = 0;
  for (const auto& unit : counts.units) {
    for (std::size_t k = 0; k < unit.size(); ++k) {
      chosen[k] += unit[k];
      agreeing_pairs += static_cast<double>(unit[k]) * (unit[k] - 1.0);
    }
  }
  const double ratings = units * raters;
  double expected_disagreement = 0;  // sum of p q
  double skewness = 0;               // sum of p q (q - p)
  for (const double count : chosen) {
    const double p = count / ratings;
    const double q = (ratings - count) / ratings;
    expected_disagreement += p * q;
    skewness += p * q * (q - p);
  }
  if (!(expected_disagreement > 0)) {
    return because("all ratings are the same, so nothing says how much chance alone would agree");
  }
  FleissKappa out;
  const double observed_disagreement = 1 - agreeing_pairs / (ratings * (raters - 1));
  out.kappa = 1 - observed_disagreement / expected_disagreement;
  out.standard_error = std::sqrt(2 / (ratings * (raters - 1))) *
                       std::sqrt(expected_disagreement * expected_disagreement - skewness) / expected_disagreement;
  out.z = out.kappa / out.standard_error;
  out.p = std::erfc(std::abs(out.z) / std::sqrt(2.0));
  out.ratings_per_unit = most;
  return out;
}

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

Agreement agreement(const AgreementData& data) {
  Agreement out{.fleiss_kappa = fleissKappa(data.counts),
                .alpha_nominal = krippendorffAlpha(data.counts, AlphaLevel::kNominal),
                .alpha_ordinal = krippendorffAlpha(data.counts, AlphaLevel::kOrdinal),
                .alpha_interval = krippendorffAlpha(data.counts, AlphaLevel::kInterval),
                .kendall_w = tl::unexpected(
                    std::string("a table of counts does not say who chose what, and the measure compares persons")),
                .items = {}};
  if (data.ratings) out.kendall_w = kendallW(*data.ratings);
  double sum = 0;
  int count = 0;
  for (const auto& unit : data.counts.units) {
    const auto& item = out.items.emplace_back(itemConsensus(unit));
    if (item) sum += item->consensus;
    if (item) ++count;
    out.ratings += ratingsOf(unit);
  }
  if (count > 0) out.mean_consensus = sum / count;
  return out;
}

std::string_view nominalCaution() {
  return "Fleiss' kappa misleads here: it takes neighboring terms for as different as the ends of the scale, so "
         "raters "
         "who are one term apart count as strangers.";
}

}  // namespace tactus::elicitation
