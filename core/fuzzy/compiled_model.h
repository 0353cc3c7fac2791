// A force model compiled for evaluation: immutable, shared freely between threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::fuzzy {

/// The force at one point.
struct Evaluation {
  double force_n = 0;  ///< the default force where nothing fired; NaN where an input is not finite
  bool fired = false;  ///< some expert's rule has a strength > 0
};

/// What `compile` makes of a ForceModel. All functions are const, so any number of threads may evaluate one model.
class CompiledModel {
 public:
  std::size_t inputCount() const noexcept { return input_min_.size(); }
  std::size_t expertCount() const noexcept { return experts_.size(); }
  double outputMin() const noexcept { return output_min_; }
  double outputMax() const noexcept { return output_max_; }
  Implication implication() const noexcept { return implication_; }
  /// Weight of an expert in the mean, relative to the largest.
  double weight(std::size_t expert) const noexcept { return experts_[expert].weight; }

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

 private:
  friend base::Result<CompiledModel> compile(const ForceModel& model);

  /// A list of terms of one variable; experts without a list of their own share it.
  using Bank = std::vector<MembershipFunction>;

  /// Memberships and strengths are kept times this power of two, so that small ones and their products keep their
  /// digits.
  static constexpr double kStrengthScale = 0x1p512;

  struct CompiledCondition {
    std::uint8_t input;
    std::uint8_t term;
  };
  struct CompiledRule {
    std::uint32_t first_condition;
    std::uint16_t condition_count;
    std::uint16_t then;
    double weight;
  };
  struct CompiledExpert {
    double weight = 1;                      ///< relative to the largest weight
    std::vector<std::uint32_t> input_bank;  ///< one per input
    std::uint32_t output_bank = 0;
    std::vector<CompiledRule> rules;  ///< enabled rules with a weight > 0 only
    std::vector<CompiledCondition> conditions;
  };
  struct Fuzzified;

  bool clampInputs(std::span<const double> inputs, std::span<double> clamped) const noexcept;
  /// Strengths times kStrengthScale.
  bool expertStrengths(const CompiledExpert& expert, std::span<const double> clamped, Fuzzified& fuzzified,
                       std::span<double> strengths) const noexcept;
  /// Centroid of one expert measured from the lower end of the output's universe.
  bool expertOffset(const CompiledExpert& expert, std::span<const double> clamped, Fuzzified& fuzzified,
                    double& offset) const noexcept;

  std::vector<double> input_min_;
  std::vector<double> input_max_;
  double output_min_ = 0;
  double output_max_ = 1;
  double default_force_n_ = 0;
  Implication implication_ = Implication::kClip;
  std::vector<Bank> banks_;
  std::vector<CompiledExpert> experts_;
};

/// Validates `model` and compiles it. The error is that of `validate`.
base::Result<CompiledModel> compile(const ForceModel& model);

}  // namespace tactus::fuzzy
