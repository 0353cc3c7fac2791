#include "core/analysis/pull/pull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/analysis/pull/gesture_search.h"
#include "core/analysis/pull/plausible.h"
#include "core/analysis/pull/point_force.h"
#include "core/analysis/pull/pull_blocker.h"
#include "core/analysis/pull/rule_search.h"
#include "core/base/text.h"

namespace tactus::analysis {
namespace {

using base::ErrorCode;
using base::fail;
using fuzzy::ForceModel;
using Kind = PullBlocker::Kind;

constexpr double kSameTarget = 1e-9;  // N, of the range of the output: rounding of a delta
constexpr double kNearShare = 0.5;    // of a noticeable difference
constexpr double kWorthTheWay = 0.2;  // of the distance: a near edit goes at least so far

base::Result<void> checkQuestion(const ForceModel& model, std::span<const double> point, double target_n) {
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
  if (!std::isfinite(target_n)) {
    return fail(ErrorCode::kValue, model.output.id, base::formatNumber(target_n), "a finite force");
  }
  return {};
}

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
        curve_input_(curveInput(model, settings.curve_input)),
        point_(model, place_),
        elsewhere_(model, compiled_, place_, curve_input_, settings.box_points, noticeable) {}

  Pull answer() {
    Pull out;
    out.before_n = point_.now();
    out.target_n = target_n_;
    if (!out.before_n) {
      out.blocker = PullBlocker{};
      return out;
    }
    now_n_ = *out.before_n;
    if (std::abs(target_n_ - now_n_) <= same()) {
      out.reachable = ForceInterval{now_n_, now_n_};
      search();
      out.reachable = interval();
      return out;
    }
    search();
    for (const SearchedGesture& one : gestures_) {
      if (one.reach.exact && *one.reach.exact != 0) add(out, one.edit, *one.reach.exact);
    }
    for (const SearchedRule& one : rules_) {
      if (isNear(one.force_n)) add(out, one.edit, one.edit.delta);
    }
    if (out.candidates.empty()) nearest(out);
    out.reachable = interval();
    for (const PullCandidate& one : out.candidates) {
      out.reachable->min_n = std::min(out.reachable->min_n, one.force_n);
      out.reachable->max_n = std::max(out.reachable->max_n, one.force_n);
    }
    std::stable_sort(out.candidates.begin(), out.candidates.end(), better);
    return out;
  }

 private:
  double same() const { return kSameTarget * (model_.output.max - model_.output.min); }

  bool isNear(double force_n) const {
    const double off = std::abs(force_n - target_n_);
    return off <= near_n_ && off <= (1 - kWorthTheWay) * std::abs(now_n_ - target_n_);
  }

  static bool better(const PullCandidate& one, const PullCandidate& other) {
    if (one.folded != other.folded) return other.folded;
    if (one.exact != other.exact) return one.exact;
    return one.elsewhere.k < other.elsewhere.k;
  }

  void search() {
    for (const PulledList& list : listsOf(model_, model_.experts.size() > 1)) {
      if (std::find(settings_.locked.begin(), settings_.locked.end(), list.variable) != settings_.locked.end())
        continue;
      auto found = searchList(point_, list, target_n_);
      gestures_.insert(gestures_.end(), found.begin(), found.end());
    }
    if (model_.experts.size() == 1) rules_ = searchRules(point_, 0, target_n_);
  }

  ForceInterval interval() const {
    ForceInterval out{now_n_, now_n_};
    const auto take = [&](double force_n) {
      out.min_n = std::min(out.min_n, force_n);
      out.max_n = std::max(out.max_n, force_n);
    };
    for (const SearchedGesture& one : gestures_) {
      if (!one.reach.nearest) continue;
      take(one.reach.min_n);
      take(one.reach.max_n);
    }
    for (const SearchedRule& one : rules_) take(one.force_n);
    return out;
  }

  /// Adds the candidate unless it opens a hole or is no valid model.
  bool add(Pull& out, PullEdit edit, double delta) const {
    edit.delta = delta;
    const ForceModel after = applied(model_, edit);
    const auto compiled = fuzzy::compile(after);
    if (!compiled) return false;
    const auto force = compiled->evaluate(place_);
    PullCandidate one{{std::move(edit)}, PullKind::kRule, force.force_n, elsewhere_.of(*compiled)};
    if (!force.fired || one.elsewhere.opens_hole) return false;
    one.kind = kindOf(model_, one.edits[0], curve_input_);
    one.exact = std::abs(one.force_n - target_n_) <= same();
    one.folded = !isPlausible(model_, after, one.edits[0]);
    out.candidates.push_back(std::move(one));
    return true;
  }

  /// Nothing comes near: the nearest gesture, the nearest edit of a rule, and what stops the better of them.
  void nearest(Pull& out) const {
    const auto off = [&](double force_n) { return std::abs(force_n - target_n_); };
    std::vector<const SearchedGesture*> gestures;
    for (const SearchedGesture& one : gestures_) {
      if (one.reach.nearest && off(one.reach.nearest->force_n) < off(now_n_)) gestures.push_back(&one);
    }
    std::stable_sort(gestures.begin(), gestures.end(), [&](const auto* one, const auto* other) {
      return off(one->reach.nearest->force_n) < off(other->reach.nearest->force_n);
    });
    const auto gesture = std::find_if(gestures.begin(), gestures.end(), [&](const SearchedGesture* one) {
      return add(out, one->edit, one->reach.nearest->at);
    });
    std::vector<SearchedRule> rules = rules_;
    std::stable_sort(rules.begin(), rules.end(),
                     [&](const auto& one, const auto& other) { return off(one.force_n) < off(other.force_n); });
    const auto rule = std::find_if(rules.begin(), rules.end(), [&](const SearchedRule& one) {
      return off(one.force_n) < off(now_n_) && add(out, one.edit, one.edit.delta);
    });
    const bool words_locked =
        std::find(settings_.locked.begin(), settings_.locked.end(), model_.inputs.size()) != settings_.locked.end();
    if (words_locked) out.blocker = centroidLimit(point_, target_n_);
    if (out.blocker) return;
    if (rule != rules.end() &&
        (gesture == gestures.end() || off(rule->force_n) < off((*gesture)->reach.nearest->force_n))) {
      out.blocker = PullBlocker{Kind::kRules, 0, {}, rule->force_n};
    } else if (gesture != gestures.end()) {
      out.blocker = whereItStops(model_, **gesture);
    } else {
      out.blocker = PullBlocker{Kind::kTurn, curve_input_, {}, now_n_};
    }
  }

  const ForceModel& model_;
  fuzzy::CompiledModel compiled_;
  std::vector<double> place_;
  double target_n_;
  double near_n_;
  const PullSettings& settings_;
  std::size_t curve_input_;
  PointForce point_;
  ElsewhereProbe elsewhere_;
  double now_n_ = 0;
  std::vector<SearchedGesture> gestures_;
  std::vector<SearchedRule> rules_;
};

/// The variable that has to be unlocked for an edit that gives the target.
std::optional<std::size_t> helpfulUnlock(const Pull& unlocked, const PullSettings& settings, std::size_t output) {
  for (const PullCandidate& one : unlocked.candidates) {
    if (one.folded || !one.exact || editsRule(one.edits[0].gesture)) continue;
    const std::size_t variable = one.edits[0].list.variable;
    if (variable > output) continue;
    if (std::find(settings.locked.begin(), settings.locked.end(), variable) != settings.locked.end()) return variable;
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

base::Result<Pull> pull(const ForceModel& model, std::span<const double> point, double target_n,
                        const NoticeableDifference& noticeable, const PullSettings& settings) {
  if (auto ok = checkQuestion(model, point, target_n); !ok) return tl::unexpected(ok.error());
  const ForceModel pulled = modelOf(model, settings.expert);
  auto compiled = fuzzy::compile(pulled);
  if (!compiled) return tl::unexpected(compiled.error());
  const std::vector<double> place(point.begin(), point.end());
  Pull out = Puller(pulled, *compiled, place, target_n, noticeable, settings).answer();
  if (!out.blocker || out.blocker->kind == Kind::kNoRule || out.blocker->kind == Kind::kCentroid) return out;
  if (settings.locked.empty()) return out;
  PullSettings free = settings;
  free.locked.clear();
  const Pull unlocked = Puller(pulled, *compiled, place, target_n, noticeable, free).answer();
  if (const auto variable = helpfulUnlock(unlocked, settings, model.inputs.size())) {
    out.blocker = PullBlocker{Kind::kLock, *variable, {}, out.blocker->limit_n};
  }
  return out;
}

}  // namespace tactus::analysis
