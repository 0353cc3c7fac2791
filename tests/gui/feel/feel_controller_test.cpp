#include "app/workbench/feel/feel_controller.h"

#include <QCoreApplication>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "tests/gui/feel/feel_test.h"
#include "tests/gui/patience.h"

namespace tactus::workbench {
namespace {

constexpr std::uint64_t kMostTicks = 2;  // an edit is felt no later
using tests::kDepth;
using tests::kPatience;

class FeelControllerTest : public FeelTest {};

TEST_F(FeelControllerTest, TheRunOfAnotherFeatureIsNotItsOwn) {
  QSignalSpy advanced(&feel, &FeelController::advanced);
  QSignalSpy failed(&feel, &FeelController::failed);
  const QObject other;
  device_session.start(QStringLiteral("virtual"), {}, &other);
  ASSERT_EQ(device_session.state(), DeviceSession::State::kRunning);
  time.moveTo(device_session, 40, 50);
  EXPECT_EQ(feel.state(), FeelController::State::kStopped);
  EXPECT_FALSE(feel.isRunning());
  EXPECT_FALSE(feel.device());
  EXPECT_EQ(advanced.size(), 0);
  feel.start(QStringLiteral("virtual"));
  EXPECT_EQ(failed.size(), 1);
  EXPECT_EQ(device_session.user(), &other);
  // No force is no force, whoever asks for it.
  feel.stop();
  EXPECT_EQ(device_session.state(), DeviceSession::State::kStopped);
  feel.start(QStringLiteral("virtual"));
  EXPECT_TRUE(feel.isRunning());
}

TEST_F(FeelControllerTest, StartsOnTheVirtualDeviceAndSaysThatItIsSimulated) {
  EXPECT_EQ(feel.state(), FeelController::State::kStopped);
  feel.start(QStringLiteral("virtual"));
  EXPECT_EQ(feel.state(), FeelController::State::kRunning);
  ASSERT_TRUE(feel.device());
  EXPECT_TRUE(feel.device()->simulated);
  EXPECT_TRUE(feel.session().isHandLive());
  EXPECT_TRUE(isHeldByKey(*feel.device()));
  time.advance(feel, 50);
  EXPECT_EQ(feel.latest().tick, 50u);
  EXPECT_EQ(feel.latest().force_n, 0);
}

TEST_F(FeelControllerTest, AHandThatPushesFeelsTheForceOfTheModel) {
  feel.start(QStringLiteral("virtual"));
  push();
  EXPECT_NEAR(feel.latest().model_force_n, kLowN, kFeltRounding);
  EXPECT_GT(feel.depthMm(), 0);
  EXPECT_EQ(feel.strokes(), 1u);
  // A stuck tube carries what the hand pushes with: something, and less than the break-away of 1.15 F_d.
  EXPECT_GT(feel.latest().force_n, 0.1);
  EXPECT_LE(feel.latest().force_n, 1.15 * kLowN + kFeltRounding);
  // The hand is a spring of 0.1 N/mm: it stays behind the cursor by what it pushes with.
  EXPECT_GT(feel.lagMm(), feel.latest().force_n / 0.1);
}

TEST_F(FeelControllerTest, TheCurvesFollowTheSpeedOfTheHandSmoothly) {
  feel.start(QStringLiteral("virtual"));
  push();
  double before = scene.value(0);
  double largest_step = 0;
  double fastest = 0;
  QObject::connect(&scene, &SceneController::valueChanged, &feel, [&](std::size_t input) {
    if (input != 0) return;
    largest_step = std::max(largest_step, std::abs(scene.value(0) - before));
    before = scene.value(0);
    fastest = std::max(fastest, before);
  });
  time.moveTo(feel, 60, 60);
  // A beat of 16 ms closes 1 - exp(-16/100) = 0.148 of the gap to at most 60 mm/s, then it is rounded to 1 mm/s.
  EXPECT_GT(fastest, 30);
  EXPECT_LE(largest_step, 0.148 * 60 + 1);
}

TEST_F(FeelControllerTest, WithoutAGripThereIsNoForce) {
  feel.start(QStringLiteral("virtual"));
  time.moveTo(feel, 5, 20);
  EXPECT_EQ(feel.latest().force_n, 0);
  EXPECT_EQ(feel.strokes(), 0u);
  EXPECT_GT(feel.latest().position_mm, 4);
}

TEST_F(FeelControllerTest, AnEditIsFeltWithinTwoTicks) {
  feel.start(QStringLiteral("virtual"));
  push();
  EXPECT_FALSE(feel.editLatency());
  ASSERT_TRUE(models.edit(harder()));
  time.advance(feel, 16);
  ASSERT_TRUE(feel.editLatency());
  EXPECT_LE(feel.editLatency()->longest_ticks, kMostTicks);
  EXPECT_LE(feel.session().statistics().longest_wait_ticks, kMostTicks);
  // The difference fades within 50 ms; then the tube has the force of the other rule.
  time.advance(feel, 60);
  EXPECT_NEAR(feel.latest().model_force_n, kHighN, kFeltRounding);
}

TEST_F(FeelControllerTest, EveryEditOfADragIsFeltWithinTwoTicks) {
  feel.start(QStringLiteral("virtual"));
  push();
  for (int i = 0; i < 20; ++i) {
    fuzzy::ForceModel model = scene.model()->model;
    model.inputs[kDepth].terms[0].points[3] = 5 + 0.01 * i;
    ASSERT_TRUE(models.edit(std::move(model)));
    time.advance(feel, i % 3);  // several within a beat, and some within a tick
  }
  time.advance(feel, 16);
  EXPECT_LE(feel.editLatency()->longest_ticks, kMostTicks);
}

TEST_F(FeelControllerTest, StopGivesZeroAndNothingIsComputedAfterwards) {
  feel.start(QStringLiteral("virtual"));
  push();
  ASSERT_GT(feel.latest().force_n, 0);
  feel.stop();
  EXPECT_EQ(feel.state(), FeelController::State::kStopped);
  EXPECT_EQ(feel.latest().force_n, 0);
  EXPECT_FALSE(feel.device());

  const QSignalSpy advanced(&feel, &FeelController::advanced);
  const std::uint64_t ticks = time.ticks();
  ASSERT_TRUE(models.edit(harder()));
  scene.setValue(0, 80);
  time.advance(feel, 50);
  EXPECT_EQ(time.ticks(), ticks);
  EXPECT_EQ(advanced.count(), 0);
  EXPECT_EQ(feel.session().statistics().ticks, 0u);
}

TEST_F(FeelControllerTest, APlacementEndsWithItsNumbers) {
  feel.start(QStringLiteral("virtual"));
  const QSignalSpy ended(&feel, &FeelController::placementEnded);
  push();
  feel.session().setHeld(false);
  time.advance(feel, 100);
  time.moveTo(feel, 0, 50);
  feel.session().setHeld(true);
  time.moveTo(feel, 3, 5);
  const double depth_mm = feel.depthMm();
  feel.newPlacement();
  ASSERT_EQ(ended.count(), 1);
  const auto summary = feel.lastPlacement();
  ASSERT_TRUE(summary);
  EXPECT_TRUE(summary->simulated);
  EXPECT_EQ(summary->strokes, 2u);
  EXPECT_NEAR(summary->depth_mm, depth_mm, 0.01);  // the deepest place is where it ended, up to the motion of a tick
  EXPECT_GT(summary->peak_force_n, summary->mean_force_n);
  EXPECT_LE(summary->peak_force_n, 1.15 * kLowN + kFeltRounding);
  // Both pushes took 1.2 s + 1 s and 0.6 s with rests of 0.1 s; the way back of 0.1 s + 0.2 s lies between them.
  EXPECT_NEAR(summary->duration_s, 3.3, 0.3);
  time.advance(feel, 20);
  EXPECT_EQ(feel.depthMm(), 0);
}

TEST_F(FeelControllerTest, TheOperatingPointFollowsTheHand) {
  feel.start(QStringLiteral("virtual"));
  const QSignalSpy moved(&feel, &FeelController::handMoved);
  push();
  EXPECT_GT(moved.count(), 0);
  EXPECT_NEAR(scene.value(kDepth), feel.depthMm(), 0.05);  // shown in steps of 0.1 mm
  const double stays = scene.value(kDepth);
  feel.setFollowsHand(false);
  time.moveTo(feel, 8, 5);
  EXPECT_EQ(scene.value(kDepth), stays);
}

TEST_F(FeelControllerTest, TheTraceKeepsTenSeconds) {
  feel.start(QStringLiteral("virtual"));
  time.advance(feel, 10'500);
  const auto& trace = feel.history().trace();
  // 4 ms for each point, and the ends.
  EXPECT_LE(trace.size(), 2502u);
  EXPECT_GE(trace.size(), 2498u);
  EXPECT_GE(trace.front().time_s, feel.history().nowS() - FeelHistory::kTraceS);
}

TEST_F(FeelControllerTest, AModelThatCannotBeFeltEndsTheForceOfTheOneBefore) {
  feel.start(QStringLiteral("virtual"));
  push();
  EXPECT_GT(feel.latest().force_n, 0.1);
  const QSignalSpy failed(&feel, &FeelController::failed);
  fuzzy::ForceModel inches = tests::twoExperts();
  inches.inputs[kDepth].unit = "in";
  models.open(folder.write(inches, QStringLiteral("inches.tactus.json")));
  EXPECT_EQ(feel.state(), FeelController::State::kStopped);
  EXPECT_EQ(failed.count(), 1);
}

TEST_F(FeelControllerTest, RefusesWhatCannotBeFelt) {
  fuzzy::ForceModel inches = tests::twoExperts();
  inches.inputs[kDepth].unit = "in";
  models.open(folder.write(inches, QStringLiteral("inches.tactus.json")));
  const QSignalSpy failed(&feel, &FeelController::failed);
  feel.start(QStringLiteral("virtual"));
  EXPECT_EQ(feel.state(), FeelController::State::kStopped);
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains(QLatin1String("'in'"))) << failed[0][0].toString().toStdString();
}

TEST(FeelWithoutAModel, IsRefusedInWords) {
  ModelController models;
  SceneController scene(models);
  tests::SteppedFeel time;
  DeviceSession device_session{time.settings()};
  FeelController feel{scene, device_session};
  const QSignalSpy failed(&feel, &FeelController::failed);
  feel.start(QStringLiteral("virtual"));
  EXPECT_EQ(feel.state(), FeelController::State::kStopped);
  ASSERT_EQ(failed.count(), 1);
  EXPECT_EQ(failed[0][0].toString(), QStringLiteral("No model is open; open one to feel it."));
}

/// The sample model with its first input as a condition: low force up to 40, high force from 60 on.
class FeelConditionTest : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    fuzzy::ForceModel model = tests::twoExperts();
    model.inputs[0].id = GetParam();
    model.inputs[0].unit = "1";
    for (fuzzy::Rule& rule : model.experts[0].rules) {
      for (fuzzy::Condition& condition : rule.conditions) {
        if (condition.input == "speed") condition.input = GetParam();
      }
    }
    model.experts[1].overrides[0].variable = GetParam();
    models.open(folder.write(model));
    scene.setValue(0, 20);
    feel.start(QStringLiteral("virtual"));
    time.advance(feel, 20);
    feel.session().setHeld(true);
    time.advance(feel, 1200);
    time.moveTo(feel, 4, 5);
  }

  tests::ModelFolder folder;
  ModelController models;
  SceneController scene{models};
  tests::SteppedFeel time;
  DeviceSession device_session{time.settings()};
  FeelController feel{scene, device_session};
};

using NeckFlexion = FeelConditionTest;
INSTANTIATE_TEST_SUITE_P(Feel, NeckFlexion, testing::Values("neck_flexion"));

TEST_P(NeckFlexion, AGestureTakesASecond) {
  const QSignalSpy changed(&feel, &FeelController::poseChanged);
  EXPECT_FALSE(feel.isPosed());
  feel.setPosed(true);
  EXPECT_TRUE(feel.isPosed());
  EXPECT_EQ(changed.count(), 1);
  EXPECT_EQ(scene.value(0), 80);  // the middle of what is fully the last term
  // The difference of 0.5 N goes evenly, 0.5 mN with each tick.
  constexpr double kTwoTicksN = 0.001;
  time.advance(feel, 500);
  EXPECT_NEAR(feel.latest().model_force_n, (kLowN + kHighN) / 2, kTwoTicksN);
  time.advance(feel, 505);
  EXPECT_NEAR(feel.latest().model_force_n, kHighN, kFeltRounding);
  EXPECT_LE(feel.editLatency()->longest_ticks, kMostTicks);
}

using Lubrication = FeelConditionTest;
INSTANTIATE_TEST_SUITE_P(Feel, Lubrication, testing::Values("lubrication"));

TEST_P(Lubrication, IsPostedWithTheNextBeatAndFadesQuickly) {
  for (int value = 21; value <= 80; ++value) scene.setValue(0, value);  // a slider between two beats
  EXPECT_FALSE(feel.editLatency());
  time.advance(feel, 16 + 16 + 55);
  EXPECT_NEAR(feel.latest().model_force_n, kHighN, kFeltRounding);
}

/// The thread of the servo and the clock of this computer: what the tests above leave out.
TEST(FeelThread, RunsBesideTheProgram) {
  const tests::ModelFolder folder;
  ModelController models;
  SceneController scene(models);
  DeviceSession device_session;
  FeelController feel{scene, device_session};
  models.open(folder.write(tests::twoExperts()));
  feel.start(QStringLiteral("virtual"));
  ASSERT_TRUE(feel.isRunning());
  EXPECT_FALSE(feel.session().priorityText().isEmpty());
  feel.session().setHeld(true);
  for (int edit = 0; edit < 40; ++edit) {
    feel.session().setTarget(0.1 * edit);
    fuzzy::ForceModel model = scene.model()->model;
    model.inputs[kDepth].terms[0].points[3] = 5 + 0.01 * (edit % 2);
    ASSERT_TRUE(models.edit(std::move(model)));
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  EXPECT_TRUE(QTest::qWaitFor([&] { return feel.editLatency() && feel.latest().tick > 100; }, tests::kPatience));
  feel.stop();
  EXPECT_EQ(feel.latest().force_n, 0);
  EXPECT_FALSE(feel.isRunning());
}

/// The rating of this device is so low that a push of half a minute uses its budget.

}  // namespace
}  // namespace tactus::workbench
