#include <cmath>
#include <gtest/gtest.h>

#include "elicitation/speed/participant_speeds.h"

#include "tests/elicitation/golden_speeds.h"

namespace tactus::elicitation {
namespace {

using Groups = std::vector<std::vector<double>>;

TEST(LevelTrend, EqualsTheCountOverEveryArrangement) {
  for (const auto& wanted : goldenSpeeds("trends")) {
    const auto found = jonckheereTerpstra(wanted.at("groups").get<Groups>());
    ASSERT_TRUE(found) << wanted.at("name");
    EXPECT_TRUE(found->exact);
    EXPECT_EQ(found->j, wanted.at("j").get<double>()) << wanted.at("name");
    // Counts up to 17,153,136 are exact; one division is left.
    const double arrangements = wanted.at("arrangements").get<double>();
    EXPECT_DOUBLE_EQ(found->p, wanted.at("at_least").get<double>() / arrangements) << wanted.at("name");
    EXPECT_LE(found->least_p, found->p);
  }
}

TEST(LevelTrend, PerfectOrderOfThreeTimesFourStrokesIsOneInThirtyFourThousand) {
  const auto found = jonckheereTerpstra(Groups{{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}});
  EXPECT_EQ(found->j, 48);
  EXPECT_EQ(found->most_j, 48);
  EXPECT_DOUBLE_EQ(found->p, 1.0 / 34650);  // 12! / (4! 4! 4!)
  EXPECT_DOUBLE_EQ(found->least_p, 1.0 / 34650);
}

TEST(LevelTrend, TwoGroupsAreMannAndWhitney) {
  // U = 8 of 9 pairs; of the 20 arrangements U = 9 and U = 8 come once each.
  const auto found = jonckheereTerpstra(Groups{{1, 2, 4}, {3, 5, 6}});
  EXPECT_EQ(found->j, 8);
  EXPECT_DOUBLE_EQ(found->p, 2.0 / 20);
  EXPECT_DOUBLE_EQ(found->least_p, 1.0 / 20);
}

TEST(LevelTrend, LargeGroupsUseTheNormalApproximationWithTies) {
  Groups groups(2);
  for (int i = 0; i < 150; ++i) {
    groups[0].push_back(i / 3);        // 50 values, three times each
    groups[1].push_back((i + 9) / 3);  // the same, three steps up
  }
  const auto found = jonckheereTerpstra(groups);
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->exact);
  // By hand, a and b from 0 to 49 and 3 to 52, nine pairs of samples each: a < b in 2500 - (a > b: 46 * 47 / 2 = 1081)
  // - (a = b: 47) = 1372, so J = 9 (1372 + 47 / 2) = 12559.5. Mann and Whitney: mean 150^2 / 2,
  // variance 150^2 / 12 (301 - sum(t^3 - t) / (300 * 299)) with t = 6 for 47 values and 3 for 6.
  EXPECT_EQ(found->j, 12559.5);
  const double variance = 22500.0 / 12 * (301 - (47 * 210 + 6 * 24) / (300.0 * 299));
  const double z = (12559.5 - 11250) / std::sqrt(variance);
  EXPECT_NEAR(found->p, std::erfc(z / std::sqrt(2.0)) / 2, 1e-14);  // rounding of a number near 0.04
}

TEST(LevelTrend, GroupsWithoutValuesArePassedOver) {
  EXPECT_FALSE(jonckheereTerpstra(Groups{}));
  EXPECT_FALSE(jonckheereTerpstra(Groups{{1, 2}, {}}));
  const auto found = jonckheereTerpstra(Groups{{1, 2}, {}, {3}});
  ASSERT_TRUE(found);
  EXPECT_DOUBLE_EQ(found->p, 1.0 / 3);
}

// As many arrangements as 2^64, which is 0 in 64 bits: the exact distribution must see that it is too large.
TEST(LevelTrend, ManyGroupsOfOneValue) {
  Groups groups;
  for (int i = 0; i < 64; ++i) groups.push_back({static_cast<double>(i)});
  const auto found = jonckheereTerpstra(groups);
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->exact);
  EXPECT_EQ(found->j, 64 * 63 / 2);
  // Kendall's tau of 64 values in their order: 2J has mean 64 * 63 / 2 and variance 64 * 63 * 133 / 18.
  const double z = 64 * 63 / 2.0 / std::sqrt(64 * 63 * 133 / 18.0);
  EXPECT_NEAR(found->p, std::erfc(z / std::sqrt(2.0)) / 2, 1e-12 * found->p);  // rounding, far out in the tail
}

}  // namespace
}  // namespace tactus::elicitation
