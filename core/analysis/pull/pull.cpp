#include "core/analysis/pull/pull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/analysis/pull/candidate_judge.h"
#include "core/analysis/pull/force_search.h"
#include "core/analysis/pull/point_force.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::analysis {
namespace {

// Why no single edit gives a wanted force (PullBlocker).

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
    case Gesture::kBegin: return at_high ? no_ramp : below(gesture, terms, ramps, place);
    case Gesture::kEnd: return at_high ? above(gesture, terms, ramps, place) : no_ramp;
    case Gesture::kShift: return at_high ? above(gesture, terms, ramps, place) : below(gesture, terms, ramps, place);
    case Gesture::kWidth: return at_high ? wider(place) : no_ramp;
    case Gesture::kMove: return at_high ? above(gesture, terms, ramps, place) : below(gesture, terms, ramps, place - 1);
    case Gesture::kWiden:
      return at_high ? wider(place - 1) : PullBlocker{Kind::kOrder, gesture.edit.list.variable, own, 0};
    default: return {Kind::kTurn, gesture.edit.list.variable, own, 0};
  }
}

/// The word whose centroid is the limit: no strength of any word of the experts gives a centroid on the target's side
/// of all. Holds while the output terms stay as they are.
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

/// What stops the gesture at the delta that comes nearest to the target.
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

/// All edits at a point: the gestures of all lists that are not locked, and the edits of rules.
struct PointSearch {
  std::vector<SearchedGesture> gestures;
  std::vector<SearchedRule> rules;  ///< of a model of one expert

  /// The gesture that comes nearest to the target, and the rule.
  const SearchedGesture* nearestGesture(double target_n) const;
  const SearchedRule* nearestRule(double target_n) const;
};

const SearchedGesture* PointSearch::nearestGesture(double target_n) const {
  const SearchedGesture* nearest = nullptr;
  for (const SearchedGesture& one : gestures) {
    if (!one.reach.nearest) continue;
    const double off = std::abs(one.reach.nearest->force_n - target_n);
    if (nearest == nullptr || off < std::abs(nearest->reach.nearest->force_n - target_n)) nearest = &one;
  }
  return nearest;
}

const SearchedRule* PointSearch::nearestRule(double target_n) const {
  const auto nearest = std::min_element(rules.begin(), rules.end(), [&](const auto& one, const auto& other) {
    return std::abs(one.force_n - target_n) < std::abs(other.force_n - target_n);
  });
  return nearest == rules.end() ? nullptr : &*nearest;
}

PointSearch searchPoint(const PointForce& point, double target_n, const PullSettings& settings) {
  PointSearch out;
  const bool alone = point.model().experts.size() == 1;
  for (const PulledList& list : listsOf(point.model(), !alone)) {
    if (std::find(settings.locked.begin(), settings.locked.end(), list.variable) != settings.locked.end()) continue;
    auto found = searchList(point, list, target_n);
    std::erase_if(found, [&](const SearchedGesture& one) { return isLocked(point.model(), one.edit, settings); });
    out.gestures.insert(out.gestures.end(), found.begin(), found.end());
  }
  if (alone && !settings.lock_rules) out.rules = searchRules(point, 0, target_n);
  return out;
}

/// Pairs of edits that give the target: `first`, and after it one edit more.
std::vector<std::vector<PullEdit>> pairsWith(const PullEdit& first, const fuzzy::ForceModel& model,
                                             std::span<const double> point, double target_n,
                                             const PullSettings& settings) {
  const fuzzy::ForceModel after = applied(model, first);
  const PointForce there(after, point);
  std::vector<std::vector<PullEdit>> out;
  if (!there.now()) return out;
  for (SearchedGesture& one : searchPoint(there, target_n, settings).gestures) {
    if (!one.reach.exact || *one.reach.exact == 0) continue;
    one.edit.delta = *one.reach.exact;
    out.push_back({first, one.edit});
  }
  return out;
}

using base::ErrorCode;
using base::fail;
using fuzzy::ForceModel;
using Kind = PullBlocker::Kind;

constexpr double kNearShare = 0.5;  // of a noticeable difference
constexpr std::size_t kMostPairs = 3;
constexpr double kWorthTheWay = 0.2;  // of the distance: a near edit goes at least so far

/// One pull: the search at the point and the judgement of what it finds.
class Puller {
 public:
  Puller(const ForceModel& model, fuzzy::CompiledModel compiled, std::vector<double> point, double target_n,
         const NoticeableDifference& noticeable, const PullSettings& settings)
      : model_(model),
        compiled_(std::move(compiled)),
        place_(std::move(point)),
        target_n_(target_n),
        near_n_(kNearShare * noticeable(std::abs(target_n))),
        settings_(settings),
        point_(model, place_),
        judge_(model, compiled_, place_, noticeable, settings) {}

  Pull answer() {
    Pull out;
    out.before_n = point_.now();
    out.target_n = target_n_;
    if (!out.before_n) {
      out.blocker = PullBlocker{};
      return out;
    }
    now_n_ = *out.before_n;
    if (std::abs(target_n_ - now_n_) <= judge_.same()) {
      found_ = searchPoint(point_, target_n_, settings_);
      out.reachable = interval(out);
      return out;
    }
    found_ = searchPoint(point_, target_n_, settings_);
    for (const SearchedGesture& one : found_.gestures) {
      if (one.reach.exact && *one.reach.exact != 0) add(out, one.edit, *one.reach.exact);
    }
    const bool any_exact = !out.candidates.empty();
    for (const SearchedRule& one : found_.rules) {
      const bool exact = std::abs(one.force_n - target_n_) <= judge_.same();
      if (exact || isNear(one.force_n)) add(out, one.edit, one.edit.delta);
    }
    const bool none = out.candidates.empty();
    if (!any_exact) addPairs(out);
    if (none) addNearest(out);
    out.reachable = interval(out);
    std::stable_sort(out.candidates.begin(), out.candidates.end(), better);
    return out;
  }

 private:
  bool isNear(double force_n) const {
    const double off = std::abs(force_n - target_n_);
    return off <= near_n_ && off <= (1 - kWorthTheWay) * std::abs(now_n_ - target_n_);
  }

  static bool better(const PullCandidate& one, const PullCandidate& other) {
    if (one.folded != other.folded) return other.folded;
    if (one.exact != other.exact) return one.exact;
    return one.elsewhere.k < other.elsewhere.k;
  }

  ForceInterval interval(const Pull& pull) const {
    ForceInterval out{now_n_, now_n_};
    const auto take = [&](double force_n) {
      out.min_n = std::min(out.min_n, force_n);
      out.max_n = std::max(out.max_n, force_n);
    };
    for (const SearchedGesture& one : found_.gestures) {
      if (!one.reach.nearest) continue;
      take(one.reach.min_n);
      take(one.reach.max_n);
    }
    for (const SearchedRule& one : found_.rules) take(one.force_n);
    for (const PullCandidate& one : pull.candidates) take(one.force_n);
    return out;
  }

  /// Adds the candidate unless it opens a hole or is no valid model.
  bool add(Pull& out, PullEdit edit, double delta) const {
    edit.delta = delta;
    auto one = judge_.judged({std::move(edit)}, target_n_);
    if (one) out.candidates.push_back(std::move(*one));
    return one.has_value();
  }

  /// Two edits where one is not enough: the gesture that comes nearest, and one edit more; the best few.
  void addPairs(Pull& out) const {
    const SearchedGesture* const nearest = found_.nearestGesture(target_n_);
    if (nearest == nullptr || nearest->reach.nearest->at == 0) return;
    PullEdit first = nearest->edit;
    first.delta = nearest->reach.nearest->at;
    std::vector<PullCandidate> pairs;
    for (auto& edits : pairsWith(first, model_, place_, target_n_, settings_)) {
      if (auto one = judge_.judged(std::move(edits), target_n_); one && one->exact) pairs.push_back(std::move(*one));
    }
    std::stable_sort(pairs.begin(), pairs.end(), better);
    pairs.resize(std::min(pairs.size(), kMostPairs));
    out.candidates.insert(out.candidates.end(), pairs.begin(), pairs.end());
  }

  /// No single edit comes near: the nearest gesture, the nearest edit of a rule, and what stops the better of them,
  /// unless two edits do it.
  void addNearest(Pull& out) const {
    const bool pairs = !out.candidates.empty();
    const auto off = [&](double force_n) { return std::abs(force_n - target_n_); };
    const auto* gesture = found_.nearestGesture(target_n_);
    if (gesture != nullptr &&
        !(off(gesture->reach.nearest->force_n) < off(now_n_) && add(out, gesture->edit, gesture->reach.nearest->at))) {
      gesture = nullptr;
    }
    const auto* rule = found_.nearestRule(target_n_);
    if (rule != nullptr && !(off(rule->force_n) < off(now_n_) && add(out, rule->edit, rule->edit.delta)))
      rule = nullptr;
    if (pairs) return;
    const bool words_locked =
        std::find(settings_.locked.begin(), settings_.locked.end(), model_.inputs.size()) != settings_.locked.end();
    if (words_locked) out.blocker = centroidLimit(point_, target_n_);
    if (out.blocker) return;
    const double gesture_off = gesture != nullptr ? off(gesture->reach.nearest->force_n) : off(now_n_);
    if (rule != nullptr && off(rule->force_n) < gesture_off) {
      out.blocker = PullBlocker{Kind::kRules, 0, {}, rule->force_n};
    } else if (gesture != nullptr) {
      out.blocker = whereItStops(model_, *gesture);
    } else {
      out.blocker = PullBlocker{Kind::kTurn, judge_.curveInput(), {}, now_n_};
    }
  }

  const ForceModel& model_;
  fuzzy::CompiledModel compiled_;
  std::vector<double> place_;
  double target_n_;
  double near_n_;
  const PullSettings& settings_;
  PointForce point_;
  CandidateJudge judge_;
  double now_n_ = 0;
  PointSearch found_;
};

/// The variable that has to be unlocked for an edit that gives the target; one above the output's for the rules.
std::optional<std::size_t> helpfulUnlock(const Pull& unlocked, const PullSettings& settings, const ForceModel& model) {
  const std::size_t output = model.inputs.size();
  for (const PullCandidate& one : unlocked.candidates) {
    if (one.folded) continue;
    if (editsRule(one.edits[0].gesture)) {
      if (settings.lock_rules) return output + 1;
      continue;
    }
    if (one.exact && isLocked(model, one.edits[0], settings)) return one.edits[0].list.variable;
  }
  return std::nullopt;
}

}  // namespace

std::string_view name(PullKind kind) noexcept {
  constexpr std::array<std::string_view, 4> kNames = {"place", "condition", "force_word", "rule"};
  return kNames[static_cast<std::size_t>(kind)];
}

ForceModel applied(ForceModel model, std::span<const PullEdit> edits) {
  for (const PullEdit& edit : edits) model = applied(std::move(model), edit);
  return model;
}

bool isLocked(const ForceModel& model, const PullEdit& edit, const PullSettings& settings) {
  if (editsRule(edit.gesture)) return settings.lock_rules;
  return std::find(settings.locked.begin(), settings.locked.end(), edit.list.variable) != settings.locked.end() ||
         lockedVertexOf(model, edit, settings.locked_vertices) != nullptr;
}

base::Result<void> checkPoint(const ForceModel& model, std::span<const double> point) {
  if (point.size() != model.inputs.size()) {
    return fail(ErrorCode::kValue, "", std::to_string(point.size()) + " input values",
                std::to_string(model.inputs.size()) + ", one per input");
  }
  for (std::size_t i = 0; i < point.size(); ++i) {
    const fuzzy::Variable& input = model.inputs[i];
    if (point[i] >= input.min && point[i] <= input.max) continue;
    return fail(ErrorCode::kValue, input.id, base::formatNumber(point[i]),
                "a value from " + base::formatNumber(input.min) + " to " + base::formatNumber(input.max));
  }
  return {};
}

base::Result<void> checkPins(const fuzzy::CompiledModel& compiled, const ForceModel& model,
                             std::span<const std::vector<double>> pins) {
  for (const std::vector<double>& pin : pins) {
    if (auto ok = checkPoint(model, pin); !ok) {
      ok.error().place = ok.error().place.empty() ? "pin" : "pin " + ok.error().place;
      return ok;
    }
    if (!compiled.evaluate(pin).fired) {
      return fail(ErrorCode::kValue, "pin", "a point at which no rule fires", "a point with a force to keep");
    }
  }
  return {};
}

base::Result<Pull> pull(const ForceModel& model, std::span<const double> point, double target_n,
                        const NoticeableDifference& noticeable, const PullSettings& settings) {
  if (auto ok = checkPoint(model, point); !ok) return tl::unexpected(ok.error());
  if (!std::isfinite(target_n)) {
    return fail(ErrorCode::kValue, model.output.id, base::formatNumber(target_n), "a finite force");
  }
  const ForceModel pulled = modelOf(model, settings.expert);
  TACTUS_TRY(auto compiled, fuzzy::compile(pulled));
  const std::vector<double> place(point.begin(), point.end());
  if (auto ok = checkPins(compiled, model, settings.pins); !ok) return tl::unexpected(ok.error());
  Pull out = Puller(pulled, compiled, place, target_n, noticeable, settings).answer();
  if (!out.blocker || out.blocker->kind == Kind::kNoRule || out.blocker->kind == Kind::kCentroid) return out;
  PullSettings free = settings;
  if (!settings.pins.empty()) {
    free.pins.clear();
    if (!Puller(pulled, compiled, place, target_n, noticeable, free).answer().blocker) {
      out.blocker = PullBlocker{Kind::kPin, 0, {}, out.blocker->limit_n};
      return out;
    }
  }
  if (settings.locked.empty() && settings.locked_vertices.empty() && !settings.lock_rules) return out;
  free.locked.clear();
  free.locked_vertices.clear();
  free.lock_rules = false;
  const Pull unlocked = Puller(pulled, compiled, place, target_n, noticeable, free).answer();
  if (const auto variable = helpfulUnlock(unlocked, settings, pulled)) {
    out.blocker = PullBlocker{Kind::kLock, *variable, {}, out.blocker->limit_n};
  }
  return out;
}

}  // namespace tactus::analysis
