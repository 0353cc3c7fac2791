#include "elicitation/agreement/ratings.h"

#include <numeric>

#include "core/base/check.h"

namespace tactus::elicitation {

Ratings::Ratings(std::size_t units, std::size_t raters, std::size_t categories)
    : units_(units), raters_(raters), categories_(categories), values_(units * raters) {}

std::size_t Ratings::place(std::size_t unit, std::size_t rater) const {
  TACTUS_CHECK(unit < units_ && rater < raters_);
  return unit * raters_ + rater;
}

std::optional<std::size_t> Ratings::at(std::size_t unit, std::size_t rater) const {
  return values_[place(unit, rater)];
}

void Ratings::set(std::size_t unit, std::size_t rater, std::size_t category) {
  TACTUS_CHECK(category < categories_);
  values_[place(unit, rater)] = category;
}

RatingCounts countRatings(const Ratings& ratings) {
  RatingCounts counts{ratings.categories(), {}};
  for (std::size_t unit = 0; unit < ratings.units(); ++unit) {
    auto& row = counts.units.emplace_back(ratings.categories());
    for (std::size_t rater = 0; rater < ratings.raters(); ++rater) {
      if (const auto category = ratings.at(unit, rater)) ++row[*category];
    }
  }
  return counts;
}

long long ratingsOf(const std::vector<int>& unit) { return std::accumulate(unit.begin(), unit.end(), 0LL); }

}  // namespace tactus::elicitation
