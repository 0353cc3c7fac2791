// Scenes that tests of the servo feel: small models whose force follows by hand, and the NGT model.
#pragma once

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <utility>

#include "core/haptics/sources/servo_scene.h"

#include "tests/support/ngt_model.h"

namespace tactus::haptics {

using ScenePointer = std::shared_ptr<const ServoScene>;

/// A scene of a valid model, whatever it costs.
inline ScenePointer sceneOf(const fuzzy::ForceModel& model, const Conditions& conditions, double fade_s = 0.05) {
  SceneSettings settings;
  settings.fade_s = fade_s;
  settings.largest_cost_s = std::numeric_limits<double>::infinity();
  const auto scene = ServoScene::make(model, conditions, settings);
  EXPECT_TRUE(scene) << (scene ? "" : scene.error().message());
  return scene ? *scene : nullptr;
}

inline ScenePointer ngtScene(double lubrication = 1, double neck_flexion_deg = 10, double fade_s = 0.05) {
  return sceneOf(support::s4Shifted(), {{"lubrication", lubrication}, {"neck_flexion", neck_flexion_deg}}, fade_s);
}

/// A model whose force is `force_n` at every depth from `from_mm`, and fires nowhere else. The centroid of a symmetric
/// triangle on a universe that holds it is its middle.
inline fuzzy::ForceModel constantModel(double force_n, const fuzzy::RendererParameters& renderer = {},
                                       double from_mm = 0) {
  fuzzy::ForceModel model;
  model.name = "constant";
  model.inputs = {
      {"depth", "Depth", "mm", 0, 600, {{"all", "all", fuzzy::Shape::kTrapezoid, {from_mm, from_mm, 600, 600}}}}};
  model.output = {"force",
                  "Force",
                  "N",
                  0,
                  std::max(2.0, force_n + 0.05),
                  {{"this", "this", fuzzy::Shape::kTriangle, {force_n - 0.05, force_n, force_n + 0.05}}}};
  fuzzy::Expert expert;
  expert.id = expert.label = "E";
  expert.rules.push_back({{{"depth", "all"}}, "this"});
  model.experts.push_back(std::move(expert));
  model.renderer = renderer;
  return model;
}

inline ScenePointer constantScene(double force_n, const fuzzy::RendererParameters& renderer = {},
                                  double fade_s = 0.05) {
  return sceneOf(constantModel(force_n, renderer), {}, fade_s);
}

}  // namespace tactus::haptics
