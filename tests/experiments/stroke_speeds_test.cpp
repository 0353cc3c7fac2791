#include "experiments/stroke_speeds.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/experiments/record_maker.h"

namespace tactus::experiments {
namespace {

study::StrokeRecord withSpeeds(std::uint64_t id, const std::string& level, int number,
                               std::vector<double> speeds_mm_s) {
  study::StrokeRecord record;
  record.entry.id = idOf(id);
  record.level = level;
  record.number = number;
  record.verdict = "accepted";
  record.last = speeds_mm_s.size();
  record.recording.channels = {{"speed", "mm/s", std::move(speeds_mm_s)}};
  return record;
}

TEST(StrokeSpeeds, MeanAndDeviationPerStrokeAndLevel) {
  auto practice = withSpeeds(1, "slow", 1, {900, 900});
  practice.practice = true;
  auto bad = withSpeeds(2, "slow", 1, {800, 800});
  bad.verdict = "too_short";
  auto taken_back = withSpeeds(3, "slow", 1, {700, 700});
  auto rejection = withSpeeds(4, "slow", 1, {700, 700});
  rejection.entry.supersedes = idOf(3);
  rejection.verdict = "rejected";
  const std::vector<study::StrokeRecord> records = {practice,
                                                    bad,
                                                    taken_back,
                                                    rejection,
                                                    withSpeeds(5, "slow", 1, {2, 4}),
                                                    withSpeeds(6, "slow", 2, {4, 6}),
                                                    withSpeeds(7, "fast", 1, {7})};
  const auto speeds = speedStatistics(records);
  ASSERT_TRUE(speeds.has_value());
  const double root2 = std::sqrt(2.0);  // 2 and 4: squares 1 + 1 over n - 1 = 1
  ASSERT_EQ(speeds->strokes.size(), 3U);
  EXPECT_EQ(speeds->strokes[0], (SpeedStatistics{"slow", 1, 1, 2, 3, root2}));
  EXPECT_EQ(speeds->strokes[1], (SpeedStatistics{"slow", 2, 1, 2, 5, root2}));
  EXPECT_EQ(speeds->strokes[2], (SpeedStatistics{"fast", 1, 1, 1, 7, 0}));
  ASSERT_EQ(speeds->levels.size(), 2U);
  // 2 4 4 6: squares 4 0 0 4 over 3
  EXPECT_EQ(speeds->levels[0], (SpeedStatistics{"slow", 0, 2, 4, 4, std::sqrt(8.0 / 3.0)}));
  EXPECT_EQ(speeds->levels[1].strokes, 1U);
}

TEST(StrokeSpeeds, ComeFromPositionsWhereNoneWereRecorded) {
  study::StrokeRecord record;
  record.first = 100;
  record.last = 301;
  study::Channel depth{"depth", "mm", {}};
  for (int i = 0; i < 400; ++i) depth.values.push_back(0.05 * i);  // 50 mm/s at 1 kHz
  record.recording.channels = {depth};
  const auto speeds = strokeSpeeds(record);
  ASSERT_TRUE(speeds.has_value());
  EXPECT_EQ(speeds->size(), 201U);
  for (const double speed : *speeds) EXPECT_NEAR(speed, 50, 1e-9);
}

TEST(StrokeSpeeds, WhatHasNoSpeedsIsRefused) {
  auto outside = withSpeeds(1, "slow", 2, {1, 2, 3});
  outside.last = 4;
  EXPECT_EQ(strokeSpeeds(outside).error().message(),
            "slow, stroke 2: found a stroke outside its recording, wanted first < last within it");
  auto nothing = withSpeeds(1, "slow", 2, {1, 2, 3});
  nothing.recording.channels[0].name = "force";
  EXPECT_EQ(strokeSpeeds(nothing).error().message(), "slow, stroke 2: found no channel 'depth', wanted one");
}

}  // namespace
}  // namespace tactus::experiments
