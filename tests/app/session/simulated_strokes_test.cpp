#include "app/session/simulated_strokes.h"

#include <cmath>
#include <gtest/gtest.h>

#include "experiments/speed_from_positions.h"
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

TEST(SimulatedStrokes, AreForwardPartsOfAboutSixtyMillimetresAtOneKilohertz) {
  const auto samples = simulatedStrokes(experiments::publishedSpeeds(), 5);
  double start_mm = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto& sample = samples[i];
    const bool first = i == 0 || samples[i - 1].stroke != sample.stroke;
    const bool last = i + 1 == samples.size() || samples[i + 1].stroke != sample.stroke;
    if (first) {
      EXPECT_EQ(sample.time_s, 0);
      start_mm = sample.depth_mm;
      EXPECT_LT(start_mm, 1);
    } else {
      EXPECT_NEAR(sample.time_s - samples[i - 1].time_s, 0.001, 1e-12);  // rounding of decimal fractions
    }
    if (first || last) {
      EXPECT_GT(sample.speed_mm_s, experiments::kRestSpeedMmS - 0.001);  // rounded to 0.001
    }
    if (last) {
      EXPECT_NEAR(sample.depth_mm - start_mm, 60, 5);  // "about", as the header says
    }
  }
}

TEST(SimulatedStrokes, SpeedsComeFromPositionsInStepsOfADevice) {
  // The depths between missed ticks are multiples of 0.055 mm, and the derivative of the depths gives the speeds again
  // in the middle of each forward part, where the window has the same samples: depths are rounded to 0.001 mm, so by
  // at most 0.0005 * 240 / 2480 * 1000 mm/s, and speeds to 0.001.
  const auto samples = simulatedStrokes(experiments::publishedSpeeds(), 4);
  std::size_t on_steps = 0;
  for (std::size_t begin = 0; begin < samples.size();) {
    std::vector<double> time_s, depth_mm;
    std::size_t end = begin;
    for (; end < samples.size() && samples[end].stroke == samples[begin].stroke; ++end) {
      time_s.push_back(samples[end].time_s);
      depth_mm.push_back(samples[end].depth_mm);
      const double steps = samples[end].depth_mm / 0.055;
      on_steps += std::abs(steps - std::round(steps)) < 0.0006 / 0.055 ? 1 : 0;
    }
    const auto motion = experiments::speedFromPositions(time_s, depth_mm);
    ASSERT_TRUE(motion);
    ASSERT_EQ(motion->samples.size(), end - begin);
    for (std::size_t i = 15; i + 15 < end - begin; ++i) {
      EXPECT_NEAR(motion->samples[i].speed_mm_s, samples[begin + i].speed_mm_s, 0.0495);
    }
    begin = end;
  }
  EXPECT_GT(static_cast<double>(on_steps), 0.99 * static_cast<double>(samples.size()));
}

TEST(SimulatedStrokes, FollowFromTheSeed) {
  const auto table = experiments::publishedSpeeds();
  EXPECT_EQ(simulatedStrokes(table, 8), simulatedStrokes(table, 8));
  EXPECT_NE(simulatedStrokes(table, 8), simulatedStrokes(table, 9));
}

}  // namespace
}  // namespace tactus::session
