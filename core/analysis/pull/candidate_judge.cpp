#include "core/analysis/pull/candidate_judge.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/analysis/coverage.h"
#include "core/analysis/pull/force_search.h"
#include "core/analysis/pull/pull_edit.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {
namespace {

using fuzzy::ForceModel;

constexpr double kPlausibleWords = 1;
constexpr double kSigmasAtHalfHeight = 2.3548200450309493;  // 2 sqrt(2 ln 2)

/// The width at half height, within the universe.
double widthOf(const fuzzy::Variable& variable, const fuzzy::Term& term) {
  const auto f = fuzzy::MembershipFunction::of(term);
  if (f.gaussian) return std::min(kSigmasAtHalfHeight * f.sigma, variable.max - variable.min);
  return std::min((f.c + f.d) / 2, variable.max) - std::max((f.a + f.b) / 2, variable.min);
}

/// The width of the widest word that the gesture is about.
double widthOfWords(const ForceModel& model, const PullEdit& edit) {
  const auto& terms = termsOf(model, edit.list);
  const fuzzy::Variable& variable = variableAt(model, edit.list.variable);
  if (edit.gesture == Gesture::kVertex) return widthOf(variable, terms[edit.place]);
  const auto ramps = rampsOf(variable, terms);
  const double own = widthOf(variable, terms[ramps->order[edit.place]]);
  if (edit.gesture == Gesture::kMove || edit.gesture == Gesture::kWiden) return own;
  return std::max(own, widthOf(variable, terms[ramps->order[edit.place + 1]]));
}

}  // namespace

ForceModel modelOf(const ForceModel& model, std::optional<std::size_t> expert) {
  ForceModel out = model;
  if (expert) {
    out.experts = {model.experts[*expert]};
    out.experts[0].weight = 1;
  } else {
    std::erase_if(out.experts, [](const fuzzy::Expert& one) { return one.weight == 0; });
  }
  return out;
}

std::size_t curveInput(const ForceModel& model, std::optional<std::size_t> asked) {
  if (asked) return *asked;
  return fuzzy::wayOf(model.inputs).value_or(model.inputs.size() - 1);
}

PullKind kindOf(const ForceModel& model, const PullEdit& edit, std::size_t curve_input) {
  if (editsRule(edit.gesture)) return PullKind::kRule;
  if (edit.list.variable == model.inputs.size()) return PullKind::kForceWord;
  return edit.list.variable == curve_input ? PullKind::kPlace : PullKind::kCondition;
}

bool isPlausible(const ForceModel& model, const ForceModel& after, const PullEdit& edit) {
  if (editsRule(edit.gesture)) {
    if (edit.gesture != Gesture::kWord) return true;
    const std::size_t expert = expertIndex(model, edit.expert);
    return std::abs(edit.delta) <= kPlausibleWords &&
           stepsAgainstDirection(after, expert) <= stepsAgainstDirection(model, expert);
  }
  return edit.list.variable < model.inputs.size() || std::abs(edit.delta) <= widthOfWords(model, edit) / 2;
}

namespace {

constexpr double kSameTarget = 1e-9;   // of the range of the output
constexpr double kPinnedShare = 0.25;  // of a noticeable difference
constexpr double kSameVolume = 1e-12;  // of the input space: rounding of a sum of boxes

/// The share of the input space in which no rule fires. Sides without width count as nothing.
double uncovered(const fuzzy::ForceModel& model) {
  std::vector<std::size_t> experts(model.experts.size());
  std::iota(experts.begin(), experts.end(), std::size_t{0});
  double sum = 0;
  for (const Hole& hole : coverage(model, experts).holes) {
    double share = 1;
    for (std::size_t i = 0; i < hole.ranges.size(); ++i) {
      share *= (hole.ranges[i].high - hole.ranges[i].low) / (model.inputs[i].max - model.inputs[i].min);
    }
    sum += share;
  }
  return sum;
}

/// Whether the edit may take something away from the conditions of the rules.
bool mayOpenAHole(const PullEdit& edit) { return edit.gesture == Gesture::kOff || edit.gesture == Gesture::kVertex; }

}  // namespace

CandidateJudge::CandidateJudge(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                               const std::vector<double>& point, const NoticeableDifference& noticeable,
                               const PullSettings& settings)
    : model_(model),
      point_(point),
      curve_input_(analysis::curveInput(model, settings.curve_input)),
      elsewhere_(model, compiled, point, curve_input_, settings.box_points, noticeable) {
  for (const std::vector<double>& pin : settings.pins) {
    const double force_n = compiled.evaluate(pin).force_n;
    pins_.push_back({pin, force_n, kPinnedShare * noticeable(std::abs(force_n))});
  }
}

bool CandidateJudge::holdsPins(const fuzzy::CompiledModel& after) const {
  return std::all_of(pins_.begin(), pins_.end(), [&](const Pin& pin) {
    const auto force = after.evaluate(pin.point);
    return force.fired && std::abs(force.force_n - pin.force_n) <= pin.allowed_n;
  });
}

double CandidateJudge::same() const noexcept { return kSameTarget * (model_.output.max - model_.output.min); }

std::optional<PullCandidate> CandidateJudge::judged(std::vector<PullEdit> edits, std::optional<double> target_n) const {
  PullCandidate out;
  fuzzy::ForceModel after = model_;
  for (const PullEdit& edit : edits) {
    fuzzy::ForceModel next = applied(after, edit);
    out.folded = out.folded || !isPlausible(after, next, edit);
    after = std::move(next);
  }
  const auto compiled = fuzzy::compile(after);
  if (!compiled) return std::nullopt;
  const auto force = compiled->evaluate(point_);
  out.elsewhere = elsewhere_.of(*compiled);
  if (!force.fired || out.elsewhere.opens_hole || !holdsPins(*compiled)) return std::nullopt;
  if (std::any_of(edits.begin(), edits.end(), mayOpenAHole) && uncovered(after) > uncovered(model_) + kSameVolume) {
    return std::nullopt;  // between the points
  }
  out.kind = kindOf(model_, edits[0], curve_input_);
  out.force_n = force.force_n;
  out.exact = target_n && std::abs(force.force_n - *target_n) <= same();
  out.edits = std::move(edits);
  return out;
}

}  // namespace tactus::analysis
