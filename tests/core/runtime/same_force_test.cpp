// The C interface gives the forces of the evaluator, bit for bit.
#include <bit>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <optional>
#include <span>
#include <vector>

#include "core/base/random.h"
#include "core/fuzzy/batch.h"
#include "core/fuzzy/scene.h"

#include "tests/core/runtime/runtime_models.h"
#include "tests/support/random_model.h"

namespace tactus {
namespace {

constexpr int kModels = 150;
constexpr std::size_t kComparedPoints = 2100;  // three tiles of the interface, and a rest

void expectSame(double found, int fired, fuzzy::Evaluation wanted) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(found), std::bit_cast<std::uint64_t>(wanted.force_n));
  EXPECT_EQ(fired != 0, wanted.fired);
}

/// `count` points one after another, and as one array per input.
struct Points {
  std::vector<double> rows;
  std::vector<std::vector<double>> columns;
  std::vector<std::span<const double>> spans;

  Points(base::Random& random, const fuzzy::ForceModel& model, std::size_t count) : columns(model.inputs.size()) {
    for (std::size_t p = 0; p < count; ++p) {
      auto point = support::randomPoint(random, model);
      if (random.below(500) == 0) point[random.below(point.size())] = std::nan("");
      for (std::size_t i = 0; i < point.size(); ++i) columns[i].push_back(point[i]);
      rows.insert(rows.end(), point.begin(), point.end());
    }
    spans.assign(columns.begin(), columns.end());
  }
};

TEST(RuntimeForce, OnePointAndOneExpertHaveTheBitsOfTheEvaluator) {
  base::Random random(1);
  for (int m = 0; m < kModels; ++m) {
    const auto model = support::randomModel(random, {.gaussians = m % 3 == 0});
    const auto compiled = fuzzy::compile(model);
    const auto handle = support::handleOf(model);
    ASSERT_TRUE(compiled && handle);
    ASSERT_EQ(tactus_model_inputs(handle.get()), model.inputs.size());
    ASSERT_EQ(tactus_model_experts(handle.get()), model.experts.size());
    for (int p = 0; p < 50; ++p) {
      const auto point = support::randomPoint(random, model);
      int fired = 7;
      const double force_n = tactus_force(handle.get(), point.data(), &fired);
      expectSame(force_n, fired, compiled->evaluate(point));
      for (std::size_t e = 0; e < model.experts.size(); ++e) {
        const double expert_n = tactus_expert_force(handle.get(), e, point.data(), &fired);
        expectSame(expert_n, fired, compiled->evaluateExpert(e, point));
      }
    }
  }
}

TEST(RuntimeForce, ABatchHasTheBitsOfTheBatch) {
  base::Random random(2);
  for (int m = 0; m < kModels / 5; ++m) {
    const auto model = support::randomModel(random);
    const auto compiled = fuzzy::compile(model);
    const auto handle = support::handleOf(model);
    ASSERT_TRUE(compiled && handle);
    const Points points(random, model, kComparedPoints);
    std::vector<double> wanted_n(kComparedPoints), found_n(kComparedPoints), alone_n(kComparedPoints);
    std::vector<std::uint8_t> wanted(kComparedPoints), found(kComparedPoints, 9);
    fuzzy::evaluateBatch(*compiled, points.spans, {wanted_n, wanted});
    tactus_force_batch(handle.get(), points.rows.data(), kComparedPoints, found_n.data(), found.data());
    tactus_force_batch(handle.get(), points.rows.data(), kComparedPoints, alone_n.data(), nullptr);
    EXPECT_EQ(found, wanted);
    for (std::size_t p = 0; p < kComparedPoints; ++p) {
      expectSame(found_n[p], found[p], {wanted_n[p], wanted[p] != 0});
      expectSame(alone_n[p], found[p], {found_n[p], found[p] != 0});
    }
  }
}

TEST(RuntimeForce, AScenePointHasTheBitsOfTheModelsPoint) {
  base::Random random(3);
  for (int m = 0; m < kModels; ++m) {
    const auto model = support::randomModel(random);
    const auto compiled = fuzzy::compile(model);
    const auto at = support::randomPoint(random, model);
    std::vector<std::optional<double>> wanted_fixed(at.size());
    std::vector<std::size_t> fixed;
    std::vector<double> values;
    // From the last input to the first: the order of `fixed` does not matter.
    for (std::size_t i = at.size(); i-- > 0;) {
      if (random.below(2) == 0) continue;
      wanted_fixed[i] = at[i];
      fixed.push_back(i);
      values.push_back(at[i]);
    }
    tactus_scene* made = nullptr;
    {
      // The model goes before its scene.
      const auto handle = support::handleOf(model);
      ASSERT_EQ(tactus_scene_make(handle.get(), fixed.data(), values.data(), fixed.size(), &made, nullptr, 0),
                TACTUS_OK);
    }
    const support::SceneHandle scene(made);
    ASSERT_EQ(tactus_scene_inputs(made), at.size() - fixed.size());
    const auto wanted_scene = fuzzy::Scene::specialize(*compiled, wanted_fixed);
    ASSERT_TRUE(wanted_scene);
    for (int p = 0; p < 30; ++p) {
      auto point = support::randomPoint(random, model);
      std::vector<double> free;
      for (std::size_t i = 0; i < at.size(); ++i) {
        if (wanted_fixed[i])
          point[i] = at[i];
        else
          free.push_back(point[i]);
      }
      int fired = 7;
      const double force_n = tactus_scene_force(made, free.data(), &fired);
      expectSame(force_n, fired, compiled->evaluate(point));
      double batch_n = -1;
      unsigned char batch_fired = 9;
      tactus_scene_force_batch(made, free.data(), 1, &batch_n, &batch_fired);
      std::vector<std::span<const double>> columns;
      for (const double& value : free) columns.emplace_back(&value, 1);
      double wanted_n = 0;
      std::uint8_t wanted = 0;
      wanted_scene->evaluateBatch(columns, {{&wanted_n, 1}, {&wanted, 1}});
      expectSame(batch_n, batch_fired, {wanted_n, wanted != 0});
    }
  }
}

TEST(RuntimeForce, WhatIsClampedIsTold) {
  const auto handle = support::handleOf(support::s4Shifted());
  const double inside[] = {1, 45, 30, 30};
  const double outside[] = {1.5, 45, -2, 30};
  const double border[] = {0, 90, 600, 0};
  const double none[] = {std::nan(""), 45, 30, -INFINITY};
  EXPECT_EQ(tactus_clamped(handle.get(), inside), 0);
  EXPECT_EQ(tactus_clamped(handle.get(), outside), 1);
  EXPECT_EQ(tactus_clamped(handle.get(), border), 0);
  EXPECT_EQ(tactus_clamped(handle.get(), none), 1);
  EXPECT_EQ(tactus_clamped_inputs(handle.get(), inside), 0U);
  EXPECT_EQ(tactus_clamped_inputs(handle.get(), outside), 0b101U);
  EXPECT_EQ(tactus_clamped_inputs(handle.get(), border), 0U);
  EXPECT_EQ(tactus_clamped_inputs(handle.get(), none), 0b1000U);
  const double at_the_end[] = {1, 45, 0, 30};
  EXPECT_EQ(tactus_force(handle.get(), outside, nullptr), tactus_force(handle.get(), at_the_end, nullptr));
}

}  // namespace
}  // namespace tactus
