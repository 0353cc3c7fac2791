// The category that each rater gave each unit: the input of every agreement measure.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace tactus::elicitation {

/// A result, or one sentence about why the ratings give none. Too few ratings are not a mistake, so this is not an
/// Error.
template <class T>
using OrReason = tl::expected<T, std::string>;

/// A table of units (forces, items of a form) by raters. Any rating may be missing. Categories are ordered and counted
/// from 0, the lowest first.
class Ratings {
 public:
  Ratings(std::size_t units, std::size_t raters, std::size_t categories);

  std::size_t units() const { return units_; }
  std::size_t raters() const { return raters_; }
  std::size_t categories() const { return categories_; }

  /// The category; nothing if the rating is missing.
  std::optional<std::size_t> at(std::size_t unit, std::size_t rater) const;
  void set(std::size_t unit, std::size_t rater, std::size_t category);

 private:
  std::size_t place(std::size_t unit, std::size_t rater) const;

  std::size_t units_;
  std::size_t raters_;
  std::size_t categories_;
  std::vector<std::optional<std::size_t>> values_;
};

/// For each unit the number of raters per category, without their identity. All numbers are >= 0.
struct RatingCounts {
  std::size_t categories = 0;
  std::vector<std::vector<int>> units;  ///< each with `categories` numbers
};

RatingCounts countRatings(const Ratings& ratings);

/// The number of ratings of one unit.
long long ratingsOf(const std::vector<int>& unit);

}  // namespace tactus::elicitation
