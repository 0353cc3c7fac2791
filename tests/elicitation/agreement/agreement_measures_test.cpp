// Fleiss' kappa, Krippendorff's alpha, Kendall's W and the consensus of an item, by hand and by the literature.
#include <cmath>
#include <gtest/gtest.h>

#include "elicitation/agreement/agreement.h"
#include "elicitation/agreement/krippendorff_alpha.h"

namespace tactus::elicitation {
namespace {

constexpr int kMissing = -1;
using Rows = std::vector<std::vector<int>>;  // one per rater, kMissing where there is no rating

Ratings ratingsOfRaters(const Rows& raters, std::size_t categories) {
  Ratings out(raters.front().size(), raters.size(), categories);
  for (std::size_t rater = 0; rater < raters.size(); ++rater) {
    for (std::size_t unit = 0; unit < raters[rater].size(); ++unit) {
      if (raters[rater][unit] != kMissing) out.set(unit, rater, static_cast<std::size_t>(raters[rater][unit]));
    }
  }
  return out;
}

// Krippendorff 2011, "Computing Krippendorff's Alpha-Reliability", section C: four observers, twelve units, categories
// 1 to 5 here 0 to 4.
const Rows kKrippendorff = {{0, 1, 2, 2, 1, 0, 3, 0, 1, kMissing, kMissing, kMissing},
                            {0, 1, 2, 2, 1, 1, 3, 0, 1, 4, kMissing, 2},
                            {kMissing, 2, 2, 2, 1, 2, 3, 1, 1, 4, 0, kMissing},
                            {0, 1, 2, 2, 1, 3, 3, 0, 1, 4, 0, kMissing}};

TEST(KrippendorffAlpha, HasTheValuesOfItsAuthorsExampleWithMissingRatings) {
  const auto counts = countRatings(ratingsOfRaters(kKrippendorff, 5));
  EXPECT_NEAR(krippendorffAlpha(counts, AlphaLevel::kNominal).value(), 0.743, 5e-4);   // as printed
  EXPECT_NEAR(krippendorffAlpha(counts, AlphaLevel::kOrdinal).value(), 0.815, 5e-4);   // as printed
  EXPECT_NEAR(krippendorffAlpha(counts, AlphaLevel::kInterval).value(), 0.849, 5e-4);  // as printed
}

TEST(KrippendorffAlpha, OfFullAgreementIsOne) {
  const RatingCounts counts{3, {{2, 0, 0}, {0, 4, 0}, {0, 0, 3}}};
  for (const auto level : {AlphaLevel::kNominal, AlphaLevel::kOrdinal, AlphaLevel::kInterval}) {
    EXPECT_EQ(krippendorffAlpha(counts, level).value(), 1);
  }
}

TEST(KrippendorffAlpha, TwoCategoriesHaveOneAlpha) {
  // Two units, AB and AA: pairs that differ 1, n = 4, n_A = 3, n_B = 1: 1 - 3 * 1 / 3 = 0.
  const RatingCounts counts{2, {{1, 1}, {2, 0}}};
  for (const auto level : {AlphaLevel::kNominal, AlphaLevel::kOrdinal, AlphaLevel::kInterval}) {
    EXPECT_NEAR(krippendorffAlpha(counts, level).value(), 0, 1e-15);  // rounding
  }
}

TEST(KrippendorffAlpha, WithNothingToCompareSaysWhy) {
  EXPECT_EQ(krippendorffAlpha({3, {}}, AlphaLevel::kOrdinal).error(),
            "no unit has two ratings, so there is nothing to compare");
  EXPECT_EQ(krippendorffAlpha({3, {{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}, AlphaLevel::kOrdinal).error(),
            "no unit has two ratings, so there is nothing to compare");
  EXPECT_EQ(krippendorffAlpha({3, {{0, 4, 0}, {0, 2, 0}, {1, 0, 0}}}, AlphaLevel::kOrdinal).error(),
            "all ratings are the same, so nothing says how much chance alone would agree");
}

TEST(FleissKappa, HasTheValueOfItsAuthorsKindOfTable) {
  // By hand: P = (1 + 0) / 2, p = (3/4, 1/4), P_e = 10/16, kappa = (0.5 - 0.625) / 0.375 = -1/3. The error under
  // chance: sqrt(2 / (2 2 1)) sqrt((3/8)^2 - 3/16 (-1/2 + 1/2)) / (3/8) = sqrt(1/2).
  const auto kappa = fleissKappa({2, {{2, 0}, {1, 1}}});
  ASSERT_TRUE(kappa);
  EXPECT_NEAR(kappa->kappa, -1.0 / 3, 1e-15);                 // rounding
  EXPECT_NEAR(kappa->standard_error, std::sqrt(0.5), 1e-15);  // rounding
  EXPECT_NEAR(kappa->z, -std::sqrt(2.0) / 3, 1e-15);          // rounding
  EXPECT_NEAR(kappa->p, std::erfc(1.0 / 3), 1e-15);           // rounding
  EXPECT_EQ(kappa->ratings_per_unit, 2);
}

TEST(FleissKappa, SaysWhyThereIsNone) {
  EXPECT_EQ(fleissKappa({2, {}}).error(), "there is no rating");
  EXPECT_EQ(fleissKappa({2, {{1, 0}, {0, 1}}}).error(), "no unit has two ratings, so there is nothing to compare");
  EXPECT_EQ(fleissKappa({2, {{3, 0}, {2, 0}}}).error(),
            "the measure wants the same number of ratings for every unit, and they run from 2 to 3");
  EXPECT_EQ(fleissKappa({2, {{3, 0}, {3, 0}}}).error(),
            "all ratings are the same, so nothing says how much chance alone would agree");
}

TEST(KendallW, IsOneForOneOrderAndZeroForOpposites) {
  const auto alike = kendallW(ratingsOfRaters({{0, 1, 2, 3}, {0, 1, 2, 3}, {1, 2, 3, 4}}, 5));
  ASSERT_TRUE(alike);
  EXPECT_DOUBLE_EQ(alike->w, 1);
  EXPECT_DOUBLE_EQ(alike->chi_square, 9);
  EXPECT_EQ(alike->degrees, 3);
  EXPECT_EQ(alike->raters, 3);
  EXPECT_DOUBLE_EQ(kendallW(ratingsOfRaters({{0, 1, 2, 3}, {3, 2, 1, 0}}, 5))->w, 0);
}

TEST(KendallW, CorrectsForTies) {
  // Ranks 1.5 1.5 3 and 1 2.5 2.5: sums 2.5, 4, 5.5, S = 4.5, ties 6 each: 12 4.5 / (4 24 - 2 12) = 0.75.
  EXPECT_DOUBLE_EQ(kendallW(ratingsOfRaters({{0, 0, 1}, {0, 1, 1}}, 2))->w, 0.75);
}

TEST(KendallW, CountsTheUnitsThatEveryRaterRated) {
  const auto w = kendallW(ratingsOfRaters({{0, 1, kMissing, 2, 3},
                                           {0, 1, 4, 2, 3},
                                           {0, 1, 0, kMissing, 3},
                                           {kMissing, kMissing, kMissing, kMissing, kMissing}},
                                          5));
  ASSERT_TRUE(w);
  EXPECT_EQ(w->raters, 3) << "a rater without any rating does not count";
  EXPECT_EQ(w->units, 3);
  EXPECT_EQ(w->dropped_units, 2);
  EXPECT_DOUBLE_EQ(w->w, 1);
}

TEST(KendallW, SaysWhyThereIsNone) {
  EXPECT_EQ(kendallW(ratingsOfRaters({{0, 1, 2}}, 3)).error(), "the measure wants two raters or more");
  EXPECT_EQ(kendallW(Ratings(3, 2, 3)).error(), "the measure wants two raters or more");
  EXPECT_EQ(kendallW(ratingsOfRaters({{0, kMissing}, {kMissing, 1}}, 3)).error(),
            "the measure wants two units or more that every rater rated, and there is none");
  EXPECT_EQ(kendallW(ratingsOfRaters({{0, 1}, {kMissing, 1}}, 3)).error(),
            "the measure wants two units or more that every rater rated, and there is one");
  EXPECT_EQ(kendallW(ratingsOfRaters({{1, 1, 1}, {2, 2, 2}}, 3)).error(),
            "every rater gave all units the same term, so there is no order to compare");
}

TEST(ItemConsensus, KnowsThatNeighborsAreCloserThanEnds) {
  const auto ends = itemConsensus({2, 0, 0, 0, 2});
  const auto neighbors = itemConsensus({0, 2, 2, 0, 0});
  ASSERT_TRUE(ends && neighbors);
  EXPECT_DOUBLE_EQ(ends->consensus, 0);
  EXPECT_DOUBLE_EQ(ends->entropy_bits, 1);
  EXPECT_EQ(ends->spread_terms, 4);
  // Both answers are half a step of four from the mean: 1 + log2(1 - 1/8).
  EXPECT_NEAR(neighbors->consensus, 1 + std::log2(0.875), 1e-15);  // rounding
  EXPECT_DOUBLE_EQ(neighbors->entropy_bits, 1);
  EXPECT_EQ(neighbors->spread_terms, 1);
  const auto same = itemConsensus({0, 0, 3, 0, 0});
  EXPECT_EQ(same->consensus, 1);
  EXPECT_EQ(same->entropy_bits, 0);
  EXPECT_EQ(same->spread_terms, 0);
  EXPECT_EQ(itemConsensus({5})->consensus, 1);
}

TEST(ItemConsensus, OneRatingAgreesWithNobody) {
  EXPECT_FALSE(itemConsensus({0, 1, 0}));
  EXPECT_FALSE(itemConsensus({0, 0, 0}));
}

}  // namespace
}  // namespace tactus::elicitation
