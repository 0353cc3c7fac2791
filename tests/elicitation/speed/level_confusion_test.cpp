#include <gtest/gtest.h>

#include "elicitation/speed/participant_speeds.h"

namespace tactus::elicitation {
namespace {

std::vector<study::SpeedSample> samplesOf(std::initializer_list<std::pair<const char*, double>> list) {
  std::vector<study::SpeedSample> samples;
  for (const auto& [level, speed] : list) samples.push_back({"S1", level, 1, 0, 0, speed});
  return samples;
}

const std::vector<std::string> kLevels{"slow", "fast"};
const std::vector<double> kCentres{10, 100};

TEST(LevelConfusion, PerfectClustersHaveNoWarning) {
  const auto found = levelConfusion(samplesOf({{"slow", 9}, {"slow", 12}, {"fast", 99}}), kLevels, kCentres, "S1");
  EXPECT_EQ(found.counts, (std::vector<std::vector<std::size_t>>{{2, 0}, {0, 1}}));
  EXPECT_EQ(found.accuracy, 1);
  EXPECT_DOUBLE_EQ(found.adjusted_rand_index, 1);
  EXPECT_TRUE(found.warnings.empty());
}

TEST(LevelConfusion, CountsByHandAndWarns) {
  // Table {{2, 1}, {1, 2}}: pairs together 1 + 0 + 0 + 1 = 2, in levels 3 + 3, in clusters 3 + 3, of 15.
  // Index (2 - 36/15) / (6 - 36/15) = -0.4 / 3.6.
  const auto found =
      levelConfusion(samplesOf({{"slow", 9}, {"slow", 12}, {"slow", 80}, {"fast", 99}, {"fast", 101}, {"fast", 20}}),
                     kLevels, kCentres, "S2");
  EXPECT_EQ(found.counts, (std::vector<std::vector<std::size_t>>{{2, 1}, {1, 2}}));
  EXPECT_DOUBLE_EQ(found.accuracy, 4.0 / 6);
  EXPECT_NEAR(found.adjusted_rand_index, -1.0 / 9, 1e-15);
  ASSERT_EQ(found.warnings.size(), 1U);
  EXPECT_NE(found.warnings[0].find("S2"), std::string::npos);
}

TEST(LevelConfusion, OtherLevelsAreCountedAndSaid) {
  const auto found = levelConfusion(samplesOf({{"slow", 9}, {"fast", 99}, {"warm_up", 50}}), kLevels, kCentres, "S1");
  EXPECT_EQ(found.other_levels, 1U);
  EXPECT_EQ(found.warnings.size(), 1U);
}

}  // namespace
}  // namespace tactus::elicitation
