// One point, batch and scene are three ways to the same force; every instruction set gives the same bits.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>

#include "core/base/random.h"
#include "core/fuzzy/batch.h"
#include "core/fuzzy/kernels.h"
#include "core/fuzzy/model_tables.h"
#include "core/fuzzy/scene.h"

#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::fuzzy {
namespace {

using Columns = std::vector<std::vector<double>>;

std::vector<std::span<const double>> spans(const Columns& columns) { return {columns.begin(), columns.end()}; }

/// Four ulp of the force; where terms are a few ulps wide the two summation orders may differ by the evaluator's bound.
void expectSameForce(const ForceModel& model, const Evaluation& one, double force_n, bool fired) {
  ASSERT_EQ(one.fired, fired);
  const double ulp =
      std::nextafter(std::abs(one.force_n), std::numeric_limits<double>::infinity()) - std::abs(one.force_n);
  ASSERT_NEAR(one.force_n, force_n, 4 * ulp + 1e-12 * (model.output.max - model.output.min));
}

void compareEntryPoints(const ForceModel& model, base::Random& random, std::size_t points) {
  const auto compiled = compile(model);
  ASSERT_TRUE(compiled.has_value()) << compiled.error().message();
  std::vector<std::optional<double>> fixed(model.inputs.size());
  const auto anywhere = support::randomPoint(random, model);
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (random.below(2) == 0) fixed[i] = anywhere[i];
  }
  const auto scene = Scene::specialize(*compiled, fixed);
  ASSERT_TRUE(scene.has_value());

  Columns columns(model.inputs.size(), std::vector<double>(points));
  Columns free_columns;
  for (std::size_t p = 0; p < points; ++p) {
    const auto point = support::randomPoint(random, model);
    for (std::size_t i = 0; i < point.size(); ++i) columns[i][p] = fixed[i].value_or(point[i]);
  }
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (!fixed[i]) free_columns.push_back(columns[i]);
  }
  std::vector<double> force(points);
  std::vector<double> scene_force(points);
  std::vector<std::uint8_t> fired(points);
  std::vector<std::uint8_t> scene_fired(points);
  evaluateBatch(*compiled, spans(columns), {force, fired});
  scene->evaluateBatch(spans(free_columns), {scene_force, scene_fired});
  for (std::size_t p = 0; p < points; ++p) {
    SCOPED_TRACE("point " + std::to_string(p));
    std::vector<double> point;
    std::vector<double> free_point;
    for (std::size_t i = 0; i < fixed.size(); ++i) {
      point.push_back(columns[i][p]);
      if (!fixed[i]) free_point.push_back(columns[i][p]);
    }
    const auto one = compiled->evaluate(point);
    expectSameForce(model, one, force[p], fired[p] != 0);
    expectSameForce(model, one, scene_force[p], scene_fired[p] != 0);
    const auto in_scene = scene->evaluate(free_point);
    expectSameForce(model, one, in_scene.force_n, in_scene.fired);
  }
}

TEST(EntryPoints, AgreeOnRandomModels) {
  base::Random random(31);
  for (int m = 0; m < 3000; ++m) {
    SCOPED_TRACE("model " + std::to_string(m));
    compareEntryPoints(support::randomModel(random, {.gaussians = m % 5 == 0, .adversarial = m % 2 == 0}), random,
                       1 + m % 19);
    if (HasFatalFailure()) return;
  }
}

TEST(EntryPoints, AgreeToFourUlpOnTheNgtModel) {
  base::Random random(32);
  for (const auto& model : {support::s4AsPrinted(), support::s4Shifted(), support::s4FiveRegions()}) {
    for (const auto implication : {Implication::kClip, Implication::kScale}) {
      ForceModel one = model;
      one.implication = implication;
      // The range is 1.1 N, so the second part of the bound is a few thousand ulp; here four must do.
      const auto compiled = compile(one);
      ASSERT_TRUE(compiled->tables().program.usable);
      Columns columns(4, std::vector<double>(1000));
      for (std::size_t i = 0; i < 4; ++i) {
        for (double& x : columns[i]) x = random.uniform(one.inputs[i].min, one.inputs[i].max);
      }
      std::vector<double> force(1000);
      std::vector<std::uint8_t> fired(1000);
      evaluateBatch(*compiled, spans(columns), {force, fired});
      for (std::size_t p = 0; p < 1000; ++p) {
        const std::vector<double> point = {columns[0][p], columns[1][p], columns[2][p], columns[3][p]};
        const auto here = compiled->evaluate(point);
        ASSERT_EQ(here.fired, fired[p] != 0);
        const auto alone = compiled->evaluateExpert(0, point);
        // Forces lie between .12 and .93 N, where an ulp is at most 1.1e-16.
        ASSERT_NEAR(here.force_n, force[p], 4.5e-16);
        ASSERT_NEAR(here.force_n, alone.force_n, 4.5e-16);
      }
    }
  }
}

TEST(EntryPoints, EveryInstructionSetGivesTheSameBits) {
  base::Random random(33);
  const auto sets = supportedKernels();
  if (sets.size() < 2) GTEST_SKIP() << "this processor has one instruction set";
  int usable = 0;
  for (int m = 0; m < 1500; ++m) {
    const ForceModel model = m % 3 == 0 ? support::s4FiveRegions()
                                        : support::randomModel(random, {.gaussians = false, .adversarial = m % 2 == 0});
    const auto compiled = compile(model);
    const auto& tables = compiled->tables();
    if (!tables.program.usable) continue;
    ++usable;
    const auto inputs = support::randomPoint(random, model);
    std::vector<double> clamped(inputs.size());
    ASSERT_TRUE(tables.clamp(inputs, clamped));
    Columns columns(inputs.size(), std::vector<double>(kBatch));
    std::array<const double*, kMostInputs> pointers{};
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      for (double& x : columns[i]) x = random.uniform(tables.input_min[i], tables.input_max[i]);
      columns[i][0] = clamped[i];
      pointers[i] = columns[i].data();
    }
    PointOutcome first;
    std::array<double, kBatch> first_batch;
    sets[0].point(tables.program, clamped.data(), first);
    const auto run = [&](const Kernels& set, std::array<double, kBatch>& force_n) {
      std::uint32_t look_again = 0;
      for (const BatchChunk& chunk : tables.program.batch.chunks) {
        look_again |= set.batch(tables.program, tables.program.batch, chunk, pointers.data(), force_n.data());
      }
      return look_again;
    };
    const std::uint32_t look_again = run(sets[0], first_batch);
    for (const auto& set : sets.subspan(1)) {
      PointOutcome other;
      std::array<double, kBatch> other_batch;
      set.point(tables.program, clamped.data(), other);
      ASSERT_EQ(run(set, other_batch), look_again);
      for (std::size_t e = 0; e < tables.experts.size(); ++e) {
        ASSERT_EQ(std::bit_cast<std::uint64_t>(first.area[e]), std::bit_cast<std::uint64_t>(other.area[e])) << set.name;
        if (first.area[e] == 0) continue;
        ASSERT_EQ(std::bit_cast<std::uint64_t>(first.offset[e]), std::bit_cast<std::uint64_t>(other.offset[e]))
            << set.name;
      }
      for (std::size_t p = 0; p < kBatch; ++p) {
        if ((look_again >> p & 1U) != 0) continue;
        ASSERT_EQ(std::bit_cast<std::uint64_t>(first_batch[p]), std::bit_cast<std::uint64_t>(other_batch[p]));
      }
    }
  }
  EXPECT_GT(usable, 500) << "too few models have a fast form";
}

/// `count` variations of S4 who leave out every `missing`th item, if it is not 0, and mean what they say by other
/// words.
ForceModel manyExperts(int count, int missing) {
  ForceModel model = support::s4FiveRegions();
  const Expert s4 = model.experts.front();
  model.experts.clear();
  for (int e = 0; e < count; ++e) {
    Expert expert = s4;
    expert.id = "E" + std::to_string(e);
    for (std::size_t r = 0; r < expert.rules.size(); ++r) {
      const auto shift = static_cast<std::size_t>(e) * 7 + r * 3;
      expert.rules[r].then = model.output.terms[shift % 5].id;
      if (missing > 0 && (r + static_cast<std::size_t>(e)) % static_cast<std::size_t>(missing) == 0) {
        expert.rules[r].enabled = false;
      }
    }
    model.experts.push_back(std::move(expert));
  }
  return model;
}

// The tables of so many experts go through in chunks: all points of a tile for one chunk before the next.
TEST(EntryPoints, ManyExpertsInChunks) {
  for (const int missing : {0, 3}) {
    const ForceModel model = manyExperts(600, missing);
    const auto compiled = compile(model);
    const auto& program = compiled->tables().program;
    ASSERT_GE(program.batch.chunks.size(), 2U);
    std::uint32_t next = 0;
    for (const BatchChunk& chunk : program.batch.chunks) {
      EXPECT_EQ(chunk.experts.first, next);
      next = chunk.experts.end();
    }
    EXPECT_EQ(next, 600U);

    constexpr std::size_t kPoints = 64 * kBatch + 3 * kBatch + 5;  // a tile, a part of one, and what fills no batch
    base::Random random(4);
    Columns columns(model.inputs.size(), std::vector<double>(kPoints));
    for (std::size_t p = 0; p < kPoints; ++p) {
      const auto point = support::randomPoint(random, model);
      for (std::size_t i = 0; i < point.size(); ++i) columns[i][p] = point[i];
    }
    std::vector<double> force(kPoints);
    std::vector<std::uint8_t> fired(kPoints);
    evaluateBatch(*compiled, spans(columns), {force, fired});
    for (std::size_t p = 0; p < kPoints; p += 13) {
      std::vector<double> point;
      for (const auto& column : columns) point.push_back(column[p]);
      expectSameForce(model, compiled->evaluate(point), force[p], fired[p] != 0);
      // The same bits in a batch of its own: neighbors and tiles do not matter.
      Columns single;
      for (const double x : point) single.push_back({x});
      double alone = 0;
      std::uint8_t alone_fired = 0;
      evaluateBatch(*compiled, spans(single), {{&alone, 1}, {&alone_fired, 1}});
      EXPECT_EQ(std::bit_cast<std::uint64_t>(alone), std::bit_cast<std::uint64_t>(force[p]));
    }
  }
}

TEST(EntryPoints, ABatchKeepsThePolicies) {
  const auto compiled = compile(support::s4AsPrinted());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  Columns columns = {{1, 1, 1, 7, 1}, {60, nan, 60, 60, 60}, {130, 30, 30, 30, -inf}, {50, 50, -9, 50, 50}};
  for (auto& column : columns) column.resize(3 * kBatch + 1, 30);
  std::vector<double> force(columns[0].size());
  std::vector<std::uint8_t> fired(force.size());
  evaluateBatch(*compiled, spans(columns), {force, fired});
  EXPECT_EQ(std::vector<std::uint8_t>(fired.begin(), fired.begin() + 5), (std::vector<std::uint8_t>{0, 0, 1, 1, 0}));
  EXPECT_EQ(force[0], 0);
  EXPECT_TRUE(std::isnan(force[1]) && std::isnan(force[4]));
  EXPECT_NEAR(force[2], compiled->evaluate(std::vector<double>{1, 60, 30, 0}).force_n, 1e-15);
  EXPECT_NEAR(force[3], compiled->evaluate(std::vector<double>{1, 60, 30, 50}).force_n, 1e-15);
}

TEST(EntryPoints, ASceneRefusesAValueThatIsNoNumber) {
  const auto compiled = compile(support::s4AsPrinted());
  const std::vector<std::optional<double>> fixed = {1, std::numeric_limits<double>::infinity(), std::nullopt,
                                                    std::nullopt};
  EXPECT_FALSE(Scene::specialize(*compiled, fixed).has_value());
}

}  // namespace
}  // namespace tactus::fuzzy
