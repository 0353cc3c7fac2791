// Evaluation of a compiled model at one point: the fast form, and the general path where that leaves something open.
#include <algorithm>
#include <array>
#include <cmath>

#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/general_path.h"
#include "core/fuzzy/kernels.h"
#include "core/fuzzy/model_tables.h"

namespace tactus::fuzzy {
namespace {

constexpr std::size_t kFewExperts = 16;

enum class Outcome { kFires, kAbstains, kOpen };

Outcome outcomeOf(const Program& program, double area, bool ordinary) noexcept {
  if (area > program.negligible) return Outcome::kFires;
  return area == 0 && program.zero_is_certain && ordinary ? Outcome::kAbstains : Outcome::kOpen;
}

/// The mean of the experts that fire: where one may not, or an input is not finite. `abstention` as in evaluatePoint.
[[gnu::noinline]] Evaluation lookAgain(const ModelTables& tables, std::span<const double> inputs,
                                       const PointOutcome& outcome, bool& abstention) noexcept {
  abstention = true;
  std::array<double, kMostInputs> values;
  if (!tables.clamp(inputs, values)) return kNotANumber;
  const std::span<const double> clamped = std::span(values).first(inputs.size());
  const Program& program = tables.program;
  if (!program.usable) return evaluateGenerally(tables, clamped);
  const bool ordinary = areOrdinary(clamped);
  abstention = false;
  Mean mean;
  for (std::size_t seat = 0; seat < tables.experts.size(); ++seat) {
    const std::uint32_t expert = program.point.expert_at[seat];
    const double weight = tables.experts[expert].weight;
    if (weight == 0) continue;
    abstention = abstention || (outcome.area[seat] == 0 && tables.experts[expert].share != 0);
    const Outcome found = outcomeOf(program, outcome.area[seat], ordinary);
    double offset = outcome.offset[seat];
    if (found == Outcome::kFires || (found == Outcome::kOpen && expertOffsetGenerally(tables, expert, clamped, offset)))
      mean.add(offset, weight);
  }
  return mean.result(tables);
}

}  // namespace

Evaluation evaluatePoint(const ModelTables& tables, const Kernels& kernels, std::span<const double> inputs) noexcept {
  bool abstention = false;
  return evaluatePoint(tables, kernels, inputs, abstention);
}

Evaluation evaluatePoint(const ModelTables& tables, const Kernels& kernels, std::span<const double> inputs,
                         bool& abstention) noexcept {
  const Program& program = tables.program;
  TACTUS_CHECK(inputs.size() == tables.input_min.size());
  PointOutcome outcome;
  abstention = false;
  if (program.usable && kernels.point(program, inputs.data(), outcome)) return {tables.output_min + outcome.mean, true};
  return lookAgain(tables, inputs, outcome, abstention);
}

std::size_t CompiledModel::inputCount() const noexcept { return tables_->input_min.size(); }
std::size_t CompiledModel::expertCount() const noexcept { return tables_->experts.size(); }
double CompiledModel::outputMin() const noexcept { return tables_->output_min; }
double CompiledModel::outputMax() const noexcept { return tables_->output_max; }
Implication CompiledModel::implication() const noexcept { return tables_->implication; }
double CompiledModel::weight(std::size_t expert) const noexcept { return tables_->experts[expert].given_weight; }
double CompiledModel::normalizedWeight(std::size_t expert) const noexcept { return tables_->experts[expert].weight; }

double CompiledModel::clampInput(std::size_t input, double value) const noexcept {
  return std::clamp(value, tables_->input_min[input], tables_->input_max[input]);
}

Evaluation CompiledModel::evaluate(std::span<const double> inputs) const noexcept {
  return evaluatePoint(*tables_, *tables_->program.kernels, inputs);
}

Evaluation CompiledModel::evaluateExpert(std::size_t expert, std::span<const double> inputs) const noexcept {
  std::array<double, kMostInputs> values{};
  if (!tables_->clamp(inputs, values)) return kNotANumber;
  const std::span<const double> clamped(values.data(), inputs.size());
  const Program& program = tables_->program;
  Outcome found = Outcome::kOpen;
  double offset = 0;
  // The kernel computes all experts. Where they are many, the general path has this one sooner.
  if (program.usable && tables_->experts.size() <= kFewExperts) {
    PointOutcome outcome;
    program.kernels->point(program, values.data(), outcome);
    const auto& order = program.point.expert_at;
    const auto seat = static_cast<std::size_t>(std::find(order.begin(), order.end(), expert) - order.begin());
    found = outcomeOf(program, outcome.area[seat], areOrdinary(clamped));
    offset = outcome.offset[seat];
  }
  const bool fires =
      found == Outcome::kFires || (found == Outcome::kOpen && expertOffsetGenerally(*tables_, expert, clamped, offset));
  if (!fires) return {tables_->default_force_n, false};
  return {tables_->output_min + offset, true};
}

void evaluateEveryExpert(const CompiledModel& model, std::span<const double> inputs,
                         std::span<Evaluation> experts) noexcept {
  const ModelTables& tables = model.tables();
  TACTUS_CHECK(inputs.size() == tables.input_min.size() && experts.size() == tables.experts.size());
  std::array<double, kMostInputs> values{};
  if (!tables.clamp(inputs, values)) {
    std::fill(experts.begin(), experts.end(), kNotANumber);
    return;
  }
  const std::span<const double> clamped(values.data(), inputs.size());
  const Program& program = tables.program;
  PointOutcome outcome;
  if (program.usable) program.kernels->point(program, values.data(), outcome);
  const bool ordinary = areOrdinary(clamped);
  for (std::size_t seat = 0; seat < experts.size(); ++seat) {
    const std::size_t expert = program.usable ? program.point.expert_at[seat] : seat;
    const Outcome found = program.usable ? outcomeOf(program, outcome.area[seat], ordinary) : Outcome::kOpen;
    double offset = program.usable ? outcome.offset[seat] : 0;
    const bool fires =
        found == Outcome::kFires || (found == Outcome::kOpen && expertOffsetGenerally(tables, expert, clamped, offset));
    experts[expert] = fires ? Evaluation{tables.output_min + offset, true} : Evaluation{tables.default_force_n, false};
  }
}

bool CompiledModel::strengths(std::size_t expert, std::span<const double> inputs,
                              std::span<double> strengths) const noexcept {
  std::array<double, kMostInputs> clamped;
  if (!tables_->clamp(inputs, clamped)) return false;
  return expertStrengths(*tables_, expert, {clamped.data(), inputs.size()},
                         strengths.first(outputTerms(expert).size()));
}

std::span<const MembershipFunction> CompiledModel::outputTerms(std::size_t expert) const noexcept {
  return tables_->bank(tables_->experts[expert].output_bank);
}

}  // namespace tactus::fuzzy
