// Derivatives by moving one parameter at a time: what the gradient is measured against.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

#include "tests/reference/exact_gradient.h"

namespace tactus::bench {

/// The width of the universe that a parameter moves in; 1 for a weight.
double widthOf(const fuzzy::ForceModel& model, const reference::Parameter& parameter);

/// Central differences of the plain evaluator over some parameters of a model; one-sided where the other side is no
/// valid model (a weight of 1, vertices that coincide). The moved models are compiled beforehand, so that a derivative
/// costs two evaluations and no more: the best that differences can do.
class FiniteDifferences {
 public:
  /// Every parameter moves by `step` of its width.
  FiniteDifferences(const fuzzy::ForceModel& model, const std::vector<reference::Parameter>& parameters, double step);

  std::size_t count() const { return pairs_.size(); }
  /// Derivative with respect to one of the parameters.
  double derivative(std::size_t parameter, std::span<const double> inputs) const;

 private:
  struct Moved {
    fuzzy::CompiledModel model;
    double by;  ///< of a vertex or a weight; of the input where the model is unchanged
  };
  struct Pair {
    std::optional<std::size_t> input;
    Moved above, below;
  };

  std::vector<Pair> pairs_;
};

}  // namespace tactus::bench
