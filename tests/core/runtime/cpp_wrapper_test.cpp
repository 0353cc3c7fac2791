// The C++ wrapper: what moves, what throws, the same numbers.
#include <array>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "tactus/tactus.hpp"

#include "tests/core/runtime/runtime_models.h"

namespace tactus {
namespace {

static_assert(std::is_nothrow_move_constructible_v<Model> && !std::is_copy_constructible_v<Model>);
static_assert(std::is_nothrow_move_constructible_v<Scene> && !std::is_copy_constructible_v<Scene>);
static_assert(std::is_nothrow_move_constructible_v<Tube> && !std::is_copy_constructible_v<Tube>);
static_assert(std::is_base_of_v<std::runtime_error, Error>);

Model ngt() { return Model::read(model_io::formatModel(support::s4Shifted())); }

TEST(CppWrapper, GivesTheForcesOfTheCInterface) {
  const Model model = ngt();
  const auto handle = support::handleOf(support::s4Shifted());
  const std::array<double, 4> point = {1, 45, 30, 30};
  const double wanted_n = tactus_force(handle.get(), point.data(), nullptr);
  bool fired = false;
  EXPECT_EQ(model.force({1, 45, 30, 30}, &fired), wanted_n);
  EXPECT_TRUE(fired);
  EXPECT_EQ(model.force(point), wanted_n);
  EXPECT_EQ(model.force(std::vector<double>(point.begin(), point.end())), wanted_n);
  EXPECT_EQ(model.expertForce(0, {1, 45, 30, 30}), wanted_n);
  EXPECT_EQ(model.batch(std::vector<double>{1, 45, 30, 30, 1, 45, 30, 30}).size(), 2U);
  const Scene scene = model.scene({{"neck_flexion", 45.0}, {"lubrication", 1.0}});
  EXPECT_EQ(scene.inputs(), 2U);
  EXPECT_EQ(scene.force({30, 30}), wanted_n);
  EXPECT_EQ(model.scene(std::map<std::string, double>{{"lubrication", 1}}).inputs(), 3U);
  EXPECT_EQ(model.inputId(2), "depth");
  EXPECT_EQ(model.inputUnit(2), "mm");
  EXPECT_EQ(model.inputId(9), "");
}

TEST(CppWrapper, TellsWhatTheModelSays) {
  const Model model = ngt();
  EXPECT_EQ(model.sha256().size(), 64U);
  EXPECT_EQ(model.inputTerms(2), support::s4Shifted().inputs[2].terms.size());
  EXPECT_EQ(model.termId(2, 0), "nasal_cavity");
  EXPECT_EQ(model.termId(2, 99), "");
  EXPECT_EQ(model.membership(0, 2, 0, 0), 1);
  EXPECT_GT(model.renderer().stiffness_n_mm, 0);
  const double outside[] = {2, 45, 30, -1};
  EXPECT_TRUE(model.clamped(outside));
  EXPECT_EQ(model.clampedInputs(outside), 9U);
}

TEST(CppWrapper, ATubeIsCopiedSavedAndBounded) {
  const Scene scene = ngt().scene({{"lubrication", 1.0}, {"neck_flexion", 45.0}});
  Tube tube(scene);
  EXPECT_THROW(tube.limits(-1), Error);
  tube.limits(0.1, 1.5);
  for (int i = 0; i < 300; ++i) tube.step(0.05 * i, true, 0.001);
  Tube copy = tube.copy();
  const std::vector<unsigned char> bytes = tube.save();
  Tube loaded(scene);
  ASSERT_TRUE(loaded.load(bytes));
  const Feel wanted = tube.step(16, true, 0.001);
  EXPECT_EQ(wanted.limited, 1);
  EXPECT_EQ(wanted.region, 0);
  EXPECT_EQ(copy.step(16, true, 0.001).force_n, wanted.force_n);
  EXPECT_EQ(loaded.step(16, true, 0.001).force_n, wanted.force_n);
  EXPECT_FALSE(loaded.load({1, 2, 3}));
  tactus_status status = TACTUS_OK;
  tube.step(16, true, 5, &status);
  EXPECT_EQ(status, TACTUS_BAD_ARGUMENT);
  const Tube gone = std::move(tube);
  EXPECT_THROW(tube.copy(), Error);  // NOLINT(bugprone-use-after-move): what this line is about
  EXPECT_TRUE(tube.save().empty());  // NOLINT(bugprone-use-after-move)
}

TEST(CppWrapper, ThrowsOneSentence) {
  try {
    Model::open("/no/such/model.json");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), TACTUS_BAD_FILE);
    EXPECT_NE(std::string(error.what()).find("/no/such/model.json"), std::string::npos);
  }
  const Model model = ngt();
  EXPECT_THROW(model.force({1, 2, 3}), Error);
  EXPECT_THROW(model.expertForce(1, {1, 45, 30, 30}), Error);
  EXPECT_THROW(model.batch(std::vector<double>{1, 2, 3}), Error);
  EXPECT_THROW(model.scene({{"swallow", 1.0}}), Error);
  EXPECT_THROW(Tube(model.scene({{"lubrication", 1.0}})), Error);
  EXPECT_EQ(model.scene({{"lubrication", 2.0}}).warning(), "'lubrication': found 2, taken as 1");
}

TEST(CppWrapper, WhatWasMovedFromIsEmpty) {
  Model model = ngt();
  Scene scene = model.scene({{"lubrication", 1.0}, {"neck_flexion", 45.0}});
  Tube tube(scene);
  const Model taken = std::move(model);
  EXPECT_EQ(model.inputs(), 0U);  // NOLINT(bugprone-use-after-move): what this test is about
  EXPECT_EQ(taken.inputs(), 4U);
  const Scene kept = std::move(scene);
  EXPECT_EQ(scene.inputs(), 0U);  // NOLINT(bugprone-use-after-move)
  Tube held = std::move(tube);
  EXPECT_EQ(tube.step(1, true, 0.001).force_n, 0);  // NOLINT(bugprone-use-after-move)
  held.place(100);
  held.scene(kept);
  double force_n = 0;
  for (int i = 0; i < 300; ++i) force_n = held.step(0.05 * i, true, 0.001).force_n;
  EXPECT_GT(force_n, 0);
}

}  // namespace
}  // namespace tactus
