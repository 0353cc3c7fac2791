#include <cmath>
#include <gtest/gtest.h>

#include "experiments/stroke_speeds.h"

namespace tactus::experiments {
namespace {

TEST(SpeedSummary, MeanAndDeviationPerParticipantAndLevel) {
  const std::vector<study::SpeedSample> samples = {{"B", "slow", 1, 0, 0, 2},     {"B", "slow", 1, 0.001, 0, 4},
                                                   {"A", "fast", 1, 0, 0, 7},     {"B", "slow", 2, 0, 0, 4},
                                                   {"B", "slow", 2, 0.001, 0, 6}, {"B", "fast", 1, 0, 0, 1}};
  const auto summaries = summarizeSpeeds(samples);
  ASSERT_EQ(summaries.size(), 3U);
  EXPECT_EQ(summaries[0].participant, "B");
  EXPECT_EQ(summaries[0].level, "slow");
  EXPECT_EQ(summaries[0].strokes, 2U);
  EXPECT_EQ(summaries[0].samples, 4U);
  EXPECT_EQ(summaries[0].mean_mm_s, 4);
  EXPECT_DOUBLE_EQ(summaries[0].sd_mm_s, std::sqrt(8.0 / 3.0));  // squares 4 0 0 4 over n - 1 = 3
  EXPECT_EQ(summaries[1].participant, "A");
  EXPECT_EQ(summaries[1].mean_mm_s, 7);
  EXPECT_EQ(summaries[1].sd_mm_s, 0);
  EXPECT_EQ(summaries[2].level, "fast");
  EXPECT_EQ(summaries[2].participant, "B");
}

TEST(SpeedSummary, NoSamplesNoSummaries) { EXPECT_TRUE(summarizeSpeeds({}).empty()); }

}  // namespace
}  // namespace tactus::experiments
