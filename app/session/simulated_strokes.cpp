#include "app/session/simulated_strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "app/session/stroke_capture.h"
#include "core/base/check.h"
#include "core/base/random.h"
#include "core/base/statistics.h"
#include "experiments/speed_from_positions.h"
#include "experiments/stroke_speeds.h"

namespace tactus::session {
namespace {

constexpr double kQuantumMm = 0.055;  // 450 counts per inch, as a Touch
constexpr double kMissedShare = 0.001;

}  // namespace

RecordingNoise RecordingNoise::of(std::size_t ticks, base::Random& random) {
  RecordingNoise noise;
  const double hz = random.uniform(8, 12);
  const double phase = random.uniform(0, 2 * std::numbers::pi);
  for (std::size_t i = 0; i < ticks; ++i) {
    noise.tremor_mm.push_back(kTremorMm *
                              std::sin(phase + 2 * std::numbers::pi * hz * static_cast<double>(i) / kSimulatedRateHz));
  }
  noise.missed.resize(ticks);
  for (std::size_t i = 1; i + 1 < ticks; ++i) noise.missed[i] = random.uniform() < kMissedShare;
  return noise;
}

Recording record(std::span<const double> speeds_mm_s, const RecordingNoise& noise, double offset) {
  TACTUS_CHECK(noise.missed.size() == speeds_mm_s.size());
  const double fastest = *std::max_element(speeds_mm_s.begin(), speeds_mm_s.end());
  Recording out;
  double depth_mm = offset * kQuantumMm;
  double last_mm_s = 0;
  for (std::size_t i = 0; i < speeds_mm_s.size(); ++i) {
    depth_mm += (last_mm_s + speeds_mm_s[i]) / 2 / kSimulatedRateHz;
    last_mm_s = speeds_mm_s[i];
    if (noise.missed[i]) continue;
    const double tremor_mm = noise.tremor_mm[i] * speeds_mm_s[i] / fastest;
    out.time_s.push_back(static_cast<double>(i) / kSimulatedRateHz);
    out.depth_mm.push_back(std::round((depth_mm + tremor_mm) / kQuantumMm) * kQuantumMm);
  }
  return out;
}

namespace {

constexpr std::size_t kStrokes = 4;       // paper, Section 3.1.4: "consecutively four times"
constexpr double kStrokeLengthMm = 60;    // within the reach of a desktop device; a longer one only lasts longer
constexpr double kBetweenStrokes = 0.35;  // variation between strokes as a share of all; the rest lies within strokes
constexpr double kWander = 0.03;          // amplitude of the wander as a share of the speed
constexpr double kWanderHz = 1.5;         // slow against a stroke, as a hand that is not a machine
constexpr double kMatchMmS = 0.04;        // largest miss of mean and deviation
constexpr int kMostDraws = 50;            // of strokes for one level; most take one
constexpr double kRestS = 0.4;            // before a stroke, and the pause after it
constexpr double kReturnS = 0.6;          // of the way back
constexpr double kShortMm = 18;           // less than half of what counts as a stroke

/// What the hand does in one stroke, apart from its ramps.
struct StrokePlan {
  std::vector<double> gain;  // per tick of the stroke: 1 + wander
  RecordingNoise noise;      // per tick of the whole stream
};

/// Four numbers with mean 0 and standard deviation 1.
std::array<double, kStrokes> standardizedNormals(base::Random& random) {
  std::array<double, kStrokes> values{};
  std::generate(values.begin(), values.end(), [&random] { return random.normal(); });
  const double mean = base::mean(values);
  const double sd = base::standardDeviation(values);
  for (double& value : values) value = (value - mean) / sd;
  return values;
}

constexpr double kShortestRamp = 0.005;
constexpr double kLongestRamp = 0.5;

/// Minimum-jerk step from 0 to 1 for u in [0, 1] (Flash and Hogan 1985).
double step(double u) { return u * u * u * (10 + u * (-15 + 6 * u)); }

constexpr std::size_t ticks(double seconds) { return static_cast<std::size_t>(seconds * kSimulatedRateHz + 0.5); }
constexpr std::size_t kTicksAround = 3 * ticks(kRestS) + ticks(kReturnS);

StrokePlan planStroke(std::size_t stroke_ticks, base::Random& random) {
  StrokePlan plan;
  const double phase = random.uniform(0, 2 * std::numbers::pi);
  plan.gain.resize(stroke_ticks);
  for (std::size_t i = 0; i < stroke_ticks; ++i) {
    plan.gain[i] =
        1 + kWander * std::sin(phase + 2 * std::numbers::pi * kWanderHz * static_cast<double>(i) / kSimulatedRateHz);
  }
  plan.noise = RecordingNoise::of(stroke_ticks + kTicksAround, random);
  return plan;
}

/// Strokes that differ in their durations, which sum to `all_s`.
std::vector<StrokePlan> planStrokes(const experiments::PublishedSpeed& target, double all_s, base::Random& random) {
  const double between = kBetweenStrokes * target.sd_mm_s / target.mean_mm_s;
  std::array<double, kStrokes> share{};
  const auto normals = standardizedNormals(random);
  std::transform(normals.begin(), normals.end(), share.begin(), [between](double z) { return 1 / (1 + between * z); });
  const double total = std::accumulate(share.begin(), share.end(), 0.0);
  std::vector<StrokePlan> plans;
  for (const double part : share) plans.push_back(planStroke(ticks(all_s * part / total), random));
  return plans;
}

/// What sets mean and deviation of a level's speeds.
struct StrokeShape {
  double ramp = 0.1;                   // each ramp's share of the duration, (0, 0.5]
  double length_mm = kStrokeLengthMm;  // of each stroke
};

/// Tick by tick, without what comes before and after.
std::vector<double> strokeSpeeds(const std::vector<double>& gain, const StrokeShape& shape) {
  const std::size_t intervals = gain.size() - 1;
  std::vector<double> speeds(gain.size());
  double unscaled_mm = 0;
  for (std::size_t i = 0; i <= intervals; ++i) {
    const double nearest_end = static_cast<double>(std::min(i, intervals - i)) / static_cast<double>(intervals);
    speeds[i] = gain[i] * (nearest_end < shape.ramp ? step(nearest_end / shape.ramp) : 1);
    unscaled_mm += speeds[i] / kSimulatedRateHz;
  }
  for (double& speed : speeds) speed *= shape.length_mm / unscaled_mm;
  return speeds;
}

/// Rest, stroke, pause, the way back in minimum-jerk position, rest.
std::vector<double> handSpeeds(const std::vector<double>& gain, const StrokeShape& shape) {
  const auto stroke = strokeSpeeds(gain, shape);
  std::vector<double> speeds(ticks(kRestS));
  speeds.insert(speeds.end(), stroke.begin(), stroke.end());
  speeds.resize(speeds.size() + ticks(kRestS));
  for (std::size_t i = 0; i < ticks(kReturnS); ++i) {
    const double u = static_cast<double>(i) / (kReturnS * kSimulatedRateHz);
    speeds.push_back(-30 * u * u * (1 - u) * (1 - u) * shape.length_mm / kReturnS);
  }
  speeds.resize(speeds.size() + ticks(kRestS));
  return speeds;
}

Recording streamOf(const StrokePlan& plan, const StrokeShape& shape, double offset) {
  return record(handSpeeds(plan.gain, shape), plan.noise, offset);
}

/// Sums for mean and deviation, of speed - target mean so that they keep their digits.
struct Sums {
  double count = 0;
  double sum_mm_s = 0;
  double squares = 0;

  void add(double above_mean_mm_s) {
    ++count;
    sum_mm_s += above_mean_mm_s;
    squares += above_mean_mm_s * above_mean_mm_s;
  }
  void add(const Sums& other) {
    count += other.count;
    sum_mm_s += other.sum_mm_s;
    squares += other.squares;
  }
  double meanAbove() const { return sum_mm_s / count; }
  double sd() const { return std::sqrt((squares - sum_mm_s * sum_mm_s / count) / (count - 1)); }
  /// How far mean and deviation are from the target's.
  double miss(const experiments::PublishedSpeed& target) const {
    return std::max(std::abs(meanAbove()), std::abs(sd() - target.sd_mm_s));
  }
};

/// A stroke as a session would measure it.
struct Measured {
  Recording stream;
  Sums sums;
};

/// Finds the stroke in its stream and computes its speeds on the way of a recorded one; nothing where there is not just
/// one accepted stroke.
std::optional<Measured> measured(Recording stream, double target_mm_s) {
  StrokeCapture capture;
  for (std::size_t i = 0; i < stream.time_s.size(); ++i) capture.add({stream.time_s[i], stream.depth_mm[i]});
  capture.finish();
  auto found = capture.take();
  if (!found || capture.take() || found->stroke.verdict != experiments::StrokeVerdict::kAccepted) return std::nullopt;
  study::StrokeRecord record;
  record.first = found->stroke.first - found->recording_first;
  record.last = found->stroke.last - found->recording_first;
  record.recording = std::move(found->recording);
  const auto speeds = experiments::strokeSpeeds(record);
  if (!speeds) return std::nullopt;
  Measured out{std::move(stream), {}};
  for (const double speed : *speeds) out.sums.add(speed - target_mm_s);
  return out;
}

/// What a device without steps, tremor and losses would measure of all strokes.
Sums idealSums(const std::vector<StrokePlan>& plans, const StrokeShape& shape, double target_mm_s) {
  Sums sums;
  for (const auto& plan : plans) {
    for (const double speed : strokeSpeeds(plan.gain, shape)) {
      if (speed >= experiments::StrokeSettings{}.edge_speed_mm_s) sums.add(speed - target_mm_s);
    }
  }
  return sums;
}

/// The shape whose ideal sums have this mean and deviation: the length sets the mean, longer ramps raise the deviation.
StrokeShape idealShape(const experiments::PublishedSpeed& target, const std::vector<StrokePlan>& plans) {
  StrokeShape shape;
  double low = kShortestRamp;
  double high = kLongestRamp;
  for (int round = 0; round < 16; ++round) {
    shape.ramp = (low + high) / 2;
    Sums sums;
    for (int inner = 0; inner < 4; ++inner) {
      sums = idealSums(plans, shape, target.mean_mm_s);
      shape.length_mm *= target.mean_mm_s / (target.mean_mm_s + sums.meanAbove());
    }
    (sums.sd() < target.sd_mm_s ? low : high) = shape.ramp;
  }
  return shape;
}

/// The shape whose recorded strokes come near the target: an ideal one that aims beside it by what recording changes.
/// Nothing where a recorded stroke is not accepted.
std::optional<StrokeShape> shapeFor(const experiments::PublishedSpeed& target, const std::vector<StrokePlan>& plans) {
  experiments::PublishedSpeed aim = target;
  for (int round = 0; round < 2; ++round) {
    const StrokeShape shape = idealShape(aim, plans);
    Sums sums;
    for (const auto& plan : plans) {
      const auto stroke = measured(streamOf(plan, shape, 0), target.mean_mm_s);
      if (!stroke) return std::nullopt;
      sums.add(stroke->sums);
    }
    aim.mean_mm_s -= sums.meanAbove();
    aim.sd_mm_s -= sums.sd() - target.sd_mm_s;
  }
  return idealShape(aim, plans);
}

/// Each stroke is recorded from one place after another between two steps of the device, until a combination of their
/// recordings is near enough to the target. Empty where none is.
std::vector<Recording> matchedStrokes(const experiments::PublishedSpeed& target, const std::vector<StrokePlan>& plans) {
  constexpr std::size_t kPlaces = 8;
  const auto shape = shapeFor(target, plans);
  if (!shape) return {};
  std::array<std::vector<Measured>, kStrokes> choices;
  for (std::size_t place = 0; place < kPlaces; ++place) {
    for (std::size_t stroke = 0; stroke < kStrokes; ++stroke) {
      const double offset = static_cast<double>(place) / kPlaces;
      auto one = measured(streamOf(plans[stroke], *shape, offset), target.mean_mm_s);
      if (!one) return {};
      choices[stroke].push_back(std::move(*one));
    }
    const std::size_t count = place + 1;
    for (std::size_t combination = 0; combination < count * count * count * count; ++combination) {
      std::array<std::size_t, kStrokes> chosen{};
      Sums sums;
      std::size_t rest = combination;
      for (std::size_t stroke = 0; stroke < kStrokes; ++stroke, rest /= count) {
        chosen[stroke] = rest % count;
        sums.add(choices[stroke][chosen[stroke]].sums);
      }
      if (sums.miss(target) > kMatchMmS) continue;
      std::vector<Recording> out;
      for (std::size_t stroke = 0; stroke < kStrokes; ++stroke) {
        out.push_back(std::move(choices[stroke][chosen[stroke]].stream));
      }
      return out;
    }
  }
  return {};
}

}  // namespace

SimulatedLevel simulatedLevel(const experiments::PublishedSpeed& target, std::uint64_t seed) {
  base::Random random(seed);
  double all_s = kStrokes * kStrokeLengthMm / target.mean_mm_s;
  SimulatedLevel level;
  for (int draw = 0; draw < kMostDraws && level.strokes.empty(); ++draw) {
    // The speeds are given, so a stroke of another length takes another time.
    auto same_random = random;
    all_s *= kStrokeLengthMm / idealShape(target, planStrokes(target, all_s, same_random)).length_mm;
    level.strokes = matchedStrokes(target, planStrokes(target, all_s, random));
  }
  TACTUS_CHECK(!level.strokes.empty());
  const auto others = planStrokes(target, all_s, random);
  const auto shape = idealShape(target, others);
  level.practice = {streamOf(others[0], shape, 0), streamOf(others[1], shape, 0.5)};
  const auto part = planStroke(ticks(all_s / kStrokes * kShortMm / kStrokeLengthMm), random);
  level.too_short = streamOf(part, {shape.ramp, kShortMm}, 0);
  return level;
}

}  // namespace tactus::session
