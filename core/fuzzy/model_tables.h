// The tables of a compiled model, shared by the evaluators of this folder. Nothing outside core/fuzzy includes this.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory_resource>
#include <span>
#include <vector>

#include "core/base/check.h"
#include "core/fuzzy/batch.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/program.h"

namespace tactus::fuzzy {

/// A condition by indices instead of names.
struct IndexedCondition {
  std::uint8_t input;
  std::uint8_t term;
};

struct IndexedRule {
  double weight;
  std::uint32_t premise;
  std::uint16_t then;
};

struct ExpertTable {
  double given_weight = 1;  ///< as in the model
  double weight = 1;        ///< in the mean: normalizedWeights
  double share = 1;         ///< `weight` relative to the sum of all
  Stretch rules;            ///< enabled rules with a weight > 0
  std::array<std::uint32_t, kMostInputs> input_bank{};
  std::uint32_t output_bank = 0;
};

struct ModelTables {
  /// `bytes`: the expected size of the tables. More memory is allocated if they need it.
  explicit ModelTables(std::size_t bytes = 4096) : memory(bytes) {}

  std::pmr::monotonic_buffer_resource memory;
  Table<double> input_min{&memory}, input_max{&memory};
  double output_min = 0, output_max = 1;
  double default_force_n = 0;
  Implication implication = Implication::kClip;
  Table<MembershipFunction> terms{&memory};
  Table<Stretch> banks{&memory};  ///< ranges of `terms`, one per list; experts without own lists share them
  Table<IndexedCondition> conditions{&memory};
  Table<Stretch> premises{&memory};  ///< ranges of `conditions`; each combination of conditions once
  Table<IndexedRule> rules{&memory};
  Table<ExpertTable> experts{&memory};
  Program program{&memory};

  std::span<const MembershipFunction> bank(std::uint32_t index) const noexcept { return in(terms, banks[index]); }

  /// Clamps `inputs` to their universes. Returns false if an input is not finite.
  bool clamp(std::span<const double> inputs, std::span<double> clamped) const noexcept {
    TACTUS_CHECK(inputs.size() == input_min.size());
    double nothing = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const double x = inputs[i];
      nothing += x - x;  // NaN if x is NaN or infinite
      const double above = x > input_min[i] ? x : input_min[i];
      clamped[i] = above < input_max[i] ? above : input_max[i];
    }
    return nothing == 0;
  }
};

/// The mean at one point. `inputs`: all inputs of the model; the function clamps them. The force is NaN if an input is
/// not finite. The general path evaluates the points that the fast form cannot decide.
/// `kernels`: the kernels of the program, or another set that this processor supports.
/// Thread: any. Real-time safe: yes.
Evaluation evaluatePoint(const ModelTables& tables, const Kernels& kernels, std::span<const double> inputs) noexcept;

/// The same. `abstention`: an input is not finite, or the area of an expert with a share is exactly 0. There the lanes
/// of a batch leave the point to this function.
Evaluation evaluatePoint(const ModelTables& tables, const Kernels& kernels, std::span<const double> inputs,
                         bool& abstention) noexcept;

/// What every evaluation gives where an input is not finite.
inline constexpr Evaluation kNotANumber{std::numeric_limits<double>::quiet_NaN(), false};

/// The mean at many points, by the program of the model or a specialized one. `varying`: one array for each input in
/// `index`. `values`: the values of all inputs; those in `index` are ignored. Thread: any. Real-time safe: yes.
void evaluateBatchOf(const ModelTables& tables, const BatchProgram& program,
                     std::span<const std::span<const double>> varying, std::span<const std::size_t> index,
                     std::span<const double> values, BatchResult out) noexcept;

/// Whether each input is 0 or at least 1e-280 in size. Then no product with an input underflows, and an area of 0 is
/// exact.
inline bool areOrdinary(std::span<const double> clamped) noexcept {
  bool ordinary = true;
  for (const double x : clamped) ordinary = ordinary && (x == 0 || x > 1e-280 || x < -1e-280);
  return ordinary;
}

}  // namespace tactus::fuzzy
