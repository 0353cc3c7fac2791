#include "experiments/stroke_segmentation.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "experiments/smooth_motion.h"

namespace tactus::experiments {
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
