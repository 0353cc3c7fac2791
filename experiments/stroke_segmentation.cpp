#include "experiments/stroke_segmentation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/check.h"
#include "core/base/statistics.h"

namespace tactus::experiments {

MovementDetector::MovementDetector(const StrokeSettings& settings, double lowest_been_mm)
    : settings_(settings),
      half_window_(static_cast<std::size_t>(std::lround(settings.speed_window_s / 2 / EvenPositions::kStepS))),
      pause_steps_(static_cast<std::size_t>(std::lround(settings.longest_pause_s / EvenPositions::kStepS))),
      lowest_been_mm_(lowest_been_mm) {}

void MovementDetector::advance(const EvenPositions& positions, bool ended) {
  const std::size_t margin = ended ? 0 : half_window_;
  for (; decided_ + margin < positions.size(); ++decided_) {
    const double speed_mm_s = slopeAt(positions, decided_);
    const double position_mm = positions.at(decided_);
    speeds_mm_s_.push_back(speed_mm_s);
    lookForward(decided_, position_mm, speed_mm_s);
    lookBack(decided_, position_mm, speed_mm_s);
  }
  if (!ended || decided_ == 0) return;
  if (phase_ == Phase::kMoving) close(decided_ - 1, furthest_mm_ - begin_mm_, true);
  if (phase_ == Phase::kPausing) close(paused_at_, furthest_mm_ - begin_mm_, false);
  back_.reset();
}

std::optional<Movement> MovementDetector::take() {
  if (found_.empty()) return std::nullopt;
  const Movement movement = found_.front();
  found_.pop_front();
  return movement;
}

std::size_t MovementDetector::earliestNeeded() const noexcept {
  std::size_t earliest = decided_;
  if (phase_ != Phase::kIdle) earliest = std::min(earliest, forward_.begin);
  if (back_) earliest = std::min(earliest, back_->begin);
  for (const auto& movement : found_) earliest = std::min(earliest, movement.begin);
  return earliest;
}

void MovementDetector::forgetBefore(std::size_t step) {
  while (first_ < step && !speeds_mm_s_.empty()) {
    speeds_mm_s_.pop_front();
    ++first_;
  }
}

/// Slope of the straight line through the positions around `step`: an average over the window, without delay.
double MovementDetector::slopeAt(const EvenPositions& positions, std::size_t step) const {
  const std::size_t from = std::max(positions.first(), step < half_window_ ? 0 : step - half_window_);
  const std::size_t to = std::min(positions.size() - 1, step + half_window_);
  const double middle = static_cast<double>(from + to) / 2;
  double moment = 0;
  double squares = 0;
  for (std::size_t i = from; i <= to; ++i) {
    const double distance = static_cast<double>(i) - middle;
    moment += distance * positions.at(i);
    squares += distance * distance;
  }
  return squares > 0 ? moment / squares / EvenPositions::kStepS : 0;
}

/// The first step of the movement that reached its starting speed at `step`.
std::size_t MovementDetector::quietBefore(std::size_t step, double direction) const {
  while (step > first_ && direction * speedAt(step - 1) >= settings_.stop_speed_mm_s) --step;
  return step;
}

void MovementDetector::lookForward(std::size_t step, double position_mm, double speed_mm_s) {
  const bool fast = speed_mm_s >= settings_.start_speed_mm_s;
  furthest_mm_ = std::max(furthest_mm_, position_mm);
  if (fast && phase_ == Phase::kIdle) {
    forward_ = {quietBefore(step, 1), step, step, step};
    begin_mm_ = position_mm;
    furthest_mm_ = position_mm;
    phase_ = Phase::kMoving;
  } else if (fast) {
    forward_.fast_to = step;
    phase_ = Phase::kMoving;
  } else if (phase_ == Phase::kMoving && speed_mm_s < settings_.stop_speed_mm_s) {
    phase_ = Phase::kPausing;
    paused_at_ = step;
  } else if (phase_ == Phase::kPausing) {
    const bool gone_back = furthest_mm_ - position_mm > settings_.longest_reversal_mm;
    if (gone_back || step - paused_at_ > pause_steps_) close(paused_at_, furthest_mm_ - begin_mm_, false);
  }
}

void MovementDetector::close(std::size_t end, double length_mm, bool interrupted) {
  phase_ = Phase::kIdle;
  forward_.end = end;
  forward_.interrupted = interrupted;
  if (length_mm >= settings_.least_mm) found_.push_back(forward_);
}

void MovementDetector::lookBack(std::size_t step, double position_mm, double speed_mm_s) {
  if (speed_mm_s <= -settings_.start_speed_mm_s) {
    if (!back_) back_ = Movement{quietBefore(step, -1), step, step, step, false, false};
    back_->fast_to = step;
    return;
  }
  if (back_ && speed_mm_s < -settings_.stop_speed_mm_s) return;
  if (back_) {
    back_->end = step;
    if (lowest_been_mm_ - position_mm >= settings_.shortest_mm) found_.push_back(*back_);
    back_.reset();
  }
  lowest_been_mm_ = std::min(lowest_been_mm_, position_mm);
}

namespace {

constexpr double kLowestHz = 7;
constexpr double kStepHz = 0.5;
constexpr std::size_t kFrequencies = 13;
constexpr double kLeastNoiseMm = 0.005;
// Starts: movements without detail below these widths; powers of their roughness, 0 = equally rough everywhere.
constexpr std::array kPilotsS = {0.04, 0.02};
constexpr std::array kPilotPowers = {0.0, 1.0, 2.0};
constexpr int kRounds = 5;

/// Derivatives of splineValues by u.
std::array<double, kSplineOrder> splineSlopes(double u) {
  const double v = 1 - u;
  return {-v * v / 2, (3 * u * u - 4 * u) / 2, (4 * v - 3 * v * v) / 2, u * u / 2};
}

/// Standard deviation of the noise of each position, from third differences; a movement hardly shows in their median.
double noiseMm(std::span<const double> y) {
  std::vector<double> sizes;
  for (std::size_t i = 3; i < y.size(); ++i) {
    sizes.push_back(std::abs(y[i] - 3 * y[i - 1] + 3 * y[i - 2] - y[i - 3]));
  }
  constexpr double kMedianToDeviation = 1.4826;  // of a normal distribution
  return std::max(kLeastNoiseMm, kMedianToDeviation * base::median(std::move(sizes)) / std::sqrt(20.0));
}

/// The positions at the knots without tremor and without detail: straight lines through weighted neighbors.
std::vector<double> pilotAtKnots(std::span<const double> y, double step_s, std::size_t knots, double pilot_s) {
  std::vector<double> pilot(knots);
  for (std::size_t knot = 0; knot < knots; ++knot) {
    const double centre_s = (static_cast<double>(knot) - 1) * kKnotS;
    double w0 = 0, w1 = 0, w2 = 0, v0 = 0, v1 = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double away_s = static_cast<double>(i) * step_s - centre_s;
      const double weight = std::exp(-away_s * away_s / (2 * pilot_s * pilot_s));
      w0 += weight;
      w1 += weight * away_s;
      w2 += weight * away_s * away_s;
      v0 += weight * y[i];
      v1 += weight * away_s * y[i];
    }
    pilot[knot] = (w2 * v0 - w1 * v1) / (w0 * w2 - w1 * w1);
  }
  return pilot;
}

}  // namespace

SmoothMotion::SmoothMotion(std::span<const double> y, double step_s)
    : knot_s_(kKnotS), length_s_(static_cast<double>(y.size() - 1) * step_s), offset_mm_(y[y.size() / 2]) {
  TACTUS_CHECK(y.size() >= kFewestPositions && step_s > 0);
  const auto spans = static_cast<std::size_t>(std::ceil(length_s_ / kKnotS - 1e-9));
  const std::size_t spline_count = spans + kSplineOrder - 1;
  const double noise_mm = noiseMm(y);

  std::array<double, kFrequencies> hz{};
  for (std::size_t i = 0; i < hz.size(); ++i) hz[i] = kLowestHz + static_cast<double>(i) * kStepHz;
  const MotionEquations equations(y, step_s, offset_mm_, hz, spline_count, noise_mm);
  // From one start the rounds may end where tremor and movement are mixed up; the likelihood tells.
  MotionFit best;
  for (const double pilot_s : kPilotsS) {
    const auto pilot = roughness(pilotAtKnots(y, step_s, spline_count, pilot_s));
    for (const double power : kPilotPowers) {
      std::vector<double> rough = pilot;
      for (double& value : rough) value = std::pow(value, power);
      MotionFit fit = likeliestMotion(equations, rough);
      for (int round = 1; round < kRounds && !fit.coefficients.empty(); ++round) {
        fit = likeliestMotion(equations, roughness(fit.coefficients), &fit);
      }
      if (fit.unlikelihood < best.unlikelihood) best = std::move(fit);
    }
  }
  coefficients_ = std::move(best.coefficients);
  TACTUS_CHECK(coefficients_.size() == spline_count);
}

double SmoothMotion::speedMmS(double time_s) const {
  const double place = std::clamp(time_s, 0.0, length_s_) / knot_s_;
  const auto knot = std::min(static_cast<std::size_t>(place), coefficients_.size() - kSplineOrder);
  const auto slopes = splineSlopes(place - static_cast<double>(knot));
  double speed = 0;
  for (std::size_t k = 0; k < kSplineOrder; ++k) speed += slopes[k] * coefficients_[knot + k];
  return speed / knot_s_;
}

double SmoothMotion::positionMm(double time_s) const {
  const double place = std::clamp(time_s, 0.0, length_s_) / knot_s_;
  const auto knot = std::min(static_cast<std::size_t>(place), coefficients_.size() - kSplineOrder);
  const auto values = splineValues(place - static_cast<double>(knot));
  double position = offset_mm_;
  for (std::size_t k = 0; k < kSplineOrder; ++k) position += values[k] * coefficients_[knot + k];
  return position;
}

namespace {

constexpr double kFurthestMm = 1e6;  // no device reaches a kilometer: such a number is an error of transmission
// How far to both sides an edge is measured from, in steps: 0.6 s where the movement is quick, because tremor shows
// only before and after it; 0.3 s where it is slow, because the tremor's strength changes over a longer time.
constexpr std::size_t kLongReach = 150;
constexpr std::size_t kMiddleReach = 100;
constexpr std::size_t kShortReach = 75;
constexpr double kQuickS = 0.7;
constexpr double kSlowS = 1.2;
constexpr double kClearly = 0.3;        // of the largest speed nearby
constexpr double kSearchStepS = 0.001;  // the edge lies between two such steps, by linear interpolation

std::size_t reachOf(const Movement& movement) {
  const double fast_s = static_cast<double>(movement.fast_to - movement.fast_from) * EvenPositions::kStepS;
  return fast_s < kQuickS ? kLongReach : fast_s < kSlowS ? kMiddleReach : kShortReach;
}

}  // namespace

StrokeFinder::StrokeFinder(const StrokeSettings& settings) : settings_(settings) {
  TACTUS_CHECK(validate(settings).has_value());
}

void StrokeFinder::add(const PositionSample& sample) {
  const std::size_t index = sample_count_++;
  if (!std::isfinite(sample.time_s) || !(std::abs(sample.position_mm) <= kFurthestMm)) return;
  if (stretch_) {
    const double since_s = sample.time_s - stretch_->positions.lastTimeS();
    if (since_s <= 0) return;
    if (since_s > settings_.longest_gap_s) endStretch();
  }
  if (stretch_) {
    stretch_->positions.add(sample);
  } else {
    if (!lowest_been_mm_) lowest_been_mm_ = sample.position_mm;
    stretch_.emplace(settings_, sample, *lowest_been_mm_);
  }
  stretch_->samples.push_back({sample, index});
  advance(false);
}

void StrokeFinder::finish() { endStretch(); }

std::optional<Stroke> StrokeFinder::take() {
  if (strokes_.empty()) return std::nullopt;
  const Stroke stroke = strokes_.front();
  strokes_.pop_front();
  return stroke;
}

void StrokeFinder::endStretch() {
  if (!stretch_) return;
  advance(true);
  lowest_been_mm_ = stretch_->detector.lowestBeenMm();
  stretch_.reset();
}

void StrokeFinder::advance(bool ended) {
  auto& [positions, detector, samples, to_measure] = *stretch_;
  detector.advance(positions, ended);
  while (const auto movement = detector.take()) to_measure.push_back(*movement);
  while (!to_measure.empty() && (ended || to_measure.front().end + kLongReach < positions.size())) {
    measure(to_measure.front());
    to_measure.pop_front();
  }
  forget();
}

/// Keeps what movements that are open, or still to be measured, need on their left.
void StrokeFinder::forget() {
  auto& [positions, detector, samples, to_measure] = *stretch_;
  std::size_t needed = detector.earliestNeeded();
  if (!to_measure.empty()) needed = std::min(needed, to_measure.front().begin);
  constexpr std::size_t kKeep = 2 * kLongReach;  // more than any window reaches to the left
  if (needed < positions.first() + 2 * kKeep) return;
  needed -= kKeep;
  positions.forgetBefore(needed);
  detector.forgetBefore(needed);
  const double before_s = positions.timeS(static_cast<double>(needed));
  while (samples.size() > 1 && samples[1].sample.time_s < before_s) samples.pop_front();
}

void StrokeFinder::measure(const Movement& movement) {
  const Edge start = edgeOf(movement, true);
  const Edge end = edgeOf(movement, false);
  Stroke stroke;
  stroke.start_s = start.time_s;
  stroke.end_s = std::max(start.time_s, end.time_s);
  stroke.start_mm = start.position_mm;
  stroke.end_mm = end.position_mm;
  const auto earlier = [](const Taken& taken, double time_s) { return taken.sample.time_s < time_s; };
  const auto& samples = stretch_->samples;
  const auto from = std::lower_bound(samples.begin(), samples.end(), stroke.start_s, earlier);
  const auto to = std::lower_bound(from, samples.end(), stroke.end_s, earlier);
  stroke.first = from == samples.end() ? sample_count_ : from->index;
  stroke.last = to == from ? stroke.first : std::prev(to)->index + 1;
  stroke.verdict = verdictOf(stroke, movement);
  strokes_.push_back(stroke);
}

/// Where the movement without tremor passes the edge speed, nearest to where it was surely fast.
StrokeFinder::Edge StrokeFinder::edgeOf(const Movement& movement, bool at_start) const {
  const auto& positions = stretch_->positions;
  const std::size_t fast = at_start ? movement.fast_from : movement.fast_to;
  const std::size_t centre = at_start ? (movement.begin + fast) / 2 : (fast + movement.end) / 2;
  const std::size_t reach = reachOf(movement);
  const std::size_t from = std::max(positions.first(), centre < reach ? 0 : centre - reach);
  const std::size_t to = std::min(positions.size(), centre + reach + 1);
  if (to < from + SmoothMotion::kFewestPositions) {
    const std::size_t coarse = at_start ? movement.begin : movement.end;
    return {positions.timeS(static_cast<double>(coarse)), positions.at(coarse)};
  }

  std::vector<double> around;
  for (std::size_t i = from; i < to; ++i) around.push_back(positions.at(i));
  const SmoothMotion motion(around, EvenPositions::kStepS);
  const double direction = movement.forward ? 1 : -1;
  const auto above = [&](double time_s) { return direction * motion.speedMmS(time_s) - settings_.edge_speed_mm_s; };
  const double length_s = static_cast<double>(to - from - 1) * EvenPositions::kStepS;
  const double inward_s = at_start ? kSearchStepS : -kSearchStepS;
  const auto inside = [length_s](double time_s) { return time_s >= 0 && time_s <= length_s; };

  double time_s =
      std::clamp((static_cast<double>(fast) - static_cast<double>(from)) * EvenPositions::kStepS, 0.0, length_s);
  // Ringing of the fit before an abrupt start must not pass for the start: begin where the hand is clearly moving.
  double peak = 0;
  for (double inner_s = time_s; inside(inner_s); inner_s += inward_s) peak = std::max(peak, above(inner_s));
  while (above(time_s) < kClearly * peak && inside(time_s + inward_s)) time_s += inward_s;
  while (above(time_s) >= 0 && inside(time_s - inward_s)) time_s -= inward_s;
  const double outer = above(time_s);
  const double inner = above(time_s + inward_s);
  if (outer < 0 && inner >= 0) time_s += inward_s * outer / (outer - inner);
  return {positions.timeS(static_cast<double>(from)) + time_s, motion.positionMm(time_s)};
}

StrokeVerdict StrokeFinder::verdictOf(const Stroke& stroke, const Movement& movement) const {
  if (!movement.forward) return StrokeVerdict::kBackwards;
  if (movement.interrupted) return StrokeVerdict::kInterrupted;
  for (const auto& [sample, index] : stretch_->samples) {
    const bool within = index >= stroke.first && index < stroke.last;
    const bool allowed = sample.position_mm >= settings_.lowest_mm && sample.position_mm <= settings_.highest_mm;
    if (within && !allowed) return StrokeVerdict::kOutOfRange;
  }
  if (stroke.lengthMm() < settings_.shortest_mm) return StrokeVerdict::kTooShort;
  if (stroke.durationS() < settings_.briefest_s) return StrokeVerdict::kTooBrief;
  return StrokeVerdict::kAccepted;
}

base::Result<std::vector<Stroke>> findStrokes(std::span<const PositionSample> samples, const StrokeSettings& settings) {
  if (auto valid = validate(settings); !valid) return tl::unexpected(valid.error());
  StrokeFinder finder(settings);
  for (const auto& sample : samples) finder.add(sample);
  finder.finish();
  std::vector<Stroke> strokes;
  while (auto stroke = finder.take()) strokes.push_back(*stroke);
  return strokes;
}

}  // namespace tactus::experiments
