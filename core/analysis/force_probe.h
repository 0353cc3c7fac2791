// Evaluations that an analysis may still spend, so that a lint of a huge model ends in a bounded time.
#pragma once

#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/analysis/sample_points.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/every_expert.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// A model with an allowance, counted in rules looked at: the same on every machine.
class ForceProbe {
 public:
  /// Once `stop` says so nothing is afforded any more.
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
  /// Values of one input in [low, high] that are worth a look.
  std::vector<double> values(std::size_t input, double low, double high) const {
    return valuesWorthALook(vertices_[input], low, high);
  }
  /// The same over its whole range.
  std::vector<double> values(std::size_t input) const {
    return values(input, model_.inputs[input].min, model_.inputs[input].max);
  }
  /// The vertices of all terms of an input inside its universe, ascending.
  std::span<const double> vertices(std::size_t input) const noexcept { return vertices_[input]; }
  /// Cost of one averaged force.
  std::size_t costOfMean() const noexcept { return all_rules_; }
  /// False once the allowance is spent; callers stop looking then.
  bool affords() const noexcept { return left_ > 0 && !stop_.stop_requested(); }

  fuzzy::Evaluation mean(std::span<const double> point) {
    spend(all_rules_);
    return compiled_.evaluate(point);
  }
  /// The averaged force, and into `experts` (one place for each) those of all experts.
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
  /// Fuzzification and centroid of one expert, in rules.
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
