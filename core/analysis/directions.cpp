#include "core/analysis/directions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/analysis/rule_table.h"
#include "core/analysis/sample_points.h"

namespace tactus::analysis {
namespace {

/// Values of each input at which `conditions` are met in full: one where there is a condition, all that are worth a
/// look where there is none.
std::vector<std::vector<double>> valuesFor(const ForceProbe& probe, const fuzzy::Expert& expert,
                                           const std::vector<fuzzy::Condition>& conditions) {
  const auto& model = probe.model();
  std::vector<std::vector<double>> values;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const auto& input = model.inputs[i];
    const auto condition = std::find_if(conditions.begin(), conditions.end(),
                                        [&](const fuzzy::Condition& c) { return c.input == input.id; });
    if (condition == conditions.end()) {
      values.push_back(probe.values(i));
    } else {
      values.push_back({peakPosition(*findTerm(termsFor(expert, input), condition->term), input.min, input.max)});
    }
  }
  return values;
}

}  // namespace

ExpertDirection direction(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, std::size_t input) {
  std::vector<NeighborStep> up;
  std::vector<NeighborStep> down;
  for (const auto& step : neighborSteps(model, expert, input)) {
    if (step.levels != 0) (step.levels > 0 ? up : down).push_back(step);
  }
  const std::size_t steps = up.size() + down.size();
  if (steps > 0 && 4 * up.size() >= 3 * steps) return {Direction::kRises, std::move(up), std::move(down)};
  if (steps > 0 && 4 * down.size() >= 3 * steps) return {Direction::kFalls, std::move(down), std::move(up)};
  return {};
}

std::optional<ForceChange> changeAlong(ForceProbe& probe, std::size_t expert, const NeighborStep& step,
                                       std::size_t samples) {
  if (!probe.affords()) return std::nullopt;
  const auto& who = probe.model().experts[expert];
  const SamplePoints from(valuesFor(probe, who, who.rules[step.before].conditions), samples);
  const SamplePoints to(valuesFor(probe, who, who.rules[step.after].conditions), samples);
  std::optional<ForceChange> largest;
  SamplePoints::Choice where;
  // The rules differ along one input only, so a choice means the same values of the others at both ends.
  const auto look = [&](const SamplePoints::Choice& choice) -> std::optional<double> {
    if (!probe.affords()) return std::nullopt;
    auto before = from.at(choice);
    auto after = to.at(choice);
    const auto start = probe.expert(expert, before);
    const auto end = probe.expert(expert, after);
    if (!start.fired || !end.fired) return std::nullopt;
    const double newtons = std::max(0.0, step.levels > 0 ? end.force_n - start.force_n : start.force_n - end.force_n);
    if (!largest || newtons > largest->newtons) {
      largest = ForceChange{newtons, std::move(before), std::move(after)};
      where = choice;
    }
    return newtons;
  };
  for (std::size_t p = 0; p < from.size(); ++p) look(from.choice(p));
  if (largest) from.climb(where, largest->newtons, look);
  return largest;
}

std::vector<std::optional<ForceChange>> differencesAlong(ForceProbe& probe, std::size_t input, std::size_t samples) {
  const auto& model = probe.model();
  std::vector<std::vector<double>> values;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const auto& v = model.inputs[i];
    values.push_back(i == input ? std::vector<double>{v.min} : probe.values(i));
  }
  const SamplePoints points(std::move(values), samples);
  std::vector<std::optional<ForceChange>> largest(model.experts.size());
  std::vector<SamplePoints::Choice> where(model.experts.size());
  std::vector<std::optional<double>> changes(model.experts.size());
  std::vector<std::optional<double>> newtons(model.experts.size());
  const std::vector<double> weight = normalizedWeights(model);
  const auto look = [&](const SamplePoints::Choice& choice) {
    std::fill(newtons.begin(), newtons.end(), std::nullopt);
    if (!probe.affords()) return;
    const auto low = points.at(choice);
    auto high = low;
    high[input] = model.inputs[input].max;
    double weights = 0;
    double sum = 0;
    for (std::size_t e = 0; e < changes.size(); ++e) {
      const auto from = probe.expert(e, low);
      const auto to = probe.expert(e, high);
      changes[e].reset();
      if (!from.fired || !to.fired) continue;
      changes[e] = to.force_n - from.force_n;
      weights += weight[e];
      sum += weight[e] * *changes[e];
    }
    for (std::size_t e = 0; e < changes.size(); ++e) {
      const double own = weight[e];
      // Others that weigh less than this are lost in the rounding of the sums.
      const bool others = changes[e] && weights - own > 1e-9 * weights;
      if (!others) continue;
      newtons[e] = std::abs(*changes[e] - (sum - own * *changes[e]) / (weights - own));
      if (largest[e] && *newtons[e] <= largest[e]->newtons) continue;
      largest[e] = ForceChange{*newtons[e], low, high};
      where[e] = choice;
    }
  };
  for (std::size_t p = 0; p < points.size(); ++p) look(points.choice(p));
  for (std::size_t e = 0; e < largest.size(); ++e) {
    if (!largest[e]) continue;
    points.climb(where[e], largest[e]->newtons, [&](const SamplePoints::Choice& choice) {
      look(choice);
      return newtons[e];
    });
  }
  return largest;
}

}  // namespace tactus::analysis
