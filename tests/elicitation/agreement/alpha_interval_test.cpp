#include <gtest/gtest.h>

#include "elicitation/agreement/krippendorff_alpha.h"

namespace tactus::elicitation {
namespace {

/// The votes of the paper's Table 2.
RatingCounts ratingsOfTable2() {
  return {5,
          {{3, 1, 0, 0, 0},
           {2, 1, 1, 0, 0},
           {1, 1, 1, 1, 0},
           {0, 2, 1, 0, 1},
           {0, 0, 2, 1, 1},
           {0, 0, 2, 1, 1},
           {0, 0, 1, 2, 1},
           {0, 0, 1, 1, 2},
           {0, 0, 0, 2, 2},
           {0, 0, 0, 1, 3},
           {0, 0, 0, 0, 4}}};
}

TEST(AlphaInterval, Table2AsAnotherProgramDrawsIt) {
  const auto interval = alphaInterval(ratingsOfTable2(), AlphaLevel::kOrdinal);
  ASSERT_TRUE(interval);
  // A program in Python with its own alpha and 60,000 draws. The quantiles of 2,000 draws scatter by about .01.
  EXPECT_NEAR(interval->low, 0.133, 0.03);
  EXPECT_NEAR(interval->high, 0.743, 0.03);
  EXPECT_EQ(interval->draws, 2'000U);
}

TEST(AlphaInterval, FullAgreementHasNoWidth) {
  const auto interval = alphaInterval({2, {{2, 0}, {0, 2}, {2, 0}}}, AlphaLevel::kNominal);
  ASSERT_TRUE(interval);
  EXPECT_EQ(interval->low, 1);
  EXPECT_EQ(interval->high, 1);
  // A third of the draws has one category alone: (2/3)^3 + (1/3)^3. Five standard deviations are .053.
  EXPECT_NEAR(static_cast<double>(interval->draws) / 2'000, 2.0 / 3, 0.06);
}

TEST(AlphaInterval, TooLittleToDrawFromOrAStop) {
  EXPECT_FALSE(alphaInterval({2, {{1, 1}}}, AlphaLevel::kNominal));
  EXPECT_FALSE(alphaInterval({2, {{2, 0}, {2, 0}}}, AlphaLevel::kNominal));
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(alphaInterval(ratingsOfTable2(), AlphaLevel::kOrdinal, {.stop = stop.get_token()}));
}

}  // namespace
}  // namespace tactus::elicitation
