#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "app/session/simulated_strokes.h"

namespace tactus::session {
namespace {

RecordingNoise silent(std::size_t ticks) { return {std::vector<double>(ticks), std::vector<bool>(ticks)}; }

TEST(SimulatedRecording, IntegratesTheSpeedInStepsOfTheDevice) {
  // 55 mm/s are one step of 0.055 mm a tick; the first tick comes from rest and adds half a step, rounded up.
  const std::vector<double> speeds(5, 55);
  const auto recording = record(speeds, silent(5), 0);
  ASSERT_EQ(recording.time_s.size(), 5U);
  for (int i = 0; i < 5; ++i) {
    EXPECT_DOUBLE_EQ(recording.time_s[static_cast<std::size_t>(i)], i / 1000.0);
    EXPECT_NEAR(recording.depth_mm[static_cast<std::size_t>(i)], 0.055 * (i + 1), 1e-12);  // rounding of the product
  }
  // A quarter of a step earlier the rounding goes down.
  EXPECT_NEAR(record(speeds, silent(5), 0.75).depth_mm[0], 0.055, 1e-12);
}

TEST(SimulatedRecording, LosesTicksAndTrembles) {
  base::Random random(1);
  const auto noise = RecordingNoise::of(50000, random);
  EXPECT_FALSE(noise.missed.front());
  EXPECT_FALSE(noise.missed.back());
  const auto missed = std::count(noise.missed.begin(), noise.missed.end(), true);
  EXPECT_NEAR(static_cast<double>(missed), 50, 29);  // binomial, standard deviation 7.1, four of them
  const auto largest = *std::max_element(noise.tremor_mm.begin(), noise.tremor_mm.end());
  EXPECT_LE(largest, 0.1);
  EXPECT_GT(largest, 0.0999);
  int crossings = 0;
  for (std::size_t i = 1; i < noise.tremor_mm.size(); ++i) {
    crossings += (noise.tremor_mm[i] > 0) != (noise.tremor_mm[i - 1] > 0) ? 1 : 0;
  }
  EXPECT_GE(crossings, 2 * 8 * 50 - 2);  // 8 to 12 Hz for 50 s
  EXPECT_LE(crossings, 2 * 12 * 50 + 2);

  const auto recording = record(std::vector<double>(50000, 100), noise, 0);
  EXPECT_EQ(recording.time_s.size(), 50000U - static_cast<std::size_t>(missed));
  double furthest = 0;
  for (std::size_t i = 0; i < recording.time_s.size(); ++i) {
    furthest = std::max(furthest, std::abs(recording.depth_mm[i] - 100 * recording.time_s[i] - 0.05));
  }
  EXPECT_LE(furthest, 0.1 + 0.055 / 2 + 1e-6);
}

}  // namespace
}  // namespace tactus::session
