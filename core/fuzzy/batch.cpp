#include "core/fuzzy/batch.h"

#include <algorithm>
#include <array>

#include "core/base/check.h"
#include "core/fuzzy/kernels.h"
#include "core/fuzzy/model_tables.h"

namespace tactus::fuzzy {
namespace {

/// Each point of a batch is looked at again, so nothing that further experts add to it would stay.
constexpr std::uint32_t kAllPoints = ~std::uint32_t{0};
static_assert(kBatch == 32);
constexpr std::size_t kTile = 64;  // batches that go through one chunk of experts before the next chunk

/// One point of a batch: `varying` and `index` as in evaluateBatchOf, the fixed inputs in `values`.
Evaluation evaluateOne(const ModelTables& tables, std::span<const std::span<const double>> varying,
                       std::span<const std::size_t> index, std::span<const double> values, std::size_t p) noexcept {
  std::array<double, kMostInputs> point;
  std::copy(values.begin(), values.end(), point.begin());
  for (std::size_t k = 0; k < varying.size(); ++k) point[index[k]] = varying[k][p];
  return evaluatePoint(tables, *tables.program.kernels, {point.data(), values.size()});
}

}  // namespace

void evaluateBatchOf(const ModelTables& tables, const BatchProgram& program,
                     std::span<const std::span<const double>> varying, std::span<const std::size_t> index,
                     std::span<const double> values, BatchResult out) noexcept {
  const std::size_t points = out.force_n.size();
  TACTUS_CHECK(out.fired.size() == points);
  for (const auto& column : varying) TACTUS_CHECK(column.size() == points);
  const auto set_one = [&](std::size_t p) {
    const Evaluation force = evaluateOne(tables, varying, index, values, p);
    out.force_n[p] = force.force_n;
    out.fired[p] = force.fired ? 1 : 0;
  };
  if (!tables.program.usable) {
    for (std::size_t p = 0; p < points; ++p) set_one(p);
    return;
  }
  const auto kernel = tables.program.kernels->batch;
  std::array<const double*, kMostInputs> columns{};
  const auto look_again_at = [&](std::size_t first, std::uint32_t points_of_batch) {
    for (std::size_t p = first; points_of_batch != 0; ++p, points_of_batch >>= 1U) {
      if ((points_of_batch & 1U) != 0) set_one(p);
    }
  };
  std::fill(out.fired.begin(), out.fired.end(), std::uint8_t{1});
  std::size_t first = 0;
  while (points - first >= kBatch) {
    const std::size_t batches = std::min((points - first) / kBatch, kTile);
    std::array<std::uint32_t, kTile> again{};
    for (const BatchChunk& chunk : program.chunks) {
      for (std::size_t b = 0; b < batches; ++b) {
        if (again[b] == kAllPoints) continue;
        const std::size_t at = first + b * kBatch;
        for (std::size_t k = 0; k < varying.size(); ++k) columns[index[k]] = varying[k].data() + at;
        again[b] |= kernel(tables.program, program, chunk, columns.data(), out.force_n.data() + at);
      }
    }
    for (std::size_t b = 0; b < batches; ++b) look_again_at(first + b * kBatch, again[b]);
    first += batches * kBatch;
  }
  const std::size_t left = points - first;
  if (left == 0) return;
  // What is left fills a batch with copies of its first point.
  std::array<std::array<double, kBatch>, kMostInputs> padded;
  std::array<double, kBatch> force_n;
  for (std::size_t k = 0; k < varying.size(); ++k) {
    const auto rest = varying[k].subspan(first);
    std::fill(std::copy(rest.begin(), rest.end(), padded[k].begin()), padded[k].end(), rest.front());
    columns[index[k]] = padded[k].data();
  }
  std::uint32_t again = 0;
  for (const BatchChunk& chunk : program.chunks) {
    if (again == kAllPoints) break;
    again |= kernel(tables.program, program, chunk, columns.data(), force_n.data());
  }
  std::copy_n(force_n.begin(), left, out.force_n.begin() + static_cast<std::ptrdiff_t>(first));
  look_again_at(first, again & ((std::uint32_t{1} << left) - 1));
}

void evaluateBatch(const CompiledModel& model, std::span<const std::span<const double>> inputs,
                   BatchResult out) noexcept {
  constexpr std::array<std::size_t, kMostInputs> kEvery = {0, 1, 2, 3, 4, 5, 6, 7};
  TACTUS_CHECK(inputs.size() == model.inputCount());
  const std::array<double, kMostInputs> unused{};
  const ModelTables& tables = model.tables();
  evaluateBatchOf(tables, tables.program.batch, inputs, std::span(kEvery).first(inputs.size()),
                  std::span(unused).first(inputs.size()), out);
}

}  // namespace tactus::fuzzy
