#include "app/session/simulated_strokes.h"

#include <cmath>
#include <gtest/gtest.h>

#include "app/session/stroke_capture.h"
#include "core/base/statistics.h"
#include "experiments/stroke_speeds.h"

namespace tactus::session {
namespace {

CapturedStroke captured(const Recording& stream) {
  StrokeCapture capture;
  for (std::size_t i = 0; i < stream.time_s.size(); ++i) capture.add({stream.time_s[i], stream.depth_mm[i]});
  capture.finish();
  auto found = capture.take();
  EXPECT_TRUE(found);
  EXPECT_FALSE(capture.take());  // the way back is no stroke
  return found.value_or(CapturedStroke{});
}

std::vector<double> speedsOf(const Recording& stream) {
  auto found = captured(stream);
  study::StrokeRecord record;
  record.first = found.stroke.first - found.recording_first;
  record.last = found.stroke.last - found.recording_first;
  record.recording = std::move(found.recording);
  return experiments::strokeSpeeds(record).value_or(std::vector<double>{});
}

// All cells of Table 1 are in simulated_study_test.cpp; here the slowest, the fastest, and the ones with the least and
// the largest deviation, with seeds of their own.
TEST(SimulatedStrokes, AreMeasuredAsTable1) {
  const auto table = experiments::publishedSpeeds();
  for (const std::size_t cell : {2U, 5U, 7U, 9U}) {
    std::vector<double> speeds;
    const auto level = simulatedLevel(table[cell], 100 + cell);
    for (const auto& stream : level.strokes) {
      const auto own = speedsOf(stream);
      speeds.insert(speeds.end(), own.begin(), own.end());
    }
    // Half of the table's last digit; the header promises 0.04.
    EXPECT_NEAR(base::mean(speeds), table[cell].mean_mm_s, 0.05) << cell;
    EXPECT_NEAR(base::standardDeviation(speeds), table[cell].sd_mm_s, 0.05) << cell;
  }
}

TEST(SimulatedStrokes, AreOfAboutSixtyMillimetresAndTheBadOneIsShort) {
  const auto table = experiments::publishedSpeeds();
  for (const std::size_t cell : {3U, 7U, 9U}) {
    const auto level = simulatedLevel(table[cell], cell);
    ASSERT_EQ(level.strokes.size(), 4U);
    ASSERT_EQ(level.practice.size(), 2U);
    for (const auto* streams : {&level.strokes, &level.practice}) {
      for (const auto& stream : *streams) {
        const auto stroke = captured(stream).stroke;
        EXPECT_EQ(stroke.verdict, experiments::StrokeVerdict::kAccepted);
        EXPECT_NEAR(stroke.lengthMm(), 60, 5) << cell;  // "about", as the header says
      }
    }
    EXPECT_EQ(captured(level.too_short).stroke.verdict, experiments::StrokeVerdict::kTooShort) << cell;
  }
}

TEST(SimulatedStrokes, AreDepthsInStepsOfADevice) {
  const auto level = simulatedLevel({"S3", "slow", 57.9, 18.1}, 3);
  for (const auto& stream : level.strokes) {
    for (const double depth_mm : stream.depth_mm) {
      const double steps = depth_mm / 0.055;
      EXPECT_NEAR(steps, std::round(steps), 1e-6);
    }
  }
}

TEST(SimulatedStrokes, FollowFromTheSeed) {
  const experiments::PublishedSpeed target{"S3", "slow", 57.9, 18.1};
  const auto depths = [&](std::uint64_t seed) { return simulatedLevel(target, seed).strokes[0].depth_mm; };
  EXPECT_EQ(depths(8), depths(8));
  EXPECT_NE(depths(8), depths(9));
}

}  // namespace
}  // namespace tactus::session
