// A batch evaluates points by themselves before its lanes where most of them end there: fewer lanes, the same bits.
#include <algorithm>
#include <bit>
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/fuzzy/batch.h"
#include "core/fuzzy/kernels.h"
#include "core/fuzzy/model_tables.h"

#include "tests/support/ngt_model.h"

namespace tactus::fuzzy {
namespace {

/// `count` experts with S4's rules, of which each is missing with this chance.
ForceModel expertsWithGaps(base::Random& random, int count, int percent) {
  ForceModel model = support::s4FiveRegions();
  const Expert s4 = model.experts.front();
  model.experts.clear();
  for (int e = 0; e < count; ++e) {
    Expert& expert = model.experts.emplace_back(s4);
    expert.id = "E" + std::to_string(e);
    for (Rule& rule : expert.rules) rule.enabled = random.below(100) >= percent;
    expert.rules[static_cast<std::size_t>(e) % expert.rules.size()].enabled = true;
  }
  return model;
}

long batches = 0;

std::uint32_t countedBatch(const Program& model, const BatchProgram& program, const BatchChunk& chunk,
                           const double* const* columns, double* force_n) noexcept {
  ++batches;
  return activeKernels().batch(model, program, chunk, columns, force_n);
}

TEST(BatchOrder, TheLanesStayOutWhereEveryPointMeetsAnAbstention) {
  static Kernels kernels = activeKernels();
  kernels.batch = countedBatch;
  base::Random random(41);
  const ForceModel model = expertsWithGaps(random, 40, 90);
  CompiledModel compiled = *compile(model);
  const_cast<Program&>(compiled.tables().program).kernels = &kernels;
  constexpr std::size_t kPoints = 100 * kBatch;
  std::vector<std::vector<double>> columns(4, std::vector<double>(kPoints));
  for (std::size_t i = 0; i < 4; ++i) {
    for (double& x : columns[i]) x = random.uniform(model.inputs[i].min, model.inputs[i].max);
  }
  const std::vector<std::span<const double>> inputs(columns.begin(), columns.end());
  std::vector<double> force_n(kPoints);
  std::vector<std::uint8_t> fired(kPoints);
  batches = 0;
  evaluateBatch(compiled, inputs, {force_n, fired});
  // The first batch tells; no point of the others goes through the lanes.
  EXPECT_LE(batches, 2);
}

/// Each force of a long batch has the bits that it has in a batch of its own, whether an expert abstains there or not.
void expectTheForcesOfSinglePoints(base::Random& random, const ForceModel& model, const CompiledModel& compiled,
                                   std::size_t most_points) {
  const std::size_t points = most_points - static_cast<std::size_t>(random.below(40));
  std::vector<std::vector<double>> columns(4, std::vector<double>(points));
  for (std::size_t i = 0; i < 4; ++i) {
    for (double& x : columns[i]) x = random.uniform(model.inputs[i].min, model.inputs[i].max);
    // Long stretches with and without abstentions, so that the order changes on the way.
    if (i == 2) std::sort(columns[i].begin(), columns[i].end());
  }
  const std::vector<std::span<const double>> inputs(columns.begin(), columns.end());
  std::vector<double> force_n(points);
  std::vector<std::uint8_t> fired(points);
  evaluateBatch(compiled, inputs, {force_n, fired});
  for (std::size_t p = 0; p < points; ++p) {
    std::vector<std::span<const double>> alone;
    std::vector<double> point;
    for (const auto& column : columns) {
      alone.push_back(std::span(column).subspan(p, 1));
      point.push_back(column[p]);
    }
    double alone_n = 0;
    std::uint8_t alone_fired = 0;
    evaluateBatch(compiled, alone, {{&alone_n, 1}, {&alone_fired, 1}});
    ASSERT_EQ(std::bit_cast<std::uint64_t>(alone_n), std::bit_cast<std::uint64_t>(force_n[p]));
    ASSERT_EQ(alone_fired, fired[p]);
    bool every_one_fires = true;
    for (std::size_t e = 0; e < model.experts.size() && every_one_fires; ++e)
      every_one_fires = compiled.evaluateExpert(e, point).fired;
    if (every_one_fires) continue;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(compiled.evaluate(point).force_n), std::bit_cast<std::uint64_t>(force_n[p]));
  }
}

// An order that follows the points must not show in the forces.
TEST(BatchOrder, TheForceOfAPointDoesNotDependOnItsNeighbors) {
  base::Random random(42);
  for (const int percent : {5, 30, 50, 70, 90}) {
    for (const int count : {1, 4, 9}) {
      const ForceModel model = expertsWithGaps(random, count, percent);
      expectTheForcesOfSinglePoints(random, model, *compile(model), 3040);
    }
  }
}

// After the first chunk of the experts the order may change, in the middle of a tile.
TEST(BatchOrder, TheForceOfAPointDoesNotDependOnItsNeighborsInAModelOfSeveralChunks) {
  base::Random random(43);
  for (const int percent : {5, 60}) {
    const ForceModel model = expertsWithGaps(random, 700, percent);
    const CompiledModel compiled = *compile(model);
    ASSERT_GT(compiled.tables().program.batch.chunks.size(), 1U);
    expectTheForcesOfSinglePoints(random, model, compiled, 1200);
  }
}

}  // namespace
}  // namespace tactus::fuzzy
