// A budget of evaluations, so that the lint of a huge model ends in bounded time.
#pragma once

#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/analysis/sample_points.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// A model with a budget, counted in evaluated rules and therefore equal on every machine.
class ForceProbe {
 public:
  /// After `stop` is requested, the budget counts as used up.
  ForceProbe(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, std::size_t allowance_rules,
             std::stop_token stop = {})
      : model_(model),
        compiled_(compiled),
        vertices_(sortedVertices(model)),
        left_(allowance_rules),
        stop_(std::move(stop)) {
    for (const auto& expert : model.experts) all_rules_ += expert.rules.size() + kFixedCost;
  }

  const fuzzy::ForceModel& model() const noexcept { return model_; }
  const fuzzy::CompiledModel& compiled() const noexcept { return compiled_; }
  /// The values of one input in [low, high] to try (valuesWorthALook).
  std::vector<double> values(std::size_t input, double low, double high) const {
    return valuesWorthALook(vertices_[input], low, high);
  }
  /// The same for the whole range of the input.
  std::vector<double> values(std::size_t input) const {
    return values(input, model_.inputs[input].min, model_.inputs[input].max);
  }
  /// The vertices of all terms of an input inside its universe, ascending.
  std::span<const double> vertices(std::size_t input) const noexcept { return vertices_[input]; }
  /// Cost of one averaged force, in rules.
  std::size_t costOfMean() const noexcept { return all_rules_; }
  /// False if the budget is used up; the caller then ends its search.
  bool affords() const noexcept { return left_ > 0 && !stop_.stop_requested(); }

  fuzzy::Evaluation mean(std::span<const double> point) {
    spend(all_rules_);
    return compiled_.evaluate(point);
  }
  /// Returns the averaged force and writes the forces of all experts to `experts` (one place per expert).
  fuzzy::Evaluation everyExpert(std::span<const double> point, std::span<fuzzy::Evaluation> experts) {
    spend(2 * all_rules_);
    fuzzy::evaluateEveryExpert(compiled_, point, experts);
    return compiled_.evaluate(point);
  }
  fuzzy::Evaluation expert(std::size_t expert, std::span<const double> point) {
    spend(model_.experts[expert].rules.size() + kFixedCost);
    return compiled_.evaluateExpert(expert, point);
  }

 private:
  /// Cost of fuzzification and centroid of one expert, in rules.
  static constexpr std::size_t kFixedCost = 32;

  void spend(std::size_t rules) noexcept { left_ -= rules < left_ ? rules : left_; }

  const fuzzy::ForceModel& model_;
  const fuzzy::CompiledModel& compiled_;
  std::vector<std::vector<double>> vertices_;
  std::size_t left_;
  std::stop_token stop_;
  std::size_t all_rules_ = 0;
};

}  // namespace tactus::analysis
