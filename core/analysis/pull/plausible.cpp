#include "core/analysis/pull/plausible.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/pull/ramps.h"
#include "core/analysis/pull/rule_search.h"
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
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (model.inputs[i].id == "depth") return i;
  }
  return model.inputs.size() - 1;
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

}  // namespace tactus::analysis
