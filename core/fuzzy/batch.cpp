#include "core/fuzzy/batch.h"

#include <algorithm>
#include <array>

#include "core/base/check.h"
#include "core/fuzzy/kernels.h"
#include "core/fuzzy/model_tables.h"

namespace tactus::fuzzy {
namespace {

/// One point of a batch: `varying` and `index` as in evaluateBatchOf, the fixed inputs in `values`.
Evaluation evaluateOne(const ModelTables& tables, const Program& program,
                       std::span<const std::span<const double>> varying, std::span<const std::size_t> index,
                       std::span<const double> values, std::size_t p) noexcept {
  std::array<double, kMostInputs> point;
  std::copy(values.begin(), values.end(), point.begin());
  for (std::size_t k = 0; k < varying.size(); ++k) point[index[k]] = varying[k][p];
  return evaluateProgram(tables, program, {point.data(), values.size()});
}

}  // namespace

void evaluateBatchOf(const ModelTables& tables, const Program& program,
                     std::span<const std::span<const double>> varying, std::span<const std::size_t> index,
                     std::span<const double> values, BatchResult out) noexcept {
  const std::size_t points = out.force_n.size();
  TACTUS_CHECK(out.fired.size() == points);
  for (const auto& column : varying) TACTUS_CHECK(column.size() == points);
  const auto set_one = [&](std::size_t p) {
    const Evaluation force = evaluateOne(tables, program, varying, index, values, p);
    out.force_n[p] = force.force_n;
    out.fired[p] = force.fired ? 1 : 0;
  };
  // What does not fill a batch goes point by point.
  std::size_t first = 0;
  const auto kernel = program.usable ? program.kernels->batch : nullptr;
  std::array<const double*, kMostInputs> columns{};
  BatchOutcome outcome;
  for (; program.usable && first + kBatch <= points; first += kBatch) {
    for (std::size_t k = 0; k < varying.size(); ++k) columns[k] = varying[k].data() + first;
    kernel(program, columns.data(), outcome);
    std::copy_n(outcome.force_n, kBatch, out.force_n.begin() + static_cast<std::ptrdiff_t>(first));
    std::fill_n(out.fired.begin() + static_cast<std::ptrdiff_t>(first), kBatch, std::uint8_t{1});
    for (std::size_t p = 0; outcome.look_again >> p != 0; ++p) {
      if ((outcome.look_again >> p & 1U) != 0) set_one(first + p);
    }
  }
  for (; first < points; ++first) set_one(first);
}

void evaluateBatch(const CompiledModel& model, std::span<const std::span<const double>> inputs,
                   BatchResult out) noexcept {
  constexpr std::array<std::size_t, kMostInputs> kEvery = {0, 1, 2, 3, 4, 5, 6, 7};
  TACTUS_CHECK(inputs.size() == model.inputCount());
  const std::array<double, kMostInputs> unused{};
  const ModelTables& tables = model.tables();
  evaluateBatchOf(tables, tables.program, inputs, std::span(kEvery).first(inputs.size()),
                  std::span(unused).first(inputs.size()), out);
}

}  // namespace tactus::fuzzy
