#include "elicitation/agreement/kendall_w.h"

#include <algorithm>
#include <cmath>

#include "elicitation/agreement/chi_square.h"

namespace tactus::elicitation {
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

}  // namespace tactus::elicitation
