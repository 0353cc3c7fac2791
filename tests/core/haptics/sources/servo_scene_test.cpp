#include "core/haptics/sources/servo_scene.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "core/fuzzy/compiled_model.h"

#include "tests/core/haptics/scenes.h"

namespace tactus::haptics {
namespace {

using base::ErrorCode;

Conditions between() { return {{"lubrication", 0.3}, {"neck_flexion", 50}}; }

base::Error refusal(const fuzzy::ForceModel& model, const Conditions& conditions, const SceneSettings& settings = {}) {
  const auto scene = ServoScene::make(model, conditions, settings);
  EXPECT_FALSE(scene);
  return scene ? base::Error{} : scene.error();
}

TEST(ServoScene, IsTheModelAtItsConditions) {
  const auto model = support::s4Shifted();
  const auto compiled = fuzzy::compile(model);
  const auto scene = sceneOf(model, between());
  for (int i = 0; i <= 100; ++i) {
    const double depth_mm = -50 + 7.5 * i;
    for (const double speed_mm_s : {0.0, 31.0, 80.0, 140.0, 1000.0}) {
      const auto whole = compiled->evaluate(std::array{0.3, 50.0, depth_mm, speed_mm_s});
      const auto answer = scene->force({depth_mm, speed_mm_s});
      ASSERT_EQ(answer.force_n, whole.force_n) << depth_mm << " mm, " << speed_mm_s << " mm/s";
      ASSERT_EQ(answer.fired, whole.fired);
    }
  }
  EXPECT_EQ(scene->depthEndMm(), 600);
  EXPECT_EQ(scene->fadeS(), 0.05);
  EXPECT_EQ(scene->renderer(), fuzzy::RendererParameters{});
}

TEST(ServoScene, TheRendererMovesWhatTheModelCallsByAnotherName) {
  auto model = support::s4Shifted();
  for (auto& rule : model.experts[0].rules) {
    for (auto& condition : rule.conditions) {
      if (condition.input == "depth") condition.input = "way";
      if (condition.input == "speed") condition.input = "rate";
    }
  }
  model.inputs[2].id = "way";
  model.inputs[2].role = fuzzy::Role::kWay;
  model.inputs[3].id = "rate";
  model.inputs[3].role = fuzzy::Role::kRate;
  std::swap(model.inputs[0], model.inputs[3]);  // speed first
  const auto renamed = ServoScene::make(model, between());
  ASSERT_TRUE(renamed) << renamed.error().message();
  const auto original = sceneOf(support::s4Shifted(), between());
  for (const double depth_mm : {10.0, 90.0, 150.0, 300.0}) {
    // One rounding of the centroid may differ with the order of the inputs.
    EXPECT_NEAR((*renamed)->force({depth_mm, 110}).force_n, original->force({depth_mm, 110}).force_n, 1e-15);
  }
}

TEST(ServoScene, AnInputThatTheModelLacksIsNotMoved) {
  const auto without_speed = constantScene(0.4);
  EXPECT_NEAR(without_speed->force({100, 0}).force_n, 0.4, 1e-15);
  EXPECT_EQ(without_speed->force({100, 0}).force_n, without_speed->force({100, 300}).force_n);

  auto model = constantModel(0.4);
  model.inputs[0].id = model.experts[0].rules[0].conditions[0].input = "humidity";
  model.inputs[0].unit = "%";
  const auto without_depth = sceneOf(model, {{"humidity", 40}});
  EXPECT_NEAR(without_depth->force({100, 0}).force_n, 0.4, 1e-15);
  EXPECT_EQ(without_depth->depthEndMm(), std::numeric_limits<double>::infinity());
}

TEST(ServoScene, AnInputOfTheRoleConditionIsNotMovedWhateverItIsCalled) {
  auto model = support::s4Shifted();
  model.inputs[3].role = fuzzy::Role::kCondition;
  auto conditions = between();
  EXPECT_EQ(refusal(model, conditions).message(), "condition 'speed': found no value, wanted a number from 0 to 400");
  conditions["speed"] = 130;
  const auto scene = ServoScene::make(model, conditions);
  ASSERT_TRUE(scene);
  EXPECT_EQ((*scene)->force({90, 0}).force_n, sceneOf(support::s4Shifted(), between())->force({90, 130}).force_n);
}

TEST(ServoScene, RefusesConditionsThatAreMissingUnknownOrNoNumber) {
  const auto model = support::s4Shifted();
  EXPECT_EQ(refusal(model, {{"lubrication", 1}}).message(),
            "condition 'neck_flexion': found no value, wanted a number from 0 to 90");
  EXPECT_EQ(refusal(model, {{"lubrication", std::nan("")}, {"neck_flexion", 0}}).message(),
            "condition 'lubrication': found nan, wanted a finite number");
  EXPECT_EQ(refusal(model, {{"lubrication", 1}, {"neck_flexion", 0}, {"colour", 3}}).message(),
            "condition 'colour': found no such input in the model, wanted conditions for lubrication, neck_flexion and "
            "nothing else");
  EXPECT_EQ(
      refusal(model, {{"lubrication", 1}, {"neck_flexion", 0}, {"speed", 3}}).message(),
      "condition 'speed': found an input that the hand moves, wanted conditions for lubrication, neck_flexion and "
      "nothing else");
  EXPECT_EQ(refusal(constantModel(0.4), {{"x", 1}}).message(),
            "condition 'x': found no such input in the model, wanted no conditions");
}

TEST(ServoScene, RefusesModelsThatItCannotRender) {
  auto invalid = support::s4Shifted();
  invalid.experts.clear();
  EXPECT_FALSE(ServoScene::make(invalid, between()));

  auto centimetres = support::s4Shifted();
  centimetres.inputs[2].unit = "cm";
  EXPECT_EQ(refusal(centimetres, between()).message(),
            "unit of 'depth': found 'cm', wanted mm, which is what the insertion works in");

  SceneSettings settings;
  settings.fade_s = -1;
  EXPECT_EQ(refusal(constantModel(0.4), {}, settings).message(), "fade of the hand-over: found -1 s, wanted 0 to 60 s");
}

TEST(ServoScene, RefusesAModelThatIsTooSlow) {
  SceneSettings settings;
  settings.largest_cost_s = 1e-12;  // less than reading the clock
  const auto error = refusal(support::s4Shifted(), between(), settings);
  EXPECT_EQ(error.code, ErrorCode::kLimit);
  EXPECT_EQ(error.place, "cost of one force of the model");
  EXPECT_GT(measuredCostS(*fuzzy::compile(support::s4Shifted())), 0);
}

TEST(ServoScene, TakesACostThatIsKnown) {
  const auto model = support::s4Shifted();
  const auto compiled = *fuzzy::compile(model);
  SceneSettings settings;
  settings.largest_cost_s = 1e-12;  // less than any measured cost
  settings.known_cost_s = 0.5e-12;
  const auto scene = ServoScene::make(model, compiled, between(), settings);
  ASSERT_TRUE(scene);
  EXPECT_EQ((*scene)->costS(), 0.5e-12) << "as given, not measured";
  settings.known_cost_s = 2e-12;
  EXPECT_FALSE(ServoScene::make(model, compiled, between(), settings));
}

TEST(ServoScene, WithoutABudgetNothingIsMeasured) { EXPECT_EQ(sceneOf(support::s4Shifted(), between())->costS(), 0); }

TEST(ServoScene, OfACompiledModelIsThatOfTheModel) {
  const auto model = support::s4Shifted();
  const auto scene = sceneOf(model, between());
  const auto same = ServoScene::make(model, *fuzzy::compile(model), between());
  ASSERT_TRUE(same) << same.error().message();
  for (const double depth_mm : {10.0, 90.0, 150.0, 300.0})
    EXPECT_EQ((*same)->force({depth_mm, 110}).force_n, scene->force({depth_mm, 110}).force_n);
}

}  // namespace
}  // namespace tactus::haptics
