#include "core/contracts/telling_stroke.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/text.h"
#include "core/contracts/contract_check.h"
#include "core/contracts/prover.h"
#include "core/contracts/worst_case.h"

namespace tactus::contracts {
namespace {

constexpr std::size_t kPlaces = 121;   // of a stroke, equally spaced in time, both ends
constexpr std::size_t kSlices = 12;    // of the depth: one place where the models differ most in each
constexpr std::size_t kLines = 60;     // looks in a slice
constexpr std::size_t kClimbs = 8;     // strokes that are climbed from
constexpr std::size_t kStrokes = 200;  // anywhere, each changed eight times
constexpr double kSearchShare = 0.6;   // of the progress; the rest is the bound
constexpr std::size_t kSearchSteps = kSlices + 2 * kClimbs + 1;
constexpr std::size_t kPartsOfAStep = 1024;
constexpr double kFirstBoundJnd = 8;
constexpr double kBoundShare = 1.1;  // a bound this near to what was found is good enough
constexpr double kBoundJnd = 0.02;   // and so is one as small as this

using fuzzy::CompiledModel;
using fuzzy::ForceModel;

/// The difference at one place, in just-noticeable ones; minus infinity where a model has no force.
double jndAt(const CompiledModel& first, const CompiledModel& second, std::span<const double> point) {
  const auto a = first.evaluate(point);
  const auto b = second.evaluate(point);
  if (!a.fired || !b.fired) return -std::numeric_limits<double>::infinity();
  return std::abs(b.force_n - a.force_n) / justNoticeableDifference(a.force_n);
}

class Search {
 public:
  Search(const ForceModel& first, const CompiledModel& compiled_first, const CompiledModel& compiled_second,
         const ForceModel& second, StrokeInputs inputs, const StrokeLimits& limits)
      : first_(compiled_first), second_(compiled_second), inputs_(inputs), limits_(limits) {
    for (std::size_t i = 0; i < first.inputs.size(); ++i) {
      WorstCase::Side side{first.inputs[i].min, first.inputs[i].max, {}};
      if (inputs_.speed == i) {
        side.low = std::max(side.low, 0.0);
        side.high = std::max(side.low, std::min(side.high, limits.fastest_mm_s));
      }
      side.places = {side.low, side.high};
      for (const ForceModel* const model : {&first, &second}) addBends(*model, i, side);
      std::sort(side.places.begin(), side.places.end());
      side.places.erase(std::unique(side.places.begin(), side.places.end()), side.places.end());
      sides_.push_back(std::move(side));
    }
    limits_.shortest_mm = std::min(limits_.shortest_mm, sides_[inputs_.depth].high - sides_[inputs_.depth].low);
  }

  std::vector<Interval> ranges() const {
    std::vector<Interval> out;
    for (const auto& side : sides_) out.emplace_back(side.low, side.high);
    return out;
  }

  void run(const std::stop_token& stop, const std::function<void(double)>& progress) {
    std::size_t steps = 0;
    const auto step = [&] {
      if (progress) progress(kSearchShare * static_cast<double>(++steps) / static_cast<double>(kSearchSteps));
    };
    // A place for each slice of the depth, the largest difference first.
    std::vector<std::pair<double, std::vector<double>>> places;
    const WorstCase::Side& depth = sides_[inputs_.depth];
    for (std::size_t slice = 0; slice < kSlices && !stop.stop_requested(); ++slice) {
      auto sides = sides_;
      WorstCase::Side& own = sides[inputs_.depth];
      const double width = (depth.high - depth.low) / kSlices;
      own.low = depth.low + width * static_cast<double>(slice);
      own.high = std::min(depth.high, own.low + width);
      std::erase_if(own.places, [&](double x) { return x <= own.low || x >= own.high; });
      own.places.insert(own.places.begin(), own.low);
      own.places.push_back(own.high);
      WorstCase search(std::move(sides), [&](std::span<const double> point) { return jndAt(first_, second_, point); });
      search.search(std::nullopt, kLines);
      if (search.value() >= 0) places.emplace_back(search.value(), search.place());
      step();
    }
    std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    largest_jnd_ = places.empty() ? 0 : places.front().first;
    if (places.size() > kClimbs) places.resize(kClimbs);

    WorstCase strokes(strokeSides(), [&](std::span<const double> z) {
      const Stroke stroke = strokeOf(z);
      if (stroke.to_mm > sides_[inputs_.depth].high) return -std::numeric_limits<double>::infinity();
      const StrokeFeel feel = feelOf(first_, second_, inputs_, stroke);
      return feel.peak_n > limits_.device_n ? -std::numeric_limits<double>::infinity() : feel.rms_jnd;
    });
    if (largest_jnd_ == 0) {
      strokes.climb(start(middle(), limits_.shortest_mm));
    } else {
      for (const auto& [jnd, place] : places) {
        for (const double length_mm : {limits_.shortest_mm, 2 * limits_.shortest_mm}) {
          if (!stop.stop_requested()) strokes.climb(start(place, length_mm));
          step();
        }
      }
      // Strokes anywhere: a long one may gather more than the place where the models differ most.
      if (!stop.stop_requested()) strokes.search(std::nullopt, kStrokes);
    }
    // Without a place it was stopped before the first look; without a value each stroke is beyond the device.
    found_ = strokeOf(strokes.place().empty() ? start(middle(), limits_.shortest_mm) : strokes.place());
    is_any_ = std::isfinite(strokes.value());
  }

  const Stroke& found() const { return found_; }
  bool isAny() const { return is_any_; }
  double largestJnd() const { return largest_jnd_; }

 private:
  void addBends(const ForceModel& model, std::size_t input, WorstCase::Side& side) const {
    for (const auto& expert : model.experts) {
      for (const fuzzy::Term& term : termsFor(expert, model.inputs[input])) {
        const std::size_t count = term.shape == fuzzy::Shape::kGaussian ? 1 : term.points.size();
        for (std::size_t p = 0; p < count; ++p) {
          if (term.points[p] > side.low && term.points[p] < side.high) side.places.push_back(term.points[p]);
        }
      }
    }
  }

  std::vector<double> middle() const {
    std::vector<double> out;
    for (const auto& side : sides_) out.push_back(side.low + (side.high - side.low) / 2);
    return out;
  }

  /// The inputs, with the beginning in place of the depth and the peak in place of the speed; then the length.
  std::vector<WorstCase::Side> strokeSides() const {
    auto sides = sides_;
    const auto peaks = [&] {
      WorstCase::Side side{limits_.slowest_mm_s, limits_.fastest_mm_s, {}};
      if (inputs_.speed) side.places = sides_[*inputs_.speed].places;
      std::erase_if(side.places, [&](double x) { return x < side.low || x > side.high; });
      if (side.places.empty()) side.places = {side.low, side.high};
      return side;
    };
    if (inputs_.speed) sides[*inputs_.speed] = peaks();
    const double longest = std::max(limits_.shortest_mm, sides_[inputs_.depth].high - sides_[inputs_.depth].low);
    sides.push_back({limits_.shortest_mm, longest, {limits_.shortest_mm, longest}});
    if (!inputs_.speed) sides.push_back(peaks());
    return sides;
  }

  Stroke strokeOf(std::span<const double> z) const {
    Stroke stroke;
    stroke.inputs.assign(z.begin(), z.begin() + static_cast<std::ptrdiff_t>(sides_.size()));
    stroke.from_mm = z[inputs_.depth];
    stroke.to_mm = stroke.from_mm + z[sides_.size()];
    stroke.peak_mm_s = inputs_.speed ? z[*inputs_.speed] : z.back();
    return stroke;
  }

  /// Around a place, with its speed at the peak.
  std::vector<double> start(std::vector<double> place, double length_mm) const {
    const WorstCase::Side& depth = sides_[inputs_.depth];
    const double length = std::min(length_mm, depth.high - depth.low);
    const double from = std::clamp(place[inputs_.depth] - length / 2, depth.low, depth.high - length);
    place[inputs_.depth] = from;
    if (inputs_.speed)
      place[*inputs_.speed] = std::clamp(place[*inputs_.speed], limits_.slowest_mm_s, limits_.fastest_mm_s);
    place.push_back(length);
    if (!inputs_.speed) place.push_back(limits_.fastest_mm_s / 2);
    return place;
  }

  const CompiledModel& first_;
  const CompiledModel& second_;
  StrokeInputs inputs_;
  StrokeLimits limits_;
  std::vector<WorstCase::Side> sides_;
  Stroke found_;
  bool is_any_ = false;
  double largest_jnd_ = 0;
};

/// A bound on the difference everywhere.
void addBound(const ForceModel& first, const ForceModel& second, const Search& search, const TellEffort& effort,
              const std::stop_token& stop, TellingStroke& out) {
  std::size_t bounded = 0;
  const auto count = [&] {
    if (++bounded % kPartsOfAStep != 0 || !effort.progress) return;
    const double share = static_cast<double>(bounded) / static_cast<double>(effort.parts);
    effort.progress(kSearchShare + (1 - kSearchShare) * std::min(1.0, share));
  };
  ProofTask task;
  const auto variables = plainVariables(first.inputs.size());
  task.copies = {{&first, 1, variables}, {&second, -1, variables}};
  task.ranges = search.ranges();
  // Ever smaller bounds, as far as the effort goes: a large one is soon proved.
  const double least = std::max(kBoundJnd, search.largestJnd() * kBoundShare);
  double aim = std::max(kFirstBoundJnd, least);
  while (true) {
    task.excess = [aim, &count](const PartBounds& bounds) {
      count();
      const double most = std::max(std::abs(bounds.value.low), std::abs(bounds.value.high));
      const double force_n = bounds.first.low > 0 ? bounds.first.low : bounds.first.high < 0 ? -bounds.first.high : 0;
      return up(most / (justNoticeableDifference(force_n) * (1 - 1e-12))) - aim;
    };
    const Proof proof = prove(task, effort.parts - std::min(effort.parts, out.parts), stop);
    out.parts += proof.parts;
    if (!proof.complete || proof.too_many) return;
    const double bound = aim + std::max(0.0, proof.largest);
    if (!out.bound_jnd || bound < *out.bound_jnd) out.bound_jnd = bound;
    if (!proof.proved || aim == least) return;
    aim = std::max(least, aim / 2);
  }
}

}  // namespace

base::Result<StrokeInputs> strokeInputs(const ForceModel& model) {
  const auto depth = fuzzy::wayOf(model.inputs);
  if (!depth)
    return base::fail(base::ErrorCode::kReference, "/inputs", "no way of a tip", "one that a stroke moves along");
  return StrokeInputs{*depth, fuzzy::rateOf(model.inputs)};
}

StrokeMoment momentOf(const Stroke& stroke, double done) {
  const double t = done;
  const double length_mm = stroke.to_mm - stroke.from_mm;
  return {done * 15 * length_mm / (8 * stroke.peak_mm_s),
          stroke.from_mm + length_mm * (t * t * t * (10 + t * (-15 + 6 * t))),
          stroke.peak_mm_s * 16 * t * t * (1 - t) * (1 - t)};
}

StrokeFeel feelOf(const CompiledModel& first, const CompiledModel& second, const StrokeInputs& inputs,
                  const Stroke& stroke) {
  StrokeFeel feel;
  std::vector<double> point = stroke.inputs;
  double squares = 0;
  double weights = 0;
  for (std::size_t p = 0; p < kPlaces; ++p) {
    const StrokeMoment moment = momentOf(stroke, static_cast<double>(p) / (kPlaces - 1));
    point[inputs.depth] = moment.depth_mm;
    if (inputs.speed) point[*inputs.speed] = moment.speed_mm_s;
    const auto a = first.evaluate(point);
    const auto b = second.evaluate(point);
    feel.peak_n = std::max({feel.peak_n, std::abs(a.force_n), std::abs(b.force_n)});
    if (!a.fired || !b.fired) {
      ++feel.silent;
      continue;
    }
    const double weight = p == 0 || p + 1 == kPlaces ? 0.5 : 1;
    const double difference_n = b.force_n - a.force_n;
    const double jnd = std::abs(difference_n) / justNoticeableDifference(a.force_n);
    squares += weight * jnd * jnd;
    weights += weight;
    if (jnd > feel.largest_jnd) feel.largest_jnd = jnd, feel.largest_n = difference_n, feel.at_mm = point[inputs.depth];
  }
  if (weights > 0) feel.rms_jnd = std::sqrt(squares / weights);
  return feel;
}

base::Result<TellingStroke> tell(const ForceModel& first, const CompiledModel& compiled_first, const ForceModel& second,
                                 const CompiledModel& compiled_second, const StrokeLimits& limits,
                                 const TellEffort& effort, const std::stop_token& stop) {
  TACTUS_TRY(const auto inputs, strokeInputs(first));
  const auto same = [](const fuzzy::Variable& a, const fuzzy::Variable& b) {
    return a.id == b.id && a.unit == b.unit && a.min == b.min && a.max == b.max;
  };
  if (!std::equal(first.inputs.begin(), first.inputs.end(), second.inputs.begin(), second.inputs.end(), same))
    return base::fail(base::ErrorCode::kMismatch, "/inputs", "other inputs in the second model",
                      "the same inputs and universes in both");
  Search search(first, compiled_first, compiled_second, second, inputs, limits);
  search.run(stop, effort.progress);
  if (!search.isAny() && !stop.stop_requested()) {
    return base::fail(base::ErrorCode::kValue, {}, "no stroke of at most " + base::formatNumber(limits.device_n) + " N",
                      "a stroke that the device can give");
  }
  TellingStroke out;
  out.stroke = search.found();
  out.feel = feelOf(compiled_first, compiled_second, inputs, out.stroke);
  if (effort.bound) addBound(first, second, search, effort, stop, out);
  if (effort.progress) effort.progress(1);
  return out;
}

}  // namespace tactus::contracts
