#include "core/analysis/pull/pull_edit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/check.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {
namespace {

using fuzzy::Shape;
using fuzzy::Term;

/// Where ramp r could begin at the earliest, and end at the latest.
double floorOf(const Ramps& ramps, std::size_t r) { return r == 0 ? ramps.low : ramps.q[r - 1]; }
double ceilingOf(const Ramps& ramps, std::size_t r) { return r + 1 == ramps.p.size() ? ramps.high : ramps.p[r + 1]; }

std::vector<double> asTrapezoid(const Term& term) {
  const auto f = fuzzy::MembershipFunction::of(term);
  return {f.a, f.b, f.c, f.d};
}

}  // namespace

std::optional<Ramps> rampsOf(const fuzzy::Variable& variable, const std::vector<Term>& terms) {
  auto order = partitionOrder(variable, terms);
  if (!order) return std::nullopt;
  Ramps ramps{std::move(*order), {}, {}, variable.min, variable.max, kNarrowestShare * (variable.max - variable.min)};
  for (std::size_t r = 0; r + 1 < ramps.order.size(); ++r) {
    const auto f = fuzzy::MembershipFunction::of(terms[ramps.order[r]]);
    ramps.p.push_back(f.c);
    ramps.q.push_back(f.d);
  }
  return ramps;
}

void writeRamps(const Ramps& before, const Ramps& after, std::vector<Term>& terms) {
  std::vector<std::vector<double>> points;
  points.reserve(terms.size());
  for (const Term& term : terms) points.push_back(asTrapezoid(term));
  for (std::size_t r = 0; r < after.p.size(); ++r) {
    auto& left = points[after.order[r]];
    auto& right = points[after.order[r + 1]];
    if (after.p[r] != before.p[r]) left[2] = right[0] = after.p[r];
    if (after.q[r] != before.q[r]) left[3] = right[1] = after.q[r];
  }
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (points[t] == asTrapezoid(terms[t])) continue;
    const bool stays_triangle = terms[t].shape == Shape::kTriangle && points[t][1] == points[t][2];
    if (stays_triangle) points[t].erase(points[t].begin() + 2);
    terms[t].shape = stays_triangle ? Shape::kTriangle : Shape::kTrapezoid;
    terms[t].points = std::move(points[t]);
  }
}

std::vector<GesturePlace> gesturesOf(const Ramps& ramps) {
  std::vector<GesturePlace> out;
  for (std::size_t r = 0; r < ramps.p.size(); ++r) {
    for (const auto gesture : {Gesture::kBegin, Gesture::kEnd, Gesture::kShift, Gesture::kWidth}) {
      out.push_back({gesture, r});
    }
  }
  for (std::size_t t = 1; t + 1 < ramps.order.size(); ++t) {
    for (const auto gesture : {Gesture::kMove, Gesture::kWiden}) out.push_back({gesture, t});
  }
  return out;
}

DeltaRange allowedDeltas(const Ramps& ramps, Gesture gesture, std::size_t place) {
  const bool of_term = gesture == Gesture::kMove || gesture == Gesture::kWiden;
  const std::size_t left = of_term ? place - 1 : place;  // ramps of the gesture
  const std::size_t right = place;
  const double down = ramps.p[left] - floorOf(ramps, left);    // room of the left ramp downward
  const double up = ceilingOf(ramps, right) - ramps.q[right];  // room of the right ramp upward
  const double width = ramps.q[right] - ramps.p[right];
  const double narrower = width - ramps.narrowest;
  DeltaRange range{-down, up};
  if (gesture == Gesture::kBegin) range.high = narrower;
  if (gesture == Gesture::kEnd) range.low = -narrower;
  if (gesture == Gesture::kWidth) range = {-narrower / 2, std::min(down, up)};
  if (gesture == Gesture::kWiden) range = {-(ramps.p[right] - ramps.q[left]) / 2, std::min(down, up)};
  return {std::min(range.low, 0.0), std::max(range.high, 0.0)};
}

Ramps moved(Ramps ramps, Gesture gesture, std::size_t place, double delta) {
  const auto shift = [&](std::size_t r, double p, double q) {
    ramps.p[r] = std::clamp(ramps.p[r] + p, std::min(floorOf(ramps, r), ramps.p[r]), std::max(ramps.high, ramps.p[r]));
    ramps.q[r] = std::clamp(ramps.q[r] + q, std::min(ramps.low, ramps.q[r]), std::max(ceilingOf(ramps, r), ramps.q[r]));
  };
  switch (gesture) {
    case Gesture::kBegin: shift(place, delta, 0); break;
    case Gesture::kEnd: shift(place, 0, delta); break;
    case Gesture::kShift: shift(place, delta, delta); break;
    case Gesture::kWidth: shift(place, -delta, delta); break;
    case Gesture::kMove:  // the ramp in front goes first, so that it is not in the way of the other
      shift(delta > 0 ? place : place - 1, delta, delta);
      shift(delta > 0 ? place - 1 : place, delta, delta);
      break;
    case Gesture::kWiden:
      shift(place - 1, -delta, -delta);
      shift(place, delta, delta);
      break;
    default: break;
  }
  return ramps;
}

double shareBelow(const Ramps& ramps, std::size_t ramp, double x) {
  if (x <= ramps.p[ramp]) return 1;
  if (x >= ramps.q[ramp]) return 0;
  return (ramps.q[ramp] - x) / (ramps.q[ramp] - ramps.p[ramp]);
}

std::vector<double> membershipsAt(const Ramps& ramps, double x) {
  std::vector<double> out(ramps.order.size());
  double above = 1;  // share of the terms from this one on
  for (std::size_t t = 0; t < ramps.order.size(); ++t) {
    const double below = t + 1 < ramps.order.size() ? shareBelow(ramps, t, x) : 1;
    out[ramps.order[t]] = std::min(above, below);
    above = 1 - below;
  }
  return out;
}

std::optional<double> deltaFor(const Ramps& ramps, const GesturePlace& gesture, std::size_t ramp, double share,
                               double x) {
  const double p = ramps.p[ramp];
  const double q = ramps.q[ramp];
  const double shift = share * (q - p) - (q - x);
  switch (gesture.gesture) {
    case Gesture::kBegin:
      if (gesture.place != ramp || share <= 0 || x >= q) return std::nullopt;
      return q - (q - x) / share - p;
    case Gesture::kEnd:
      if (gesture.place != ramp || share >= 1 || x <= p) return std::nullopt;
      return (x - share * p) / (1 - share) - q;
    case Gesture::kShift: return gesture.place == ramp ? std::optional(shift) : std::nullopt;
    case Gesture::kWidth:
      if (gesture.place != ramp || share == .5) return std::nullopt;
      return shift / (1 - 2 * share);
    case Gesture::kMove:
      return gesture.place == ramp || gesture.place == ramp + 1 ? std::optional(shift) : std::nullopt;
    case Gesture::kWiden:
      if (gesture.place == ramp) return shift;
      return gesture.place == ramp + 1 ? std::optional(-shift) : std::nullopt;
    default: return std::nullopt;
  }
}

namespace {

using fuzzy::Expert;
using fuzzy::ForceModel;
using fuzzy::Term;

std::vector<Term>& changeableTerms(ForceModel& model, const PulledList& list) {
  fuzzy::Variable& variable = list.variable < model.inputs.size() ? model.inputs[list.variable] : model.output;
  if (list.owner.empty()) return variable.terms;
  for (auto& own : model.experts[expertIndex(model, list.owner)].overrides) {
    if (own.variable == variable.id) return own.terms;
  }
  TACTUS_CHECK(false);
  return variable.terms;
}

}  // namespace

std::string_view name(Gesture gesture) noexcept {
  constexpr std::array<std::string_view, 10> kNames = {"p",     "q",      "shift", "width", "move",
                                                       "widen", "vertex", "word",  "off",   "weight"};
  return kNames[static_cast<std::size_t>(gesture)];
}

std::size_t expertIndex(const ForceModel& model, std::string_view id) {
  const auto it = std::find_if(model.experts.begin(), model.experts.end(), [&](const Expert& e) { return e.id == id; });
  TACTUS_CHECK(it != model.experts.end());
  return static_cast<std::size_t>(it - model.experts.begin());
}

const std::vector<Term>& termsOf(const ForceModel& model, const PulledList& list) {
  const fuzzy::Variable& variable = variableAt(model, list.variable);
  return list.owner.empty() ? variable.terms : termsFor(model.experts[expertIndex(model, list.owner)], variable);
}

std::vector<std::size_t> readersOf(const ForceModel& model, const PulledList& list) {
  if (!list.owner.empty()) return {expertIndex(model, list.owner)};
  std::vector<std::size_t> readers;
  const fuzzy::Variable& variable = variableAt(model, list.variable);
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    if (&termsFor(model.experts[e], variable) == &variable.terms) readers.push_back(e);
  }
  return readers;
}

PullEdit ruleEdit(Gesture gesture, const std::string& expert, std::size_t rule, double delta, const std::string& then) {
  PullEdit edit;
  edit.gesture = gesture;
  edit.expert = expert;
  edit.rule = rule;
  edit.delta = delta;
  edit.then = then;
  return edit;
}

PullEdit termEdit(Gesture gesture, const PulledList& list, std::size_t place, std::size_t vertex) {
  PullEdit edit;
  edit.gesture = gesture;
  edit.list = list;
  edit.place = place;
  edit.vertex = vertex;
  return edit;
}

namespace {

/// The ends of ramps that a gesture moves: those of ramp `first` to `last`, where it moves p, q or both.
struct MovedEnds {
  std::size_t first = 0;
  std::size_t last = 0;
  bool p = true;
  bool q = true;

  bool holdsP(std::size_t ramp) const { return p && ramp >= first && ramp <= last; }
  bool holdsQ(std::size_t ramp) const { return q && ramp >= first && ramp <= last; }
};

MovedEnds movedEnds(const PullEdit& edit) {
  const bool of_term = edit.gesture == Gesture::kMove || edit.gesture == Gesture::kWiden;
  return {edit.place - (of_term ? 1 : 0), edit.place, edit.gesture != Gesture::kEnd, edit.gesture != Gesture::kBegin};
}

/// Whether point `point` of the term at `place` of the order is such an end.
bool isMoved(const MovedEnds& ends, const Ramps& ramps, const Term& term, std::size_t place, std::size_t point) {
  const bool triangle = term.shape == Shape::kTriangle;
  const std::size_t last = triangle ? 2 : 3;
  const bool has_left = place > 0;
  const bool has_right = place < ramps.p.size();
  if (point == 0) return has_left && ends.holdsP(place - 1);
  if (point == last) return has_right && ends.holdsQ(place);
  const bool begins = point == 1 && has_left && ends.holdsQ(place - 1);
  const bool ends_core = (triangle || point == 2) && has_right && ends.holdsP(place);
  return begins || ends_core;
}

}  // namespace

const LockedVertex* lockedVertexOf(const ForceModel& model, const PullEdit& edit,
                                   std::span<const LockedVertex> locked) {
  if (editsRule(edit.gesture)) return nullptr;
  std::optional<Ramps> ramps;
  for (const LockedVertex& one : locked) {
    if (!(one.list == edit.list)) continue;
    const std::vector<Term>& terms = termsOf(model, edit.list);
    if (edit.gesture == Gesture::kVertex) {
      if (terms[edit.place].id == one.term && edit.vertex == one.point) return &one;
      continue;
    }
    if (!ramps) ramps = rampsOf(variableAt(model, edit.list.variable), terms);
    for (std::size_t place = 0; place < ramps->order.size(); ++place) {
      const Term& term = terms[ramps->order[place]];
      if (term.id == one.term && isMoved(movedEnds(edit), *ramps, term, place, one.point)) return &one;
    }
  }
  return nullptr;
}

ForceModel applied(ForceModel model, const PullEdit& edit) {
  if (editsRule(edit.gesture)) {
    fuzzy::Rule& rule = model.experts[expertIndex(model, edit.expert)].rules[edit.rule];
    if (edit.gesture == Gesture::kWord) rule.then = edit.then;
    if (edit.gesture == Gesture::kOff) rule.enabled = false;
    if (edit.gesture == Gesture::kWeight) rule.weight = std::clamp(rule.weight + edit.delta, 0.0, 1.0);
    return model;
  }
  std::vector<Term>& terms = changeableTerms(model, edit.list);
  if (edit.gesture == Gesture::kVertex) {
    terms[edit.place].points[edit.vertex] += edit.delta;
    return model;
  }
  const auto before = rampsOf(variableAt(model, edit.list.variable), terms);
  TACTUS_CHECK(before);
  writeRamps(*before, moved(*before, edit.gesture, edit.place, edit.delta), terms);
  return model;
}

}  // namespace tactus::analysis
