#include "tests/experiments/simulated_stream.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/base/random.h"

namespace tactus::experiments {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kFineS = 0.0001;
constexpr double kLongestTruePauseS = 0.2;  // well under StrokeSettings::longest_pause_s: no stream is ambiguous

double minimumJerk(double u) { return u * u * u * (10 + u * (-15 + 6 * u)); }
double raisedCosine(double u) { return (1 - std::cos(kPi * u)) / 2; }
double straight(double u) { return u; }

/// Commanded speeds in steps of kFineS.
class Command {
 public:
  void rest(double seconds) { speeds_.insert(speeds_.end(), count(seconds), 0.0); }

  /// A movement of `way_mm` with ramps of `ramp` of its duration at both ends; ramp 0.5 has no plateau.
  void move(double way_mm, double duration_s, double ramp, double (*shape)(double)) {
    const std::size_t steps = count(duration_s);
    std::vector<double> speeds(steps);
    double sum = 0;
    for (std::size_t i = 0; i < steps; ++i) {
      const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(steps);
      const double end = std::min(u, 1 - u) / ramp;
      speeds[i] = end < 1 ? shape(end) : 1;
      sum += speeds[i] * kFineS;
    }
    for (const double speed : speeds) speeds_.push_back(speed * way_mm / sum);
  }

  std::size_t size() const { return speeds_.size(); }
  double at(std::size_t i) const { return speeds_[i]; }

  void append(const Command& other) { speeds_.insert(speeds_.end(), other.speeds_.begin(), other.speeds_.end()); }

  /// The longest time under kTrueEdgeMmS between two moments above it.
  double longestSlowS() const {
    std::size_t longest = 0;
    std::size_t last = speeds_.size();
    for (std::size_t i = 0; i < speeds_.size(); ++i) {
      if (speeds_[i] < kTrueEdgeMmS) continue;
      if (last < i) longest = std::max(longest, i - last);
      last = i;
    }
    return static_cast<double>(longest) * kFineS;
  }

  TrueStroke truthBetween(std::size_t from, std::size_t to) const {
    while (speeds_[from] < kTrueEdgeMmS) ++from;
    while (speeds_[to - 1] < kTrueEdgeMmS) --to;
    TrueStroke truth{static_cast<double>(from) * kFineS, static_cast<double>(to) * kFineS, 0};
    for (std::size_t i = from; i < to; ++i) truth.length_mm += speeds_[i] * kFineS;
    return truth;
  }

 private:
  static std::size_t count(double seconds) { return static_cast<std::size_t>(std::lround(seconds / kFineS)); }

  std::vector<double> speeds_;
};

/// One stroke; sometimes in two parts with a short stop or a small step back between them.
void addStroke(Command& command, double length_mm, double mean_mm_s, base::Random& random) {
  constexpr double (*kShapes[])(double) = {minimumJerk, raisedCosine, straight};
  const auto shape = kShapes[random.below(3)];
  const double duration_s = length_mm / mean_mm_s;
  const double ramp = random.below(5) == 0 ? 0.5 : random.uniform(0.05, 0.3);
  const int kind = random.below(6);
  if (kind > 1) {
    command.move(length_mm, duration_s, ramp, shape);
    return;
  }
  Command parts;
  do {
    parts = {};
    const double part = random.uniform(0.4, 0.6);
    const double inner_ramp = random.uniform(0.05, ramp);
    parts.move(part * length_mm, part * duration_s, inner_ramp, shape);
    if (kind == 0) {
      parts.rest(random.uniform(0.02, 0.12));
    } else {
      parts.move(-random.uniform(0.3, 1.5), random.uniform(0.05, 0.1), 0.5, minimumJerk);
    }
    parts.move((1 - part) * length_mm, (1 - part) * duration_s, inner_ramp, shape);
  } while (parts.longestSlowS() > kLongestTruePauseS);
  command.append(parts);
}

}  // namespace

SimulatedStream simulatedStream(std::uint64_t seed, const StreamRecipe& recipe) {
  base::Random random(seed);
  Command command;
  SimulatedStream stream;
  command.rest(random.uniform(0.4, 1));
  const int strokes = 3 + random.below(3);
  for (int stroke = 0; stroke < strokes; ++stroke) {
    const double length_mm = random.uniform(40, 80);
    const double mean_mm_s =
        recipe.slowest_mm_s * std::pow(recipe.fastest_mm_s / recipe.slowest_mm_s, random.uniform());
    const std::size_t from = command.size();
    addStroke(command, length_mm, mean_mm_s, random);
    stream.strokes.push_back(command.truthBetween(from, command.size()));
    if (random.below(4) != 0) command.rest(random.uniform(0.1, 0.8));
    command.move(-length_mm, length_mm / random.uniform(50, 250), random.uniform(0.15, 0.5), minimumJerk);
    command.rest(random.uniform(0.1, 0.8));
  }
  command.rest(0.5);

  const double tremor_hz = random.uniform(8, 12);
  const double tremor_mm = random.uniform(recipe.tremor_least_mm, recipe.tremor_most_mm);
  const double phase = random.uniform(0, 2 * kPi);
  const double wobble_hz = random.uniform(0.2, 0.6);
  const auto trembling = [&](double time_s) {
    const double amplitude = tremor_mm * (1 + recipe.wobble * std::sin(2 * kPi * wobble_hz * time_s));
    return amplitude * std::sin(2 * kPi * tremor_hz * time_s + phase);
  };
  double position_mm = random.uniform(-20, 20);
  double next_s = 0;
  for (std::size_t i = 0; i < command.size(); ++i) {
    const double time_s = static_cast<double>(i) * kFineS;
    if (time_s >= next_s - kFineS / 2) {
      double measured = position_mm + trembling(time_s) + recipe.noise_mm * random.normal();
      if (recipe.count_mm > 0) measured = recipe.count_mm * std::round(measured / recipe.count_mm);
      stream.samples.push_back({time_s, measured});
      next_s = time_s + (recipe.uneven ? random.uniform(0.0003, 0.0017) : 0.001);
    }
    position_mm += command.at(i) * kFineS;
  }
  return stream;
}

}  // namespace tactus::experiments
