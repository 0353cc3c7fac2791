#include "core/fuzzy/force_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/text.h"

namespace tactus::fuzzy {

std::string_view name(Shape shape) noexcept {
  switch (shape) {
    case Shape::kTrapezoid: return "trapezoid";
    case Shape::kTriangle: return "triangle";
    case Shape::kGaussian: return "gaussian";
  }
  return "";
}

std::string_view name(Role role) noexcept {
  switch (role) {
    case Role::kCondition: return "condition";
    case Role::kWay: return "way";
    case Role::kRate: return "rate";
    case Role::kUnsaid: break;
  }
  return "";
}

std::string_view name(Implication implication) noexcept { return implication == Implication::kClip ? "clip" : "scale"; }

std::string_view name(Contract::Kind kind) noexcept {
  switch (kind) {
    case Contract::Kind::kNeverRaises: return "never_raises";
    case Contract::Kind::kNeverLowers: return "never_lowers";
    case Contract::Kind::kNeverHarder: return "never_harder";
    case Contract::Kind::kNoStep: return "no_step";
    case Contract::Kind::kNeverAbove: return "never_above";
    case Contract::Kind::kNeverBelow: return "never_below";
    case Contract::Kind::kNeverSilent: return "never_silent";
  }
  return "";
}

ContractMembers membersOf(Contract::Kind kind) noexcept {
  switch (kind) {
    case Contract::Kind::kNeverRaises:
    case Contract::Kind::kNeverLowers: return {.input = true};
    case Contract::Kind::kNeverHarder: return {.input = true, .words = true};
    case Contract::Kind::kNoStep: return {.input = true, .within = true, .limit = true};
    case Contract::Kind::kNeverAbove:
    case Contract::Kind::kNeverBelow: return {.limit = true};
    case Contract::Kind::kNeverSilent: break;
  }
  return {};
}

std::size_t pointCount(Shape shape) noexcept {
  switch (shape) {
    case Shape::kTrapezoid: return 4;
    case Shape::kTriangle: return 3;
    case Shape::kGaussian: return 2;
  }
  return 0;
}

Role roleOf(const Variable& input) noexcept {
  if (input.role != Role::kUnsaid) return input.role;
  return input.id == "depth" ? Role::kWay : input.id == "speed" ? Role::kRate : Role::kCondition;
}

namespace {

std::optional<std::size_t> inputOf(std::span<const Variable> inputs, Role role) noexcept {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (roleOf(inputs[i]) == role) return i;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::size_t> wayOf(std::span<const Variable> inputs) noexcept { return inputOf(inputs, Role::kWay); }
std::optional<std::size_t> rateOf(std::span<const Variable> inputs) noexcept { return inputOf(inputs, Role::kRate); }

const Term* findTerm(const std::vector<Term>& terms, std::string_view id) noexcept {
  const auto it = std::find_if(terms.begin(), terms.end(), [id](const Term& term) { return term.id == id; });
  return it == terms.end() ? nullptr : &*it;
}

double endOfCore(const Variable& way, const Term& term) noexcept {
  const double end = term.points[term.shape == Shape::kTrapezoid ? 2 : term.shape == Shape::kTriangle ? 1 : 0];
  return std::clamp(end, way.min, way.max);
}

std::string eventText(const Variable& way, const TubeEvent& event) {
  const Term* const term = findTerm(way.terms, event.term);
  const bool labelled = term != nullptr && !term->label.empty();
  return base::lowered(labelled ? term->label : event.term) + ", " + base::roundedNumber(event.share * 100) +
         " % of the force is lost";
}

std::vector<std::string> eventTexts(const ForceModel& model) {
  std::vector<std::string> out;
  for (const TubeEvent& event : model.events)
    out.push_back(eventText(model.inputs[wayOf(model.inputs).value()], event));
  return out;
}

void eraseLostEvents(ForceModel& model) {
  const auto way = wayOf(model.inputs);
  std::erase_if(model.events, [&](const TubeEvent& event) {
    return !way || findTerm(model.inputs[*way].terms, event.term) == nullptr;
  });
}

const std::vector<Term>& termsFor(const Expert& expert, const Variable& variable) noexcept {
  for (const auto& own : expert.overrides) {
    if (own.variable == variable.id) return own.terms;
  }
  return variable.terms;
}

std::vector<double> normalizedWeights(std::span<const double> weights) {
  constexpr int kLargestGap = 72;  // bits: 53 of a double and more than enough for as many experts as a model may have
  std::vector<double> out(weights.begin(), weights.end());
  std::vector<double*> falling;
  for (double& weight : out) {
    if (weight > 0) falling.push_back(&weight);
  }
  std::sort(falling.begin(), falling.end(), [](const double* a, const double* b) { return *a > *b; });
  int shift = falling.empty() ? 0 : -std::ilogb(*falling.front());
  int before = -shift;
  for (double* const weight : falling) {
    const int exponent = std::ilogb(*weight);
    shift += std::max(0, before - exponent - kLargestGap);
    before = exponent;
    *weight = std::max(std::scalbn(*weight, shift), std::numeric_limits<double>::denorm_min());
  }
  return out;
}

std::vector<double> normalizedWeights(const ForceModel& model) {
  std::vector<double> weights;
  weights.reserve(model.experts.size());
  for (const Expert& expert : model.experts) weights.push_back(expert.weight);
  return normalizedWeights(weights);
}

}  // namespace tactus::fuzzy
