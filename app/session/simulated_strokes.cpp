#include "app/session/simulated_strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/check.h"
#include "core/base/random.h"
#include "core/base/statistics.h"

namespace tactus::session {
namespace {

constexpr int kStrokes = 4;               // paper, Section 3.1.4: "consecutively four times"
constexpr double kStrokeLengthMm = 60;    // within the reach of a desktop device; a longer one only lasts longer
constexpr double kRateHz = 1000;          // the servo's rate
constexpr double kBetweenStrokes = 0.35;  // variation between strokes as a share of all; the rest lies within strokes
constexpr double kWander = 0.03;          // amplitude of the wander as a share of the speed
constexpr double kWanderHz = 1.5;         // slow against a stroke, as a hand that is not a machine
constexpr double kRounding = 1000;        // per mm and per mm/s

/// A stroke before its ramps are known.
struct StrokePlan {
  int intervals = 0;         // of 1 / kRateHz
  std::vector<double> gain;  // 1 + wander, one per sample
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

/// Durations that together give the mean speed, and each stroke's own wander.
std::vector<StrokePlan> planStrokes(const experiments::PublishedSpeed& target, base::Random& random) {
  const double between = kBetweenStrokes * target.sd_mm_s / target.mean_mm_s;
  std::array<double, kStrokes> share{};
  const auto normals = standardisedNormals(random);
  std::transform(normals.begin(), normals.end(), share.begin(), [between](double z) { return 1 / (1 + between * z); });
  const double total = std::accumulate(share.begin(), share.end(), 0.0);
  const double all_samples = kStrokes * kStrokeLengthMm / target.mean_mm_s * kRateHz;

  std::vector<StrokePlan> plans;
  double shares_so_far = 0;
  int samples_so_far = 0;
  for (const double part : share) {
    shares_so_far += part;
    const int samples = static_cast<int>(std::lround(all_samples * shares_so_far / total)) - samples_so_far;
    samples_so_far += samples;
    StrokePlan plan;
    plan.intervals = samples - 1;
    const double phase = random.uniform(0, 2 * std::numbers::pi);
    for (int i = 0; i <= plan.intervals; ++i) {
      plan.gain.push_back(1 + kWander * std::sin(phase + 2 * std::numbers::pi * kWanderHz * i / kRateHz));
    }
    plans.push_back(std::move(plan));
  }
  return plans;
}

/// Minimum-jerk step from 0 to 1 for u in [0, 1] (Flash and Hogan 1985).
double step(double u) { return u * u * u * (10 + u * (-15 + 6 * u)); }

/// The speeds of all strokes with ramps of `ramp` of each duration, in (0, 0.5], scaled to the mean of `target`.
std::vector<std::vector<double>> speedsWith(double ramp, const std::vector<StrokePlan>& plans, double mean_mm_s) {
  std::vector<std::vector<double>> strokes;
  double sum = 0;
  std::size_t count = 0;
  for (const auto& plan : plans) {
    std::vector<double> speeds(plan.gain.size());
    double length_mm = 0;
    for (int i = 0; i <= plan.intervals; ++i) {
      const double nearest_end = static_cast<double>(std::min(i, plan.intervals - i)) / plan.intervals;
      const auto at = static_cast<std::size_t>(i);
      speeds[at] = plan.gain[at] * (nearest_end < ramp ? step(nearest_end / ramp) : 1);
      length_mm += speeds[at] / kRateHz;
    }
    for (double& speed : speeds) speed *= kStrokeLengthMm / length_mm;
    sum += kStrokeLengthMm * kRateHz;
    count += speeds.size();
    strokes.push_back(std::move(speeds));
  }
  // Whole milliseconds leave a small error in the mean.
  const double scale = mean_mm_s * static_cast<double>(count) / sum;
  for (auto& speeds : strokes) {
    for (double& speed : speeds) speed *= scale;
  }
  return strokes;
}

double deviationOf(const std::vector<std::vector<double>>& strokes) {
  std::vector<double> all;
  for (const auto& speeds : strokes) all.insert(all.end(), speeds.begin(), speeds.end());
  return base::standardDeviation(all);
}

/// The speeds whose standard deviation is the target's: longer ramps, larger deviation, so bisection finds it.
std::vector<std::vector<double>> matchedSpeeds(const experiments::PublishedSpeed& target, base::Random& random) {
  const auto plans = planStrokes(target, random);
  double low = 0.005;
  double high = 0.5;
  TACTUS_CHECK(deviationOf(speedsWith(low, plans, target.mean_mm_s)) < target.sd_mm_s);
  TACTUS_CHECK(deviationOf(speedsWith(high, plans, target.mean_mm_s)) > target.sd_mm_s);
  for (int round = 0; round < 30; ++round) {
    const double middle = (low + high) / 2;
    (deviationOf(speedsWith(middle, plans, target.mean_mm_s)) < target.sd_mm_s ? low : high) = middle;
  }
  return speedsWith(high, plans, target.mean_mm_s);
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
    for (const auto& speeds : matchedSpeeds(target, random)) {
      ++stroke;
      double depth_mm = 0;
      double last_mm_s = 0;
      for (std::size_t i = 0; i < speeds.size(); ++i) {
        depth_mm += (last_mm_s + speeds[i]) / 2 / kRateHz;
        last_mm_s = speeds[i];
        samples.push_back({target.participant, target.level, stroke, static_cast<double>(i) / kRateHz,
                           rounded(depth_mm), rounded(speeds[i])});
      }
    }
  }
  return samples;
}

}  // namespace tactus::session
