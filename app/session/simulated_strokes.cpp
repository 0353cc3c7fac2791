#include "app/session/simulated_strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "app/session/simulated_recording.h"
#include "core/base/check.h"
#include "core/base/random.h"
#include "core/base/statistics.h"
#include "experiments/speed_from_positions.h"

namespace tactus::session {
namespace {

using experiments::MotionSample;

constexpr std::size_t kStrokes = 4;       // paper, Section 3.1.4: "consecutively four times"
constexpr double kStrokeLengthMm = 60;    // within the reach of a desktop device; a longer one only lasts longer
constexpr double kRateHz = 1000;          // the servo's rate
constexpr double kBetweenStrokes = 0.35;  // variation between strokes as a share of all; the rest lies within strokes
constexpr double kWander = 0.03;          // amplitude of the wander as a share of the speed
constexpr double kWanderHz = 1.5;         // slow against a stroke, as a hand that is not a machine
constexpr double kRounding = 1000;        // per s, mm and mm/s
constexpr double kMatchMmS = 0.009;       // largest miss of mean and deviation, before speeds are rounded
constexpr int kMostDraws = 200;           // of strokes for one cell; most cells take one or two

/// What the hand does in the strokes of one cell, apart from their ramps.
struct CellPlan {
  std::vector<std::vector<double>> gain;  // per stroke and tick: 1 + wander
  std::vector<RecordingNoise> noise;
};

/// Four numbers with mean 0 and standard deviation 1.
std::array<double, kStrokes> standardisedNormals(base::Random& random) {
  std::array<double, kStrokes> values{};
  std::generate(values.begin(), values.end(), [&random] { return random.normal(); });
  const double mean = base::mean(values);
  const double sd = base::standardDeviation(values);
  for (double& value : values) value = (value - mean) / sd;
  return values;
}

// Squared coefficient of variation of a stroke with minimum-jerk ramps of a share r each: (kRamps r - r^2) / (1 - r)^2.
// kRamps is twice the integral of the squared ramp.
constexpr double kRamps = 0.78355;
double squaredVariation(double r) { return (kRamps * r - r * r) / ((1 - r) * (1 - r)); }
double squaredVariationSlope(double r) { return (kRamps + kRamps * r - 2 * r) / ((1 - r) * (1 - r) * (1 - r)); }

constexpr double kShortestRamp = 0.005;
constexpr double kLongestRamp = 0.5;

/// Minimum-jerk step from 0 to 1 for u in [0, 1] (Flash and Hogan 1985).
double step(double u) { return u * u * u * (10 + u * (-15 + 6 * u)); }

/// The ramps of a hand without wander and tremor.
double firstRamp(const experiments::PublishedSpeed& target) {
  const double variation = target.sd_mm_s / target.mean_mm_s;
  const double within = variation * variation * (1 - kBetweenStrokes * kBetweenStrokes);
  double low = kShortestRamp;
  double high = kLongestRamp;
  for (int round = 0; round < 30; ++round) {
    const double middle = (low + high) / 2;
    (squaredVariation(middle) < within ? low : high) = middle;
  }
  return low;
}

/// How much longer a recording with ramps of `ramp` lasts than its forward part.
double lengthening(const experiments::PublishedSpeed& target, double ramp) {
  const double plateau_mm_s = target.mean_mm_s / (1 - ramp);
  double low = 0;
  double high = 1;
  for (int round = 0; round < 30; ++round) {
    const double middle = (low + high) / 2;
    (step(middle) * plateau_mm_s < experiments::kRestSpeedMmS ? low : high) = middle;
  }
  return 1 / (1 - 2 * ramp * low);
}

/// Durations that together give the mean speed of forward parts with ramps of about `ramp`.
CellPlan planCell(const experiments::PublishedSpeed& target, double ramp, base::Random& random) {
  const double between = kBetweenStrokes * target.sd_mm_s / target.mean_mm_s;
  std::array<double, kStrokes> share{};
  const auto normals = standardisedNormals(random);
  std::transform(normals.begin(), normals.end(), share.begin(), [between](double z) { return 1 / (1 + between * z); });
  const double total = std::accumulate(share.begin(), share.end(), 0.0);
  const double all_ticks = kStrokes * kStrokeLengthMm / target.mean_mm_s * kRateHz * lengthening(target, ramp);

  CellPlan plan;
  double shares_so_far = 0;
  std::size_t ticks_so_far = 0;
  for (const double part : share) {
    shares_so_far += part;
    const auto ticks = static_cast<std::size_t>(std::lround(all_ticks * shares_so_far / total)) - ticks_so_far;
    ticks_so_far += ticks;
    const double phase = random.uniform(0, 2 * std::numbers::pi);
    std::vector<double> gain(ticks);
    for (std::size_t i = 0; i < ticks; ++i) {
      gain[i] = 1 + kWander * std::sin(phase + 2 * std::numbers::pi * kWanderHz * static_cast<double>(i) / kRateHz);
    }
    plan.gain.push_back(std::move(gain));
    plan.noise.push_back(RecordingNoise::of(ticks, random));
  }
  return plan;
}

/// What sets mean and deviation of a cell's speeds.
struct StrokeShape {
  double ramp = 0.1;                   // each ramp's share of the duration, (0, 0.5]
  double length_mm = kStrokeLengthMm;  // of each stroke
};

std::vector<double> handSpeeds(const std::vector<double>& gain, const StrokeShape& shape) {
  const std::size_t intervals = gain.size() - 1;
  std::vector<double> speeds(gain.size());
  double unscaled_mm = 0;
  for (std::size_t i = 0; i <= intervals; ++i) {
    const double nearest_end = static_cast<double>(std::min(i, intervals - i)) / static_cast<double>(intervals);
    speeds[i] = gain[i] * (nearest_end < shape.ramp ? step(nearest_end / shape.ramp) : 1);
    unscaled_mm += speeds[i] / kRateHz;
  }
  for (double& speed : speeds) speed *= shape.length_mm / unscaled_mm;
  return speeds;
}

/// The forward part of one stroke, and its sums for mean and deviation.
struct Forward {
  std::vector<MotionSample> samples;
  double sum_mm_s = 0;  // of speed - target mean
  double squares = 0;   // of the same
};

/// Moves, records with the device's steps shifted by `offset` of a step, and computes the speeds from the positions.
Forward recordStroke(const CellPlan& plan, std::size_t stroke, const StrokeShape& shape, double offset,
                     double target_mm_s) {
  const Recording recording = record(handSpeeds(plan.gain[stroke], shape), plan.noise[stroke], offset);
  const auto motion = experiments::speedFromPositions(recording.time_s, recording.depth_mm);
  TACTUS_CHECK(motion.has_value());
  const auto part = experiments::forwardPart(motion->samples);
  TACTUS_CHECK(!part.empty());
  Forward out{{part.begin(), part.end()}};
  for (const MotionSample& sample : part) {
    out.sum_mm_s += sample.speed_mm_s - target_mm_s;
    out.squares += (sample.speed_mm_s - target_mm_s) * (sample.speed_mm_s - target_mm_s);
  }
  return out;
}

/// Mean and deviation of all samples of strokes that are added one by one.
struct CellSums {
  double target_mm_s = 0;
  double count = 0;
  double sum_mm_s = 0;
  double squares = 0;

  void add(const Forward& stroke) {
    count += static_cast<double>(stroke.samples.size());
    sum_mm_s += stroke.sum_mm_s;
    squares += stroke.squares;
  }
  double mean() const { return target_mm_s + sum_mm_s / count; }
  double sd() const { return std::sqrt((squares - sum_mm_s * sum_mm_s / count) / (count - 1)); }
};

/// Ramps and length that bring mean and deviation near the target's: longer ramps raise the deviation, the length
/// brings the mean along. Nearer than a few hundredths of a mm/s this cannot come, because the least change of a
/// stroke moves the steps of the positions, and with them the ends of the forward part.
StrokeShape shapeFor(const experiments::PublishedSpeed& target, const CellPlan& plan, double ramp) {
  StrokeShape shape{.ramp = ramp};
  for (int round = 0; round < 5; ++round) {
    CellSums sums{.target_mm_s = target.mean_mm_s};
    for (std::size_t stroke = 0; stroke < kStrokes; ++stroke) {
      sums.add(recordStroke(plan, stroke, shape, 0, target.mean_mm_s));
    }
    const double factor = target.mean_mm_s / sums.mean();
    const double slope = target.mean_mm_s * target.mean_mm_s * squaredVariationSlope(shape.ramp) / (2 * target.sd_mm_s);
    shape.length_mm *= factor;
    shape.ramp = std::clamp(shape.ramp + (target.sd_mm_s - sums.sd() * factor) / slope, kShortestRamp, kLongestRamp);
  }
  return shape;
}

/// Each stroke is recorded from several places between two steps of the device; of all combinations the one that comes
/// nearest to the target, if that is near enough.
std::vector<Forward> matchedStrokes(const experiments::PublishedSpeed& target, const CellPlan& plan, double ramp) {
  constexpr std::size_t kPlaces = 8;
  const StrokeShape shape = shapeFor(target, plan, ramp);
  std::array<std::vector<Forward>, kStrokes> choices;
  for (std::size_t stroke = 0; stroke < kStrokes; ++stroke) {
    for (std::size_t place = 0; place < kPlaces; ++place) {
      const double offset = static_cast<double>(place) / kPlaces;
      choices[stroke].push_back(recordStroke(plan, stroke, shape, offset, target.mean_mm_s));
    }
  }
  std::array<std::size_t, kStrokes> best{};
  double least = kMatchMmS;
  for (std::size_t combination = 0; combination < kPlaces * kPlaces * kPlaces * kPlaces; ++combination) {
    std::array<std::size_t, kStrokes> chosen{};
    CellSums sums{.target_mm_s = target.mean_mm_s};
    std::size_t rest = combination;
    for (std::size_t stroke = 0; stroke < kStrokes; ++stroke, rest /= kPlaces) {
      chosen[stroke] = rest % kPlaces;
      sums.add(choices[stroke][chosen[stroke]]);
    }
    const double miss = std::max(std::abs(sums.mean() - target.mean_mm_s), std::abs(sums.sd() - target.sd_mm_s));
    if (miss >= least) continue;
    least = miss;
    best = chosen;
  }
  std::vector<Forward> out;
  if (least == kMatchMmS) return out;
  for (std::size_t stroke = 0; stroke < kStrokes; ++stroke) {
    out.push_back(std::move(choices[stroke][best[stroke]]));
  }
  return out;
}

std::vector<Forward> strokesOf(const experiments::PublishedSpeed& target, base::Random& random) {
  const double ramp = firstRamp(target);
  for (int draw = 0; draw < kMostDraws; ++draw) {
    auto strokes = matchedStrokes(target, planCell(target, ramp, random), ramp);
    if (!strokes.empty()) return strokes;
  }
  TACTUS_CHECK(false);
  return {};
}

double rounded(double value) { return std::round(value * kRounding) / kRounding; }

}  // namespace

std::vector<study::SpeedSample> simulatedStrokes(std::span<const experiments::PublishedSpeed> targets,
                                                 std::uint64_t seed) {
  std::vector<study::SpeedSample> samples;
  for (std::size_t cell = 0; cell < targets.size(); ++cell) {
    const auto& target = targets[cell];
    base::Random random(seed * 1000 + cell);
    int stroke = 0;
    for (const auto& forward : strokesOf(target, random)) {
      ++stroke;
      const double start_s = forward.samples.front().time_s;
      for (const MotionSample& sample : forward.samples) {
        samples.push_back({target.participant, target.level, stroke, rounded(sample.time_s - start_s),
                           rounded(sample.depth_mm), rounded(sample.speed_mm_s)});
      }
    }
  }
  return samples;
}

}  // namespace tactus::session
