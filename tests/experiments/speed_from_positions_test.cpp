#include "experiments/speed_from_positions.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "core/base/random.h"

namespace tactus::experiments {
namespace {

struct Recording {
  std::vector<double> time_s;
  std::vector<double> depth_mm;
};

template <class Depth>
Recording recorded(std::vector<double> time_s, Depth depth) {
  Recording out{std::move(time_s), {}};
  for (const double t : out.time_s) out.depth_mm.push_back(depth(t));
  return out;
}

/// `count` ticks of 1 ms from `start_s` on.
std::vector<double> ticks(int count, double start_s = 0) {
  std::vector<double> out;
  for (int i = 0; i < count; ++i) out.push_back(start_s + i / 1000.0);
  return out;
}

Motion motionOf(const Recording& recording) { return speedFromPositions(recording.time_s, recording.depth_mm).value(); }

constexpr double kQuantumMm = 0.055;
double quantized(double depth_mm) { return std::round(depth_mm / kQuantumMm) * kQuantumMm; }

TEST(SpeedFromPositions, IsExactOnParabolas) {
  // Up to both ends, from the shortest recording on; 1000 mm of depth cost no digits.
  for (const int count : {3, 4, 5, 17, 30, 31, 32, 33, 200}) {
    const auto motion =
        motionOf(recorded(ticks(count, 5), [](double t) { return 1000 + 80 * (t - 5) - 300 * (t - 5) * (t - 5); }));
    ASSERT_EQ(motion.samples.size(), static_cast<std::size_t>(count));
    EXPECT_TRUE(motion.gaps.empty());
    for (const auto& sample : motion.samples) {
      // Depths of 1000 mm are rounded by 6e-14 mm; three samples 1 ms apart give a slope with 2000 times that, more at
      // the edge.
      EXPECT_NEAR(sample.speed_mm_s, 80 - 600 * (sample.time_s - 5), 1e-9) << count << ' ' << sample.time_s;
    }
  }
}

TEST(SpeedFromPositions, HasNoDelay) {
  // A symmetric motion has a symmetric speed, and a cubic keeps its speed but for a constant: the fit of order 2 adds
  // c (3 * 15^2 + 3 * 15 - 1) / 5 * h^2 to the slope of c t^3, with h = 1 ms.
  const double c = 2000;
  const auto motion = motionOf(recorded(ticks(401, -0.2), [c](double t) { return c * t * t * t; }));
  const double constant = c * (3 * 225 + 45 - 1) / 5.0 * 1e-6;
  for (std::size_t i = 15; i + 15 < motion.samples.size(); ++i) {
    const double t = motion.samples[i].time_s;
    EXPECT_NEAR(motion.samples[i].speed_mm_s, 3 * c * t * t + constant, 1e-9);  // rounding as above
  }
}

TEST(SpeedFromPositions, KeepsSlowAndDampsFastOscillations) {
  // Gain on sin(w t): sum of 2 j sin(w j h) over sum of 2 j^2 w h; at 10 Hz 0.9099, at 50 Hz -0.0865 + ..., by hand
  // below.
  for (const double hz : {1.0, 10.0, 50.0, 200.0}) {
    const double w = 2 * std::numbers::pi * hz;
    double gain = 0;
    for (int j = 1; j <= 15; ++j) gain += 2 * j * std::sin(w * j * 0.001) / (2480 * w * 0.001);
    const auto motion = motionOf(recorded(ticks(1001), [w](double t) { return std::sin(w * t); }));
    for (std::size_t i = 15; i + 15 < motion.samples.size(); ++i) {
      EXPECT_NEAR(motion.samples[i].speed_mm_s, gain * w * std::cos(w * motion.samples[i].time_s), 1e-9);
    }
    if (hz == 10) {
      EXPECT_NEAR(gain, 0.91, 0.005);  // as the header says
    }
  }
}

TEST(SpeedFromPositions, NoiseGainIsThatOfTheory) {
  // White noise of s mm gives s / (h sqrt(sum of j^2)) = s * 1000 / sqrt(2480) mm/s in the middle of the recording.
  base::Random random(7);
  const double noise_mm = 0.02;
  const auto motion = motionOf(recorded(ticks(100001), [&](double t) { return 40 * t + noise_mm * random.normal(); }));
  double squares = 0;
  std::size_t count = 0;
  for (std::size_t i = 15; i + 15 < motion.samples.size(); ++i, ++count) {
    squares += (motion.samples[i].speed_mm_s - 40) * (motion.samples[i].speed_mm_s - 40);
  }
  const double theory = noise_mm * 1000 / std::sqrt(2480.0);
  // About 100,000 / 31 independent values: a standard error of 1.3 %, times four.
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(count)), theory, 0.05 * theory);
}

TEST(SpeedFromPositions, QuantizedPositionsMoveTheSpeedByAKnownBound) {
  // Half a quantum everywhere with the worst signs: 0.0275 sum of |j| / (h sum of j^2) = 0.0275 * 240 / 2.48 mm/s.
  const double bound = 0.0275 * 240 / 2.48;
  EXPECT_LT(bound, kRestSpeedMmS);
  for (const double speed : {0.0, 0.3, 5.0, 31.1, 256.7}) {
    const auto motion = motionOf(recorded(ticks(400), [speed](double t) { return quantized(0.02 + speed * t); }));
    double worst = 0;
    double squares = 0;
    for (std::size_t i = 15; i + 15 < motion.samples.size(); ++i) {
      worst = std::max(worst, std::abs(motion.samples[i].speed_mm_s - speed));
      squares += std::pow(motion.samples[i].speed_mm_s - speed, 2) / 370;
    }
    EXPECT_LE(worst, bound + 1e-9);
    // At the speeds of the study the steps fall irregularly within the window, which averages them: white noise of a
    // quantum by sqrt(12) would give 0.32 mm/s.
    if (speed > 30) {
      EXPECT_LT(std::sqrt(squares), 1.5 * 0.32) << speed;
    }
  }
}

TEST(SpeedFromPositions, TimeStampsMayBeIrregular) {
  // Ticks of 0.3 to 1.9 ms. A straight line is interpolated exactly.
  base::Random random(3);
  std::vector<double> times{100};
  while (times.size() < 500) times.push_back(times.back() + random.uniform(0.0003, 0.0019));
  const auto line = motionOf(recorded(times, [](double t) { return 7 + 120 * (t - 100); }));
  EXPECT_EQ(line.samples.size(), static_cast<std::size_t>((times.back() - 100) * 1000) + 1);
  for (std::size_t i = 0; i < line.samples.size(); ++i) {
    EXPECT_NEAR(line.samples[i].time_s, 100 + static_cast<double>(i) / 1000, 1e-12);
    EXPECT_NEAR(line.samples[i].depth_mm, 7 + 120 * (line.samples[i].time_s - 100), 1e-9);
    EXPECT_NEAR(line.samples[i].speed_mm_s, 120, 1e-6);  // times of 100 s are rounded by 1.4e-14 s, so depths by 2e-12
  }
  // Linear interpolation of a curve with acceleration a errs by at most a h^2 / 8 = 4.5e-4 mm for h = 1.9 ms and
  // a = 1000 mm/s^2; the bound of the test above per half quantum gives 0.044 mm/s.
  const auto curve = motionOf(recorded(times, [](double t) { return 500 * (t - 100) * (t - 100); }));
  for (const auto& sample : curve.samples) {
    EXPECT_NEAR(sample.speed_mm_s, 1000 * (sample.time_s - 100), 4 * 0.044);  // the edges err up to four times as much
  }
}

TEST(SpeedFromPositions, GapsAreNamed) {
  auto times = ticks(100);
  times.erase(times.begin() + 40, times.begin() + 49);  // 10 ms from tick 39 to tick 49: just allowed
  EXPECT_TRUE(motionOf(recorded(times, [](double t) { return t; })).gaps.empty());
  times = ticks(100);
  times.erase(times.begin() + 40, times.begin() + 60);
  const auto motion = motionOf(recorded(times, [](double t) { return 30 * t; }));
  EXPECT_EQ(motion.gaps, (std::vector<PositionGap>{{0.039, 0.060}}));
  ASSERT_EQ(motion.samples.size(), 100U);
  for (const auto& sample : motion.samples) EXPECT_NEAR(sample.speed_mm_s, 30, 1e-9);
}

TEST(SpeedFromPositions, BadPositionsAreRefusedWithTheirPlace) {
  const auto refused = [](std::vector<double> time_s, std::vector<double> depth_mm) {
    const auto found = speedFromPositions(time_s, depth_mm);
    return found ? "nothing" : found.error().message();
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refused({0, 0.001, 0.002}, {1, nan, 3}), "position 2, depth_mm: found nan, wanted a finite number");
  EXPECT_EQ(refused({0, 0.001, infinity}, {1, 2, 3}), "position 3, time_s: found inf, wanted a finite number");
  EXPECT_EQ(refused({0, 0.002, 0.002}, {1, 2, 3}),
            "position 3, time_s: found 0.002 s after 0.002 s, wanted times that rise");
  EXPECT_EQ(refused({0, 0.002}, {1, 2, 3}), "positions: found 3 depths, wanted 2, one for each time stamp");
  EXPECT_EQ(refused({}, {}), "positions: found none, wanted positions of a motion");
  EXPECT_EQ(refused({4}, {1}), "positions: found 0 s of motion, wanted at least 0.002 s");
  EXPECT_EQ(refused({0, 36001}, {1, 2}), "positions: found 36001 s, wanted at most 36000 s");
}

TEST(SpeedFromPositions, ForwardPartIsFromTheFirstToTheLastFastSample) {
  std::vector<MotionSample> samples;
  for (const double speed : {0.0, -20.0, 3.0, 3.5, 60.0, -1.0, 40.0, 3.1, 2.0, -8.0}) samples.push_back({0, 0, speed});
  const auto part = forwardPart(samples);
  ASSERT_EQ(part.size(), 5U);
  EXPECT_EQ(part.front().speed_mm_s, 3.5);
  EXPECT_EQ(part.back().speed_mm_s, 3.1);
  EXPECT_EQ(forwardPart(samples, 50).size(), 1U);
  EXPECT_TRUE(forwardPart(samples, 100).empty());
  EXPECT_TRUE(forwardPart({}).empty());
}

}  // namespace
}  // namespace tactus::experiments
