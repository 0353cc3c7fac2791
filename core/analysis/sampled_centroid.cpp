#include "core/analysis/sampled_centroid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tactus::analysis {
namespace {

double sampledCentroid(const fuzzy::CompiledModel& model, std::size_t expert, std::span<const double> strengths,
                       const Sampling& sampling) {
  const auto terms = model.outputTerms(expert);
  const double lo = model.outputMin();
  const double width = model.outputMax() - lo;
  const bool clip = model.implication() == fuzzy::Implication::kClip;
  const bool midpoint = sampling.rule == Sampling::Rule::kMidpoint;
  double area = 0;
  double moment = 0;
  for (std::size_t i = 0; i < sampling.count; ++i) {
    const double share = midpoint ? (static_cast<double>(i) + 0.5) / static_cast<double>(sampling.count)
                                  : static_cast<double>(i) / static_cast<double>(sampling.count - 1);
    const double x = lo + width * share;
    double height = 0;
    for (std::size_t t = 0; t < terms.size(); ++t) {
      if (strengths[t] == 0) continue;
      const double membership = terms[t](x);
      height = std::max(height, clip ? std::min(strengths[t], membership) : strengths[t] * membership);
    }
    area += height;
    moment += height * x;
  }
  return moment / area;
}

}  // namespace

fuzzy::Evaluation evaluateSampled(const fuzzy::CompiledModel& model, std::span<const double> inputs,
                                  const Sampling& sampling, std::optional<std::size_t> expert) {
  const auto exact = expert ? model.evaluateExpert(*expert, inputs) : model.evaluate(inputs);
  if (!exact.fired) return exact;
  double weights = 0;
  double sum = 0;
  std::array<double, fuzzy::kMostTerms> strengths{};
  for (std::size_t e = expert.value_or(0); e < (expert ? *expert + 1 : model.expertCount()); ++e) {
    const double weight = expert ? 1 : model.normalizedWeight(e);
    if (weight == 0 || !model.strengths(e, inputs, strengths)) continue;
    weights += weight;
    sum += weight * sampledCentroid(model, e, strengths, sampling);
  }
  return {sum / weights, true};
}

}  // namespace tactus::analysis
