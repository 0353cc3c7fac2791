// Converts answers, judgements or a table of counts to ratings for the agreement measures.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "core/base/error.h"
#include "core/study/records.h"
#include "elicitation/force/force_voting.h"

namespace tactus::elicitation {

// The category that each rater gave each unit: the input of every agreement measure.

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

/// A rated unit: a force, or an item of a form.
struct RatedUnit {
  std::string name;               ///< `0.3 N`, `item 12`
  std::optional<double> force_n;  ///< if the unit is a force
  std::optional<int> item;        ///< number on the form, if the unit is an item
  std::string text;               ///< wording of the item, if the form is known
};

/// The units with at least one rating, and their ratings.
struct AgreementData {
  std::vector<std::string> terms;  ///< the categories, lowest first
  std::vector<RatedUnit> units;
  RatingCounts counts;
  std::vector<std::string> raters;  ///< participants with at least one rating; empty for a table of counts
  std::optional<Ratings> ratings;   ///< empty for a table of counts, which does not identify the raters
  std::string form;                 ///< of the answers
  std::vector<std::string> notes;   ///< one sentence each: omitted data
};

/// The answers to one form. A rating is an answer with status `answered`; skipped, cannot tell and cleared count as
/// missing.
/// `form_id`: empty selects the form with the most ratings (the first of equals) and notes the others. The terms are
/// those of the form if `forms` contains it, else `terms` (ids, lowest first).
/// Returns an error for: no answer to the form, an unknown term, an item that a known form lacks, two answers of a
/// participant to one item.
base::Result<AgreementData> agreementData(std::span<const study::Answer> answers, std::string_view form_id,
                                          std::span<const study::Form> forms, std::span<const std::string> terms);

/// The judgements of one `series`; units are the forces. A rating is a term; not felt, beyond practice and no answer
/// count as missing. Returns the errors of `countVotes`.
base::Result<AgreementData> agreementData(std::span<const study::ForceJudgement> judgements, std::string_view series,
                                          std::span<const std::string> terms);

/// A table of counts as printed in Table 2.
AgreementData agreementData(std::span<const VoteCounts> steps, std::span<const std::string> terms);

}  // namespace tactus::elicitation
