// A model under the virtual hand, in virtual time.
#pragma once

#include <gtest/gtest.h>

#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/scene_controller.h"

#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"
#include "tests/gui/stepped_feel.h"

namespace tactus::workbench {

// Centroids of the rectangles of the sample model, N; the sets are symmetric, so rounding is all that is left.
inline constexpr double kLowN = 0.25;
inline constexpr double kHighN = 0.75;
inline constexpr double kFeltRounding = 1e-12;

class FeelTest : public testing::Test {
 protected:
  void SetUp() override { models.open(folder.write(tests::twoExperts())); }

  // Takes the tube and pushes it into the near region, slowly; the fade-in of the arming is over then.
  void push() {
    time.advance(feel, 20);  // the hand has to be seen open once
    feel.session().setHeld(true);
    time.advance(feel, 1200);
    time.moveTo(feel, 5, 5);
  }

  fuzzy::ForceModel harder() {
    fuzzy::ForceModel model = scene.model()->model;
    model.experts[0].rules[0].then = "high";  // near and slow
    return model;
  }

  tests::ModelFolder folder;
  ModelController models;
  SceneController scene{models};
  tests::SteppedFeel time;
  DeviceSession device_session{time.settings()};
  FeelController feel{scene, device_session};
};

}  // namespace tactus::workbench
