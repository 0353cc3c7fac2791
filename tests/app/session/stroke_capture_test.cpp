#include "app/session/stroke_capture.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "app/session/simulated_strokes.h"

namespace tactus::session {
namespace {

std::vector<experiments::PositionSample> samplesOf(const Recording& stream, double later_s = 0) {
  std::vector<experiments::PositionSample> samples;
  for (std::size_t i = 0; i < stream.time_s.size(); ++i) {
    samples.push_back({stream.time_s[i] + later_s, stream.depth_mm[i]});
  }
  return samples;
}

TEST(StrokeCapture, CutsEachStrokeOutOfTheStream) {
  const auto level = simulatedLevel({"S3", "medium", 106, 25}, 4);
  auto stream = samplesOf(level.strokes[0]);
  const auto second = samplesOf(level.strokes[1], stream.back().time_s + 0.001);
  stream.insert(stream.end(), second.begin(), second.end());
  const auto expected = experiments::findStrokes(stream);
  ASSERT_TRUE(expected);
  ASSERT_EQ(expected->size(), 2U);

  StrokeCapture capture;
  std::vector<CapturedStroke> found;
  for (const auto& sample : stream) {
    capture.add(sample);
    while (auto one = capture.take()) found.push_back(std::move(*one));
  }
  capture.finish();
  while (auto one = capture.take()) found.push_back(std::move(*one));

  ASSERT_EQ(found.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(found[i].stroke, (*expected)[i]);
    const auto& time = found[i].recording.channels[0].values;
    const auto& depth = found[i].recording.channels[1].values;
    ASSERT_EQ(time.size(), depth.size());
    const std::size_t first = found[i].recording_first;
    const double from_s = stream[first].time_s;
    for (std::size_t k = 0; k < time.size(); ++k) {
      EXPECT_EQ(time[k], stream[first + k].time_s - from_s);
      EXPECT_EQ(depth[k], stream[first + k].position_mm);
    }
    // One sample in a thousand is lost, so the ends are met to a few milliseconds.
    EXPECT_NEAR(from_s, found[i].stroke.start_s - StrokeCapture::kAroundS, 0.005);
    EXPECT_NEAR(from_s + time.back(), found[i].stroke.end_s + StrokeCapture::kAroundS, 0.005);
    EXPECT_NEAR(found[i].recording.sample_rate_hz, 1000, 10);
  }
}

TEST(StrokeCapture, AGapInterruptsTheStrokeAndEndsItsRecording) {
  const auto level = simulatedLevel({"S3", "medium", 106, 25}, 4);
  const auto stream = samplesOf(level.strokes[0]);
  const auto whole = experiments::findStrokes(stream);
  ASSERT_TRUE(whole && whole->size() == 1U);
  const std::size_t middle = (whole->front().first + whole->front().last) / 2;
  // Twenty samples are lost: too few for the times to tell, so the device that lost them says it.
  StrokeCapture capture;
  std::vector<CapturedStroke> found;
  std::size_t taken = 0;
  for (std::size_t i = 0; i < stream.size(); ++i) {
    if (i >= middle && i < middle + 20) continue;
    if (i == middle + 20) capture.gap();
    capture.add(stream[i]);
    taken += i < middle ? 1 : 0;
  }
  capture.finish();
  while (auto one = capture.take()) found.push_back(std::move(*one));
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].stroke.verdict, experiments::StrokeVerdict::kInterrupted);
  for (const auto& one : found) {
    const std::size_t end = one.recording_first + one.recording.size();
    EXPECT_TRUE(end <= taken || one.recording_first >= taken) << "no recording holds both sides of the gap";
  }
}

TEST(StrokeCapture, NoRecordingSpansATimeWithoutSamples) {
  const auto level = simulatedLevel({"S3", "medium", 106, 25}, 4);
  auto stream = samplesOf(level.strokes[0]);
  // The second stroke follows 0.06 s after the first one's stream was cut off 0.1 s behind the stroke.
  const auto strokes = experiments::findStrokes(stream);
  ASSERT_TRUE(strokes);
  while (stream.back().time_s > strokes->front().end_s + 0.1) stream.pop_back();
  const std::size_t first_part = stream.size();
  const auto second = samplesOf(level.strokes[1], stream.back().time_s + 0.06);
  stream.insert(stream.end(), second.begin(), second.end());
  StrokeCapture capture;
  for (const auto& sample : stream) capture.add(sample);
  capture.finish();
  int count = 0;
  while (const auto one = capture.take()) {
    const std::size_t end = one->recording_first + one->recording.size();
    EXPECT_TRUE(end <= first_part || one->recording_first >= first_part);
    ++count;
  }
  EXPECT_EQ(count, 2);
}

TEST(StrokeCapture, ASampleThatIsNoneChangesNothing) {
  const auto level = simulatedLevel({"S3", "medium", 106, 25}, 4);
  const auto stream = samplesOf(level.strokes[0]);
  const auto strokeOf = [&](bool with_others) {
    StrokeCapture capture;
    for (const auto& sample : stream) {
      capture.add(sample);
      if (!with_others) continue;
      capture.add(sample);
      capture.add({sample.time_s + 0.0001, std::numeric_limits<double>::quiet_NaN()});
    }
    capture.finish();
    return capture.take();
  };
  const auto plain = strokeOf(false);
  const auto disturbed = strokeOf(true);
  ASSERT_TRUE(plain && disturbed);
  EXPECT_EQ(plain->stroke, disturbed->stroke);
  EXPECT_EQ(plain->recording, disturbed->recording);
  EXPECT_EQ(plain->recording_first, disturbed->recording_first);
}

}  // namespace
}  // namespace tactus::session
