// The tables of a compiled model, shared by the evaluators of this folder. Nothing outside core/fuzzy includes this.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/base/check.h"
#include "core/fuzzy/batch.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/program.h"

namespace tactus::fuzzy {

/// One expert's rules with names turned into indices.
struct RuleTable {
  struct Condition {
    std::uint8_t input;
    std::uint8_t term;
  };
  struct Rule {
    std::uint32_t first_condition;
    std::uint16_t condition_count;
    std::uint16_t then;
    double weight;
  };
  double weight = 1;                      ///< of the expert in the mean
  double share = 1;                       ///< weight relative to the sum of all weights
  std::vector<std::uint32_t> input_bank;  ///< one per input
  std::uint32_t output_bank = 0;
  std::vector<Rule> rules;  ///< enabled rules with a weight > 0 only
  std::vector<Condition> conditions;
};

struct ModelTables {
  std::vector<double> input_min, input_max;
  double output_min = 0, output_max = 1;
  double default_force_n = 0;
  Implication implication = Implication::kClip;
  std::vector<std::vector<MembershipFunction>> banks;  ///< lists of terms; experts without their own share one
  std::vector<RuleTable> experts;
  Program program;

  /// Copies `inputs` into their universes; false where one is not finite.
  bool clamp(std::span<const double> inputs, std::span<double> clamped) const noexcept {
    TACTUS_CHECK(inputs.size() == input_min.size());
    double nothing = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const double x = inputs[i];
      nothing += x - x;  // NaN where x is NaN or infinite
      const double above = x > input_min[i] ? x : input_min[i];
      clamped[i] = above < input_max[i] ? above : input_max[i];
    }
    return nothing == 0;
  }
};

/// The mean at a point: all inputs of the model, clamped here; NaN where one is not finite. Whatever the fast form
/// leaves open the general path decides. `kernels`: those of the program, or others that this processor can run.
/// Thread: any. Real-time safe: yes.
Evaluation evaluatePoint(const ModelTables& tables, const Kernels& kernels, std::span<const double> inputs) noexcept;

/// The same at a point that is finite and in the universes. Thread: any. Real-time safe: yes.
Evaluation evaluateClamped(const ModelTables& tables, const Kernels& kernels, std::span<const double> clamped) noexcept;

/// What every evaluation gives where an input is not finite.
inline constexpr Evaluation kNotANumber{std::numeric_limits<double>::quiet_NaN(), false};

/// The same at many points, by the program of the model or one specialised from it: `varying` holds one array for each
/// input in `index`, `values` the values of the others. Thread: any. Real-time safe: yes.
void evaluateBatchOf(const ModelTables& tables, const BatchProgram& program,
                     std::span<const std::span<const double>> varying, std::span<const std::size_t> index,
                     std::span<const double> values, BatchResult out) noexcept;

/// Whether every input is 0 or not so small that products with it could underflow: then an area of 0 is certain.
inline bool areOrdinary(std::span<const double> clamped) noexcept {
  bool ordinary = true;
  for (const double x : clamped) ordinary = ordinary && (x == 0 || x > 1e-280 || x < -1e-280);
  return ordinary;
}

}  // namespace tactus::fuzzy
