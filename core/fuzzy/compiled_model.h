// A force model compiled for evaluation: immutable, shared freely between threads.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::fuzzy {

/// The force at one point.
struct Evaluation {
  double force_n = 0;  ///< the default force where nothing fired; NaN where an input is not finite
  bool fired = false;  ///< some expert's rule has a strength > 0
};

struct ModelTables;

/// What `compile` makes of a ForceModel. Immutable and cheap to copy (copies share their tables), so any number of
/// threads may evaluate one model.
class CompiledModel {
 public:
  std::size_t inputCount() const noexcept;
  std::size_t expertCount() const noexcept;
  double outputMin() const noexcept;
  double outputMax() const noexcept;
  Implication implication() const noexcept;
  /// Weight of an expert in the mean, as in the model.
  double weight(std::size_t expert) const noexcept;

  /// The averaged force (paper, Eq. 2): the weighted mean over the experts that do not abstain.
  /// `inputs`: inputCount() values in the order and units of the model's inputs; outside the universe they are clamped.
  /// Exact up to rounding for trapezoids and triangles; Gaussian output terms to 1e-12 of the output's range.
  /// Thread: any. Real-time safe: yes (no allocation, no lock, bounded time).
  Evaluation evaluate(std::span<const double> inputs) const noexcept;

  /// The force of one expert alone, whatever the weight.
  /// Thread: any. Real-time safe: yes.
  Evaluation evaluateExpert(std::size_t expert, std::span<const double> inputs) const noexcept;

  /// Aggregated output of one expert: for each of its output terms the largest firing strength, 0 where no rule fires.
  /// `strengths` must have room for outputTerms(expert).size() values. Returns whether any is > 0.
  /// Thread: any. Real-time safe: yes.
  bool strengths(std::size_t expert, std::span<const double> inputs, std::span<double> strengths) const noexcept;

  /// The output terms of one expert, in the order of `strengths`.
  std::span<const MembershipFunction> outputTerms(std::size_t expert) const noexcept;

  /// The value inside its universe that stands for `value` of input `input`.
  double clampInput(std::size_t input, double value) const noexcept;

  /// What the evaluators of this folder read (model_tables.h).
  const ModelTables& tables() const noexcept { return *tables_; }

 private:
  friend base::Result<CompiledModel> compile(const ForceModel& model);

  std::shared_ptr<const ModelTables> tables_;
};

/// Validates `model` and compiles it. The error is that of `validate`.
base::Result<CompiledModel> compile(const ForceModel& model);

}  // namespace tactus::fuzzy
