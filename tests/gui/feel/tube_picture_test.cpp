#include "app/workbench/feel/tube_picture.h"

#include <gtest/gtest.h>

#include "app/workbench/feel/procedure.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/model/scene_controller.h"

#include "tests/gui/sample_models.h"
#include "tests/support/ngt_model.h"

namespace tactus::workbench {
namespace {

using anatomy::Posture;

constexpr std::size_t kNeck = 1;

// Small 0 0 15 35, Medium 15 35 55 75, Large 55 75 90 90: facts/domain.md, as printed in the paper.
TEST(TubePicture, DrawsTheNeckByTheWordOfItsFlexion) {
  const fuzzy::Variable neck = support::ngtVariables().inputs[kNeck];
  ASSERT_EQ(neck.id, kNeckFlexionId);
  EXPECT_EQ(drawnPosture(neck, 0), Posture::kUpright);
  EXPECT_EQ(drawnPosture(neck, 20), Posture::kUpright);     // 0.75 against 0.25
  EXPECT_EQ(drawnPosture(neck, 45), Posture::kHalfFlexed);  // 0 · 1 · 0
  EXPECT_EQ(drawnPosture(neck, 60), Posture::kHalfFlexed);  // 0 · 0.75 · 0.25
  EXPECT_EQ(drawnPosture(neck, 70), Posture::kChinOnChest);
  EXPECT_EQ(drawnPosture(neck, 90), Posture::kChinOnChest);
}

TEST(TubePicture, ShowsTheHeadUpAtTheStartAsTheFirstStepSays) {
  const tests::ModelFolder folder;
  ModelController models;
  const SceneController scene{models};
  models.open(folder.write(support::s4FiveRegions()));
  const fuzzy::Variable& neck = scene.model()->model.inputs[kNeck];
  EXPECT_EQ(scene.value(kNeck), 7.5);  // the middle of what is fully small: 0 to 15
  EXPECT_EQ(drawnPosture(neck, scene.value(kNeck)), Posture::kUpright);
  EXPECT_TRUE(ngtProcedure().front().text.contains(QStringLiteral("The patient sits upright")));
}

// Who goes on with a second model, or reads the file again, keeps the posture.
TEST(TubePicture, KeepsThePostureFromModelToModel) {
  const tests::ModelFolder folder;
  ModelController models;
  SceneController scene{models};
  models.open(folder.write(support::s4FiveRegions()));
  scene.setValue(kNeck, 82.5);
  models.open(folder.write(support::s4AsPrinted(), QStringLiteral("printed.tactus.json")));
  EXPECT_EQ(scene.value(kNeck), 82.5);
}

}  // namespace
}  // namespace tactus::workbench
