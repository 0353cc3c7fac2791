#include "tests/bench/finite_differences.h"

#include <algorithm>
#include <array>

#include "core/base/check.h"

namespace tactus::bench {
namespace {

using reference::Parameter;

void move(fuzzy::ForceModel& model, const Parameter& parameter, double by) {
  if (parameter.kind == Parameter::Kind::kWeight) {
    model.experts[*parameter.expert].rules[parameter.index].weight += by;
    return;
  }
  fuzzy::Variable& variable =
      parameter.variable < model.inputs.size() ? model.inputs[parameter.variable] : model.output;
  if (!parameter.expert) {
    variable.terms[parameter.index].points[parameter.point] += by;
    return;
  }
  for (auto& own : model.experts[*parameter.expert].overrides) {
    if (own.variable == variable.id) own.terms[parameter.index].points[parameter.point] += by;
  }
}

}  // namespace

double widthOf(const fuzzy::ForceModel& model, const Parameter& parameter) {
  if (parameter.kind == Parameter::Kind::kWeight) return 1;
  const auto& variable = parameter.variable < model.inputs.size() ? model.inputs[parameter.variable] : model.output;
  return variable.max - variable.min;
}

FiniteDifferences::FiniteDifferences(const fuzzy::ForceModel& model, const std::vector<Parameter>& parameters,
                                     double step) {
  const auto unmoved = fuzzy::compile(model);
  TACTUS_CHECK(unmoved.has_value());
  for (const Parameter& parameter : parameters) {
    const double by = step * widthOf(model, parameter);
    if (parameter.kind == Parameter::Kind::kInput) {
      pairs_.push_back({parameter.variable, {*unmoved, by}, {*unmoved, -by}});
      continue;
    }
    const auto moved = [&](double signed_by) -> Moved {
      fuzzy::ForceModel changed = model;
      move(changed, parameter, signed_by);
      const auto compiled = fuzzy::compile(changed);
      return compiled ? Moved{*compiled, signed_by} : Moved{*unmoved, 0};
    };
    pairs_.push_back({std::nullopt, moved(by), moved(-by)});
    TACTUS_CHECK(pairs_.back().above.by > pairs_.back().below.by);
  }
}

double FiniteDifferences::derivative(std::size_t parameter, std::span<const double> inputs) const {
  const auto& [input, above, below] = pairs_[parameter];
  double force_above, force_below;
  if (input) {
    std::array<double, fuzzy::kMostInputs> point;
    std::copy(inputs.begin(), inputs.end(), point.begin());
    const std::span<const double> moved(point.data(), inputs.size());
    point[*input] = inputs[*input] + above.by;
    force_above = above.model.evaluate(moved).force_n;
    point[*input] = inputs[*input] + below.by;
    force_below = below.model.evaluate(moved).force_n;
  } else {
    force_above = above.model.evaluate(inputs).force_n;
    force_below = below.model.evaluate(inputs).force_n;
  }
  return (force_above - force_below) / (above.by - below.by);
}

}  // namespace tactus::bench
