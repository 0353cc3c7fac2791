#include <gtest/gtest.h>

#include "app/editing/rule_edits.h"
#include "app/workbench/feel/placement.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/scene_controller.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/stepped_feel.h"

namespace tactus::workbench {
namespace {

class FeltStateTest : public testing::Test {
 protected:
  void SetUp() override {
    models.open(folder.write(tests::twoExperts()));
    feel.start(QStringLiteral("virtual"));
    time.advance(feel, 20);  // the hand has to be seen open once
  }

  // Takes the tube, pushes it to `position_mm` of its way and lets go.
  void stroke(double position_mm) {
    feel.session().setHeld(true);
    time.advance(feel, 1200);
    time.moveTo(feel, position_mm, 5);
    feel.session().setHeld(false);
    time.moveTo(feel, 0, 50);
  }

  tests::ModelFolder folder;
  ModelController models;
  SceneController scene{models};
  EditController edits{models};
  tests::SteppedFeel time;
  DeviceSession device_session{time.settings()};
  FeelController feel{scene, device_session};
  FeltState felt{feel, scene, edits};
};

TEST_F(FeltStateTest, AStrokeOnTheVirtualDeviceIsKeptAsSimulated) {
  EXPECT_EQ(edits.felt().strokes, 0U);
  stroke(5);
  EXPECT_EQ(edits.felt().strokes, 1U);
  EXPECT_EQ(edits.felt().device, feel.device()->name);
  EXPECT_TRUE(edits.felt().simulated);
  ASSERT_FALSE(edits.felt().regions.empty());
  EXPECT_EQ(edits.felt().regions.front(), "Near");
}

TEST_F(FeltStateTest, EachStateHasItsOwnStrokes) {
  stroke(5);
  ASSERT_TRUE(edits.apply(editing::setRuleWeight(edits.model(), "A", 0, 0.5)));
  EXPECT_EQ(edits.felt().strokes, 0U) << "nobody has felt this state";
  stroke(5);
  stroke(5);
  EXPECT_EQ(edits.felt().strokes, 2U);
  edits.undo();
  EXPECT_EQ(edits.felt().strokes, 1U);
  edits.signOff(QStringLiteral("S4"));
  EXPECT_TRUE(editing::saysFelt(edits.history().events().back().label));
}

TEST_F(FeltStateTest, AStrokeThatBeganBeforeTheEditDoesNotCount) {
  feel.session().setHeld(true);
  time.advance(feel, 1200);
  time.moveTo(feel, 3, 5);
  ASSERT_TRUE(edits.apply(editing::setRuleWeight(edits.model(), "A", 0, 0.5)));
  time.moveTo(feel, 5, 5);
  EXPECT_EQ(edits.felt().strokes, 0U);
}

}  // namespace
}  // namespace tactus::workbench
