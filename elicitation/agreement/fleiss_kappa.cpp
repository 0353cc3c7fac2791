#include "elicitation/agreement/fleiss_kappa.h"

#include <algorithm>
#include <cmath>

namespace tactus::elicitation {
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

}  // namespace tactus::elicitation
