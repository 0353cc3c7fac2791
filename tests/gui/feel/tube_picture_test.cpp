#include <QSettings>
#include <gtest/gtest.h>

#include "app/workbench/features/features.h"
#include "app/workbench/feel/feel_panel.h"
#include "app/workbench/feel/procedure.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/workbench.h"

#include "tests/gui/feel/feel_test.h"
#include "tests/gui/shown_bench.h"
#include "tests/support/ngt_model.h"

namespace tactus::workbench {
namespace {

constexpr std::size_t kNeck = 1;

using TubePictureTest = FeelTest;

TEST_F(TubePictureTest, TheHeadIsUpAtTheStartAsTheFirstStepSays) {
  models.open(folder.write(support::s4FiveRegions(), QStringLiteral("ngt.tactus.json")));
  EXPECT_TRUE(stepsOf(scene.procedure().get()).front().text.contains(QStringLiteral("Sit the patient upright")));
  // The curves begin as in Fig. 11 of the paper.
  EXPECT_EQ(scene.value(kNeck), 60);
  EXPECT_TRUE(feel.isPosed());
  // What is felt is what the picture shows.
  feel.start(QStringLiteral("virtual"));
  EXPECT_EQ(scene.value(kNeck), 7.5);  // the middle of what is fully small: 0 to 15
  // A neck that the user flexed stays flexed in the next run.
  feel.setPosed(true);
  feel.stop();
  feel.start(QStringLiteral("virtual"));
  EXPECT_EQ(scene.value(kNeck), 82.5);
  EXPECT_TRUE(feel.isPosed());
}

// The plots come back to the neck and the speed at which they stood before.
TEST_F(TubePictureTest, AfterTheStopNeckAndSpeedAreAsBefore) {
  models.open(folder.write(support::s4FiveRegions(), QStringLiteral("ngt.tactus.json")));
  constexpr std::size_t kSpeed = 3;
  ASSERT_EQ(scene.model()->model.inputs[kSpeed].id, "speed");
  const double speed_mm_s = scene.value(kSpeed);
  ASSERT_GT(speed_mm_s, 0);
  for (int run = 0; run < 2; ++run) {
    feel.start(QStringLiteral("virtual"));
    time.advance(feel, 300);
    EXPECT_EQ(scene.value(kNeck), 7.5) << run;
    EXPECT_NE(scene.value(kSpeed), speed_mm_s) << run;
    feel.stop();
    EXPECT_EQ(scene.value(kNeck), 60) << run;
    EXPECT_EQ(scene.value(kSpeed), speed_mm_s) << run;
  }
}

TEST_F(TubePictureTest, ANeckThatWasSetIsFeltAsItIs) {
  models.open(folder.write(support::s4FiveRegions(), QStringLiteral("ngt.tactus.json")));
  scene.setValue(kNeck, 45);
  feel.start(QStringLiteral("virtual"));
  EXPECT_EQ(scene.value(kNeck), 45);
}

// The strip, the picture and the first step of the procedure, before anything was started.
TEST(HeadAtFirst, IsInThePictureAsInTheStripAndUpInTheFeelLayout) {
  const tests::ModelFolder folder;
  QSettings settings(folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat);
  Workbench bench(settings, folder.path(QStringLiteral("autosave")));
  bench.window.resize(1280, 720);
  bench.window.show();
  bench.models.open(folder.write(support::s4FiveRegions(), QStringLiteral("ngt.tactus.json")));
  bench.window.enter(Stage::kTune);
  tests::settle(bench.window);
  const auto* picture = bench.views.feel->findChild<anatomy::BodyView*>();
  EXPECT_EQ(bench.scene.value(kNeck), 60);
  EXPECT_EQ(picture->pose().term, "medium");

  bench.window.enterLayout(feelLayout());
  tests::settle(bench.window);
  EXPECT_EQ(bench.scene.value(kNeck), 7.5);
  EXPECT_EQ(picture->pose().term, "small");
  // A neck that the user flexed stays so.
  bench.scene.setValue(kNeck, 90);
  EXPECT_EQ(picture->pose().term, "large");
  bench.window.leaveLayout();
  bench.window.enterLayout(feelLayout());
  EXPECT_EQ(bench.scene.value(kNeck), 90);
}

}  // namespace
}  // namespace tactus::workbench
