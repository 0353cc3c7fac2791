#include "core/analysis/reachable_range.h"

#include <algorithm>
#include <array>

namespace tactus::analysis {
namespace {

constexpr std::size_t kMostPoints = 20000;

std::vector<double> interestingValues(const fuzzy::ForceModel& model, const fuzzy::Variable& input) {
  std::vector<double> values = {input.min, input.max};
  for (const auto& expert : model.experts) {
    for (const auto& term : termsFor(expert, input)) {
      const bool gaussian = term.shape == fuzzy::Shape::kGaussian;
      for (const double x : gaussian ? std::vector<double>{term.points[0]} : term.points) {
        if (x > input.min && x < input.max) values.push_back(x);
      }
    }
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  for (std::size_t i = values.size() - 1; i > 0; --i) values.push_back((values[i] + values[i - 1]) / 2);
  return values;
}

/// Radical inverse of `index` in base `base` (Halton 1960): in [0, 1).
double radicalInverse(std::size_t index, std::size_t base) {
  double share = 1;
  double value = 0;
  for (; index > 0; index /= base) {
    share /= static_cast<double>(base);
    value += share * static_cast<double>(index % base);
  }
  return value;
}

}  // namespace

ForceRange reachableRange(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled) {
  constexpr std::array<std::size_t, fuzzy::kMostInputs> kPrimes = {2, 3, 5, 7, 11, 13, 17, 19};
  std::vector<std::vector<double>> values;
  std::size_t combinations = 1;
  for (const auto& input : model.inputs) {
    values.push_back(interestingValues(model, input));
    combinations = std::min(combinations * values.back().size(), kMostPoints + 1);
  }
  const bool all = combinations <= kMostPoints;

  ForceRange range;
  range.points = std::min(combinations, kMostPoints);
  std::vector<double> point(model.inputs.size());
  for (std::size_t p = 0; p < range.points; ++p) {
    std::size_t rest = p;
    for (std::size_t i = 0; i < point.size(); ++i) {
      const std::size_t count = values[i].size();
      const std::size_t pick =
          all ? rest % count : static_cast<std::size_t>(radicalInverse(p + 1, kPrimes[i]) * static_cast<double>(count));
      rest /= count;
      point[i] = values[i][pick];
    }
    const auto force = compiled.evaluate(point);
    if (!force.fired) continue;
    range.min_n = range.fired == 0 ? force.force_n : std::min(range.min_n, force.force_n);
    range.max_n = range.fired == 0 ? force.force_n : std::max(range.max_n, force.force_n);
    ++range.fired;
  }
  return range;
}

}  // namespace tactus::analysis
