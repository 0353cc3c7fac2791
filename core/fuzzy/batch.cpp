#include "core/fuzzy/batch.h"

#include <algorithm>
#include <array>
#include <bit>

#include "core/base/check.h"
#include "core/fuzzy/kernels.h"
#include "core/fuzzy/model_tables.h"

namespace tactus::fuzzy {
namespace {

/// Each point of a batch is looked at again, so nothing that further experts add to it would stay.
constexpr std::uint32_t kAllPoints = ~std::uint32_t{0};
static_assert(kBatch == 32);
constexpr std::size_t kTile = 64;  // batches that go through one chunk of experts before the next chunk
// The first tile is one batch, because it also tells whether experts abstain here; each further one is this many times
// as large.
constexpr std::size_t kGrowth = 8;

using Columns = std::array<const double*, kMostInputs>;

/// One batch on its way, tile by tile. The lanes decide where every expert fires; where one does not, the force is that
/// of the point by itself. Which of both comes first changes the time and no bit.
class Run {
 public:
  Run(const ModelTables& tables, const BatchProgram& program, std::span<const std::span<const double>> varying,
      std::span<const std::size_t> index, std::span<const double> values, BatchResult out) noexcept
      : tables_(tables), program_(program), varying_(varying), index_(index), out_(out) {
    std::copy(values.begin(), values.end(), point_.begin());
  }

  void takeEach() noexcept {
    for (std::size_t p = 0; p < points(); ++p) takeOne(p);
  }

  void takeTiles() noexcept {
    std::size_t first = 0;
    for (std::size_t most = 1; points() - first >= kBatch; most = std::min(most * kGrowth, kTile)) {
      const std::size_t batches = std::min((points() - first) / kBatch, most);
      if (points_first_) {
        takePoints(first, batches * kBatch);
      } else {
        takeLanes(first, batches);
      }
      first += batches * kBatch;
    }
    if (points_first_) {
      takePoints(first, points() - first);
    } else {
      for (; first < points(); ++first) wait(first);
    }
    takeWaiting();
  }

 private:
  std::size_t points() const noexcept { return out_.force_n.size(); }

  /// Whether the next points are evaluated by themselves before the lanes: where at least three quarters of these would
  /// end there anyway. The lanes of several experts cost a third of their points or less, so at that part both orders
  /// cost about the same. One expert's lanes cost a fifth: they always come first.
  bool pointsFirst(std::size_t looked_again_at, std::size_t points) const noexcept {
    return program_.experts.size() > 1 && looked_again_at * 4 >= points * 3;
  }

  /// The lanes first, then the points where some expert may not fire.
  void takeLanes(std::size_t first, std::size_t batches) noexcept {
    std::array<std::uint32_t, kTile> again{};
    for (const BatchChunk& chunk : program_.chunks) {
      std::size_t again_at = 0;
      for (std::size_t b = 0; b < batches; ++b) {
        if (again[b] != kAllPoints) {
          const std::size_t at = first + b * kBatch;
          Columns columns{};
          for (std::size_t k = 0; k < varying_.size(); ++k) columns[index_[k]] = varying_[k].data() + at;
          again[b] |= addChunk(chunk, columns, out_.force_n.data() + at);
        }
        again_at += static_cast<std::size_t>(std::popcount(again[b]));
      }
      points_first_ = pointsFirst(again_at, batches * kBatch);
      if (points_first_ && &chunk != &program_.chunks.back()) return takePoints(first, batches * kBatch);
    }
    std::fill_n(out_.fired.begin() + static_cast<std::ptrdiff_t>(first), batches * kBatch, std::uint8_t{1});
    for (std::size_t b = 0; b < batches; ++b) {
      for (std::uint32_t bits = again[b]; bits != 0; bits &= bits - 1) {
        takeOne(first + b * kBatch + static_cast<std::size_t>(std::countr_zero(bits)));
      }
    }
  }

  /// The points by themselves first, then the lanes for those where every expert fires.
  void takePoints(std::size_t first, std::size_t count) noexcept {
    std::size_t abstentions = 0;
    for (std::size_t p = first; p < first + count; ++p) {
      if (takeOne(p)) {
        ++abstentions;
      } else {
        wait(p);
      }
    }
    points_first_ = pointsFirst(abstentions, count);
  }

  /// Point p goes through the lanes together with others.
  void wait(std::size_t p) noexcept {
    for (std::size_t k = 0; k < varying_.size(); ++k) waiting_inputs_[k][waiting_] = varying_[k][p];
    waiting_at_[waiting_] = p;
    if (++waiting_ == kBatch) takeWaiting();
  }

  void takeWaiting() noexcept {
    if (waiting_ == 0) return;
    // Copies of the first point fill the batch.
    Columns columns{};
    for (std::size_t k = 0; k < varying_.size(); ++k) {
      auto& inputs = waiting_inputs_[k];
      std::fill(inputs.begin() + static_cast<std::ptrdiff_t>(waiting_), inputs.end(), inputs.front());
      columns[index_[k]] = inputs.data();
    }
    std::array<double, kBatch> force_n;
    std::uint32_t again = 0;
    for (const BatchChunk& chunk : program_.chunks) {
      if (again == kAllPoints) break;
      again |= addChunk(chunk, columns, force_n.data());
    }
    for (std::size_t i = 0; i < waiting_; ++i) {
      const std::size_t p = waiting_at_[i];
      if ((again >> i & 1U) != 0) {
        takeOne(p);
      } else {
        out_.force_n[p] = force_n[i];
        out_.fired[p] = 1;
      }
    }
    waiting_ = 0;
  }

  std::uint32_t addChunk(const BatchChunk& chunk, const Columns& columns, double* force_n) const noexcept {
    return tables_.program.kernels->batch(tables_.program, program_, chunk, columns.data(), force_n);
  }

  /// Evaluates point p by itself. True where the lanes would leave it to that.
  bool takeOne(std::size_t p) noexcept {
    for (std::size_t k = 0; k < varying_.size(); ++k) point_[index_[k]] = varying_[k][p];
    bool abstention = false;
    const Evaluation force =
        evaluatePoint(tables_, *tables_.program.kernels, std::span(point_).first(tables_.input_min.size()), abstention);
    out_.force_n[p] = force.force_n;
    out_.fired[p] = force.fired ? 1 : 0;
    return abstention;
  }

  const ModelTables& tables_;
  const BatchProgram& program_;
  std::span<const std::span<const double>> varying_;  ///< as in evaluateBatchOf
  std::span<const std::size_t> index_;
  BatchResult out_;
  std::array<double, kMostInputs> point_{};  ///< with the fixed inputs
  bool points_first_ = false;
  std::size_t waiting_ = 0;
  std::array<std::size_t, kBatch> waiting_at_;
  std::array<std::array<double, kBatch>, kMostInputs> waiting_inputs_;
};

}  // namespace

void evaluateBatchOf(const ModelTables& tables, const BatchProgram& program,
                     std::span<const std::span<const double>> varying, std::span<const std::size_t> index,
                     std::span<const double> values, BatchResult out) noexcept {
  TACTUS_CHECK(out.fired.size() == out.force_n.size() && values.size() == tables.input_min.size());
  for (const auto& column : varying) TACTUS_CHECK(column.size() == out.force_n.size());
  Run run(tables, program, varying, index, values, out);
  if (tables.program.usable) {
    run.takeTiles();
  } else {
    run.takeEach();
  }
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
