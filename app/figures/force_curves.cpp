#include "app/figures/force_curves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/check.h"
#include "core/fuzzy/compiled_model.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::figures {
namespace {

void addVertices(const std::vector<fuzzy::Term>& terms, std::vector<double>& positions) {
  for (const fuzzy::Term& term : terms) {
    if (term.shape == fuzzy::Shape::kGaussian) {
      positions.push_back(term.points.front());
      continue;
    }
    for (const double vertex : term.points) {
      positions.push_back(std::nextafter(vertex, -HUGE_VAL));
      positions.push_back(vertex);
      positions.push_back(std::nextafter(vertex, HUGE_VAL));
    }
  }
}

}  // namespace

std::vector<double> samplePositions(const fuzzy::ForceModel& model, std::size_t x_input,
                                    std::optional<Interval> shown) {
  const fuzzy::Variable& variable = model.inputs[x_input];
  std::vector<double> positions;
  const std::size_t samples = model.experts.size() > kManyExperts ? kCurveSamplesOfMany : kCurveSamples;
  const auto sample = [&](double low, double high) {
    for (std::size_t i = 0; i < samples; ++i) {
      positions.push_back(std::lerp(low, high, static_cast<double>(i) / static_cast<double>(samples - 1)));
    }
  };
  sample(variable.min, variable.max);
  if (shown && (shown->low > variable.min || shown->high < variable.max)) sample(shown->low, shown->high);
  addVertices(variable.terms, positions);
  for (const fuzzy::Expert& expert : model.experts) {
    for (const fuzzy::TermOverride& override_list : expert.overrides) {
      if (override_list.variable == variable.id) addVertices(override_list.terms, positions);
    }
  }
  std::erase_if(positions, [&variable](double x) { return x < variable.min || x > variable.max; });
  std::sort(positions.begin(), positions.end());
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
  return positions;
}

ForceCurves computeCurves(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, std::size_t x_input,
                          std::span<const double> values, std::optional<Interval> shown) {
  TACTUS_CHECK(values.size() == compiled.inputCount() && x_input < values.size());
  std::array<double, fuzzy::kMostInputs> buffer{};
  std::copy(values.begin(), values.end(), buffer.begin());
  const std::span<double> inputs(buffer.data(), values.size());

  ForceCurves curves;
  curves.x = samplePositions(model, x_input, shown);
  curves.mean.reserve(curves.x.size());
  curves.experts.resize(compiled.expertCount());
  for (auto& curve : curves.experts) curve.reserve(curves.x.size());
  std::vector<fuzzy::Evaluation> here(curves.experts.size());
  for (const double x : curves.x) {
    inputs[x_input] = x;
    curves.mean.push_back(compiled.evaluate(inputs));
    fuzzy::evaluateEveryExpert(compiled, inputs, here);
    for (std::size_t expert = 0; expert < here.size(); ++expert) curves.experts[expert].push_back(here[expert]);
  }
  return curves;
}

std::vector<analysis::ForceStep> noticeableSteps(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                                                 std::size_t x_input, std::span<const double> values) {
  if (model.output.unit != "N" || model.experts.size() > kManyExperts) return {};
  return analysis::forceStepsAlong(model, compiled, x_input, values, elicitation::forceStepLimits(model));
}

std::vector<Interval> silentIntervals(std::span<const double> x, std::span<const fuzzy::Evaluation> curve) {
  TACTUS_CHECK(x.size() == curve.size());
  std::vector<Interval> intervals;
  for (std::size_t i = 0; i < x.size();) {
    if (curve[i].fired) {
      ++i;
      continue;
    }
    const std::size_t first = i;
    while (i < x.size() && !curve[i].fired) ++i;
    const Interval interval{x[first], x[i - 1]};
    // Two terms that only touch leave a single point without a rule; it has no width to show.
    if (interval.high - interval.low > 1e-9 * (x.back() - x.front())) intervals.push_back(interval);
  }
  return intervals;
}

}  // namespace tactus::figures
