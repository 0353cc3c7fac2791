#include "core/analysis/finding_place.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/base/text.h"

namespace tactus::analysis {
namespace {

struct InWords {
  const fuzzy::ForceModel& model;

  std::string operator()(const ConditionPlace& place) const {
    return place.conditions.empty() ? "everywhere" : describe(place.conditions);
  }
  std::string operator()(const Hole& hole) const { return describe(hole, model); }
  std::string operator()(const TermPlace& place) const {
    return variableAt(model, place.variable).id + ' ' + place.term;
  }
  std::string operator()(const StepPlace& place) const {
    TACTUS_CHECK(place.expert < model.experts.size());
    return describe(place.step, model, model.experts[place.expert]);
  }
  std::string operator()(const InputPlace& place) const { return variableAt(model, place.input).id; }
  std::string operator()(const CliffPlace& place) const {
    const auto& input = variableAt(model, place.input);
    // To a millionth of the universe: the two sides of an edge are one place.
    const double step = std::pow(10, std::floor(std::log10((input.max - input.min) * 1e-6)));
    const auto rounded = [step](double x) {
      return base::formatNumber(step < 1 ? std::round(x / step) / std::round(1 / step) : std::round(x / step) * step);
    };
    std::string text = input.id + ' ' + rounded(place.low);
    if (rounded(place.high) != rounded(place.low)) text += " to " + rounded(place.high);
    return input.unit == "1" ? text : text + ' ' + input.unit;
  }
};

}  // namespace

const fuzzy::Variable& variableAt(const fuzzy::ForceModel& model, std::size_t variable) {
  TACTUS_CHECK(variable <= model.inputs.size());
  return variable < model.inputs.size() ? model.inputs[variable] : model.output;
}

std::string describe(const FindingPlace& place, const fuzzy::ForceModel& model) {
  return std::visit(InWords{model}, place);
}

std::optional<std::size_t> inputOf(const FindingPlace& place, const fuzzy::ForceModel& model) {
  const auto known = [&model](std::size_t input) {
    return input < model.inputs.size() ? std::optional(input) : std::nullopt;
  };
  if (const auto* const term = std::get_if<TermPlace>(&place)) return known(term->variable);
  if (const auto* const step = std::get_if<StepPlace>(&place)) return known(step->step.input);
  if (const auto* const cliff = std::get_if<CliffPlace>(&place)) return known(cliff->input);
  if (const auto* const whole = std::get_if<InputPlace>(&place)) return known(whole->input);
  if (const auto* const where = std::get_if<ConditionPlace>(&place)) {
    // The one that is named first.
    const auto first = std::min_element(where->conditions.begin(), where->conditions.end(),
                                        [](const auto& x, const auto& y) { return x.input < y.input; });
    for (std::size_t i = 0; i < model.inputs.size() && first != where->conditions.end(); ++i) {
      if (model.inputs[i].id == first->input) return i;
    }
  }
  if (const auto* const hole = std::get_if<Hole>(&place)) {
    // Of the inputs that bound it the one that is named first.
    for (std::size_t i = 0; i < hole->ranges.size(); ++i) {
      if (!hole->ranges[i].whole_universe) return known(i);
    }
  }
  return std::nullopt;
}

const fuzzy::Term* termAt(const FindingPlace& place, const fuzzy::ForceModel& model, const fuzzy::Expert& expert) {
  const auto* const at = std::get_if<TermPlace>(&place);
  if (at == nullptr || at->variable > model.inputs.size()) return nullptr;
  return findTerm(termsFor(expert, variableAt(model, at->variable)), at->term);
}

}  // namespace tactus::analysis
