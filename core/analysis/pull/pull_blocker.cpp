#include "core/analysis/pull/pull_blocker.h"

#include <algorithm>
#include <cmath>

namespace tactus::analysis {
namespace {

using Kind = PullBlocker::Kind;

constexpr int kStrengths = 16;
constexpr double kAtTheEnd = 1e-9;  // of the range of a delta: the search ends exactly there, up to rounding

/// What lies below ramp `ramp`, or above it.
PullBlocker below(const SearchedGesture& gesture, const std::vector<fuzzy::Term>& terms, const Ramps& ramps,
                  std::size_t ramp) {
  if (ramp == 0) return {Kind::kUniverse, gesture.edit.list.variable, {}, 0};
  return {Kind::kOrder, gesture.edit.list.variable, terms[ramps.order[ramp]].id, 0};
}

PullBlocker above(const SearchedGesture& gesture, const std::vector<fuzzy::Term>& terms, const Ramps& ramps,
                  std::size_t ramp) {
  if (ramp + 1 == ramps.p.size()) return {Kind::kUniverse, gesture.edit.list.variable, {}, 0};
  return {Kind::kOrder, gesture.edit.list.variable, terms[ramps.order[ramp + 1]].id, 0};
}

PullBlocker atTheEnd(const SearchedGesture& gesture, const std::vector<fuzzy::Term>& terms, const Ramps& ramps,
                     bool at_high) {
  const std::size_t place = gesture.edit.place;
  const auto& own = terms[ramps.order[place]].id;
  const PullBlocker no_ramp{Kind::kRamp, gesture.edit.list.variable, own, 0};
  const auto wider = [&](std::size_t left) {  // the nearer of the two ends
    const auto upward = moved(ramps, Gesture::kEnd, place, gesture.range.high);
    const bool full = upward.q[place] >= (place + 1 == ramps.p.size() ? ramps.high : ramps.p[place + 1]);
    return full ? above(gesture, terms, ramps, place) : below(gesture, terms, ramps, left);
  };
  switch (gesture.edit.gesture) {
    case Gesture::kBegin:
      return at_high ? no_ramp : below(gesture, terms, ramps, place);
    case Gesture::kEnd:
      return at_high ? above(gesture, terms, ramps, place) : no_ramp;
    case Gesture::kShift:
      return at_high ? above(gesture, terms, ramps, place) : below(gesture, terms, ramps, place);
    case Gesture::kWidth:
      return at_high ? wider(place) : no_ramp;
    case Gesture::kMove:
      return at_high ? above(gesture, terms, ramps, place) : below(gesture, terms, ramps, place - 1);
    case Gesture::kWiden:
      return at_high ? wider(place - 1) : PullBlocker{Kind::kOrder, gesture.edit.list.variable, own, 0};
    default:
      return {Kind::kTurn, gesture.edit.list.variable, own, 0};
  }
}

}  // namespace

std::optional<PullBlocker> centroidLimit(const PointForce& point, double target_n) {
  const bool upward = point.now() && target_n > *point.now();
  std::optional<PullBlocker> limit;
  for (std::size_t e = 0; e < point.experts().size(); ++e) {
    const auto& words = point.experts()[e].words;
    const auto& terms = termsFor(point.model().experts[e], point.model().output);
    for (std::size_t w = 0; w < words.size(); ++w) {
      std::vector<double> strengths(words.size(), 0);
      for (int i = 1; i <= kStrengths; ++i) {
        strengths[w] = static_cast<double>(i) / kStrengths;
        const double force_n = *point.centroid(strengths, words);
        if (limit && (upward ? force_n <= limit->limit_n : force_n >= limit->limit_n)) continue;
        limit = {Kind::kCentroid, point.model().inputs.size(), terms[w].id, force_n};
      }
    }
  }
  if (!limit || (upward ? target_n <= limit->limit_n : target_n >= limit->limit_n)) return std::nullopt;
  return limit;
}

PullBlocker whereItStops(const fuzzy::ForceModel& model, const SearchedGesture& gesture) {
  const std::vector<fuzzy::Term>& terms = termsOf(model, gesture.edit.list);
  const double at = gesture.reach.nearest->at;
  const double same = kAtTheEnd * (gesture.range.high - gesture.range.low);
  const bool at_low = at < 0 && at - gesture.range.low <= same;
  const bool at_high = at > 0 && gesture.range.high - at <= same;
  PullBlocker out{Kind::kTurn, gesture.edit.list.variable, {}, 0};
  if (at_low || at_high) {
    const auto ramps = rampsOf(variableAt(model, gesture.edit.list.variable), terms);
    out = ramps ? atTheEnd(gesture, terms, *ramps, at_high)
                : PullBlocker{Kind::kOrder, gesture.edit.list.variable, terms[gesture.edit.place].id, 0};
  }
  out.limit_n = gesture.reach.nearest->force_n;
  return out;
}

}  // namespace tactus::analysis
