// Evaluation of a compiled model at one point: the fast form, and the general path where that leaves something open.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/check.h"
#include "core/fuzzy/general_path.h"
#include "core/fuzzy/kernels.h"
#include "core/fuzzy/model_tables.h"

namespace tactus::fuzzy {
namespace {

constexpr Evaluation kNotANumber{std::numeric_limits<double>::quiet_NaN(), false};

enum class Outcome { kFires, kAbstains, kOpen };

Outcome outcomeOf(const Program& program, const Centroid& centroid, bool ordinary) noexcept {
  if (centroid.area > program.negligible) return Outcome::kFires;
  return centroid.area == 0 && program.zero_is_certain && ordinary ? Outcome::kAbstains : Outcome::kOpen;
}

}  // namespace

Evaluation evaluateProgram(const ModelTables& tables, const Program& program, std::span<const double> inputs) noexcept {
  std::array<double, kMostInputs> values{};
  if (!tables.clamp(inputs, values)) return kNotANumber;
  const std::span<const double> clamped(values.data(), inputs.size());
  if (!program.usable) return evaluateGenerally(tables, clamped);
  std::array<Centroid, kMostExperts> centroids;
  program.kernels->point(program, clamped.data(), centroids.data());

  // Mostly every expert fires.
  const std::size_t experts = tables.experts.size();
  bool all_fire = true;
  double sum = 0;
  for (std::size_t e = 0; e < experts; ++e) {
    all_fire = all_fire && centroids[e].area > program.negligible;
    sum += centroids[e].moment / centroids[e].area * program.experts[e].share;
  }
  if (all_fire) return {tables.output_min + sum, true};

  const bool ordinary = areOrdinary(clamped);
  Mean mean;
  for (std::size_t e = 0; e < experts; ++e) {
    const double weight = tables.experts[e].weight;
    if (weight == 0) continue;
    const Outcome outcome = outcomeOf(program, centroids[e], ordinary);
    double offset = 0;
    if (outcome == Outcome::kFires) {
      mean.add(centroids[e].moment / centroids[e].area, weight);
    } else if (outcome == Outcome::kOpen && expertOffsetGenerally(tables, e, clamped, offset)) {
      mean.add(offset, weight);
    }
  }
  return mean.result(tables);
}

std::size_t CompiledModel::inputCount() const noexcept { return tables_->input_min.size(); }
std::size_t CompiledModel::expertCount() const noexcept { return tables_->experts.size(); }
double CompiledModel::outputMin() const noexcept { return tables_->output_min; }
double CompiledModel::outputMax() const noexcept { return tables_->output_max; }
Implication CompiledModel::implication() const noexcept { return tables_->implication; }
double CompiledModel::weight(std::size_t expert) const noexcept { return tables_->experts[expert].weight; }

double CompiledModel::clampInput(std::size_t input, double value) const noexcept {
  return std::clamp(value, tables_->input_min[input], tables_->input_max[input]);
}

Evaluation CompiledModel::evaluate(std::span<const double> inputs) const noexcept {
  return evaluateProgram(*tables_, tables_->program, inputs);
}

Evaluation CompiledModel::evaluateExpert(std::size_t expert, std::span<const double> inputs) const noexcept {
  std::array<double, kMostInputs> values{};
  if (!tables_->clamp(inputs, values)) return kNotANumber;
  const std::span<const double> clamped(values.data(), inputs.size());
  const Program& program = tables_->program;
  double offset = 0;
  bool fires = false;
  Outcome outcome = Outcome::kOpen;
  if (program.usable) {
    std::array<Centroid, kMostExperts> centroids;
    program.kernels->point(program, values.data(), centroids.data());
    outcome = outcomeOf(program, centroids[expert], areOrdinary(clamped));
    fires = outcome == Outcome::kFires;
    if (fires) offset = centroids[expert].moment / centroids[expert].area;
  }
  if (outcome == Outcome::kOpen) fires = expertOffsetGenerally(*tables_, expert, clamped, offset);
  if (!fires) return {tables_->default_force_n, false};
  return {tables_->output_min + offset, true};
}

bool CompiledModel::strengths(std::size_t expert, std::span<const double> inputs,
                              std::span<double> strengths) const noexcept {
  std::array<double, kMostInputs> clamped;
  if (!tables_->clamp(inputs, clamped)) return false;
  return expertStrengths(*tables_, expert, {clamped.data(), inputs.size()},
                         strengths.first(outputTerms(expert).size()));
}

std::span<const MembershipFunction> CompiledModel::outputTerms(std::size_t expert) const noexcept {
  return tables_->banks[tables_->experts[expert].output_bank];
}

}  // namespace tactus::fuzzy
