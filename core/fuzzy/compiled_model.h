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
  double force_n = 0;  ///< the default force if no rule fires; NaN if an input is not finite
  bool fired = false;  ///< some expert has a rule with a strength > 0
};

struct ModelTables;

/// The result of `compile`. Immutable and cheap to copy, because copies share their tables. Any number of threads may
/// evaluate one model.
class CompiledModel {
 public:
  std::size_t inputCount() const noexcept;
  std::size_t expertCount() const noexcept;
  double outputMin() const noexcept;
  double outputMax() const noexcept;
  Implication implication() const noexcept;
  /// Weight of an expert in the mean, as in the model.
  double weight(std::size_t expert) const noexcept;
  /// The same as the mean takes it: normalizedWeights (force_model.h).
  double normalizedWeight(std::size_t expert) const noexcept;

  /// The averaged force (paper, Eq. 2): the weighted mean over the experts that do not abstain.
  /// `inputs`: inputCount() values in the order and units of the model's inputs. Values outside the universe are
  /// clamped.
  /// Exact up to rounding for trapezoids and triangles. Error for Gaussian output terms: at most 1e-12 of the output
  /// range.
  /// Thread: any. Real-time safe: yes (no allocation, no lock, bounded time).
  Evaluation evaluate(std::span<const double> inputs) const noexcept;

  /// The force of one expert alone, regardless of the expert's weight. `inputs` as for `evaluate`.
  /// Thread: any. Real-time safe: yes.
  Evaluation evaluateExpert(std::size_t expert, std::span<const double> inputs) const noexcept;

  /// The aggregated output of one expert: the largest firing strength of each output term, 0 if no rule fires for it.
  /// `strengths`: outputTerms(expert).size() values, written here. Returns whether any of them is > 0.
  /// Thread: any. Real-time safe: yes.
  bool strengths(std::size_t expert, std::span<const double> inputs, std::span<double> strengths) const noexcept;

  /// The output terms of one expert, in the order of `strengths`.
  std::span<const MembershipFunction> outputTerms(std::size_t expert) const noexcept;

  /// `value` clamped to the universe of input `input`.
  double clampInput(std::size_t input, double value) const noexcept;

  /// The tables for the evaluators of this folder (model_tables.h).
  const ModelTables& tables() const noexcept { return *tables_; }

 private:
  friend base::Result<CompiledModel> compile(const ForceModel& model);

  std::shared_ptr<const ModelTables> tables_;
};

/// Validates `model` and compiles it. Returns the error of `validate` if the model is invalid.
base::Result<CompiledModel> compile(const ForceModel& model);

// The separate forces of all experts at one point.

/// The force of every expert at `inputs` (as in CompiledModel::evaluate), in one pass over the model. With hundreds of
/// experts this takes about 1/100 of the time of one call per expert. `experts`: model.expertCount() results, written
/// here. The forces agree with CompiledModel::evaluateExpert to 4 ulp, `fired` exactly.
/// Thread: any. Real-time safe: yes.
void evaluateEveryExpert(const CompiledModel& model, std::span<const double> inputs,
                         std::span<Evaluation> experts) noexcept;

}  // namespace tactus::fuzzy
