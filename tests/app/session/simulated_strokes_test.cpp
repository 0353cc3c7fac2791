#include "app/session/simulated_strokes.h"

#include <gtest/gtest.h>

#include "experiments/speed_summary.h"

namespace tactus::session {
namespace {

TEST(SimulatedStrokes, MatchTable1) {
  const auto table = experiments::publishedSpeeds();
  for (const std::uint64_t seed : {0ULL, 1ULL, 2ULL, 3ULL, 77ULL, 123456789ULL}) {
    const auto summaries = experiments::summariseSpeeds(simulatedStrokes(table, seed));
    ASSERT_EQ(summaries.size(), table.size());
    for (std::size_t i = 0; i < table.size(); ++i) {
      EXPECT_EQ(summaries[i].participant, table[i].participant);
      EXPECT_EQ(summaries[i].level, table[i].level);
      EXPECT_EQ(summaries[i].strokes, 4U);
      // Half of the table's last digit is 0.05; the header promises 0.01.
      EXPECT_NEAR(summaries[i].mean_mm_s, table[i].mean_mm_s, 0.01);
      EXPECT_NEAR(summaries[i].sd_mm_s, table[i].sd_mm_s, 0.01);
    }
  }
}

TEST(SimulatedStrokes, AreSixtyMillimetresFromRestToRestAtOneKilohertz) {
  const auto samples = simulatedStrokes(experiments::publishedSpeeds(), 5);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto& sample = samples[i];
    EXPECT_GE(sample.speed_mm_s, 0);
    const bool first = i == 0 || samples[i - 1].stroke != sample.stroke;
    const bool last = i + 1 == samples.size() || samples[i + 1].stroke != sample.stroke;
    if (first) {
      EXPECT_EQ(sample.time_s, 0);
      EXPECT_EQ(sample.depth_mm, 0);
    } else {
      EXPECT_NEAR(sample.time_s - samples[i - 1].time_s, 0.001, 1e-12);  // rounding of decimal fractions
      // The trapezoid rule on speeds that are rounded to 0.001, and depths that are too.
      const double travelled_mm = (sample.speed_mm_s + samples[i - 1].speed_mm_s) / 2 * 0.001;
      EXPECT_NEAR(sample.depth_mm - samples[i - 1].depth_mm, travelled_mm, 0.00101);
    }
    if (first || last) {
      EXPECT_EQ(sample.speed_mm_s, 0);
    }
    if (last) {
      EXPECT_NEAR(sample.depth_mm, 60, 0.1);
    }
  }
}

TEST(SimulatedStrokes, FollowFromTheSeed) {
  const auto table = experiments::publishedSpeeds();
  EXPECT_EQ(simulatedStrokes(table, 8), simulatedStrokes(table, 8));
  EXPECT_NE(simulatedStrokes(table, 8), simulatedStrokes(table, 9));
}

}  // namespace
}  // namespace tactus::session
