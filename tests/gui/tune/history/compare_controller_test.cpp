#include "app/workbench/tune/history/compare_controller.h"

#include <QFile>
#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <gtest/gtest.h>

#include "app/editing/membership_edits.h"
#include "app/workbench/feel/feel_controller.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/scene_controller.h"

#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"
#include "tests/gui/stepped_feel.h"

namespace tactus::workbench {
namespace {

using ChangeKind = CompareChoice::Kind;

const editing::TermPlace kLow{{"force", ""}, "low"};
using tests::kNearShoulder;
constexpr double kDifferenceRounding = 1e-12;

class CompareControllerTest : public testing::Test {
 protected:
  void SetUp() override {
    path = folder.write(tests::twoExperts());
    models.open(path);
  }

  // The rectangle of `low` becomes [0.1, 0.5] N: its centroid rises from 0.25 to 0.3 N.
  void raiseLow() { ASSERT_TRUE(edits.apply(editing::moveEdge(edits.model(), kLow, editing::Side::kLeft, 0.1))); }

  void push() {
    time.advance(feel, 20);
    feel.session().setHeld(true);
    time.advance(feel, 1200);
    time.moveTo(feel, 5, 5);
  }

  tests::ModelFolder folder;
  QString path;
  ModelController models;
  SceneController scene{models};
  tests::SteppedFeel time;
  DeviceSession device_session{time.settings()};
  FeelController feel{scene, device_session};
  EditController edits{models};
  CompareController compare{models, edits};
};

TEST_F(CompareControllerTest, SaysHowFarAnExpertAloneIsFromTheMean) {
  compare.choose(CompareSide::kB, {ChangeKind::kExpert, 0, "B"});
  QSignalSpy known(&compare, &CompareController::resultChanged);
  compare.compute();
  ASSERT_TRUE(known.wait(5000));
  ASSERT_TRUE(compare.result());
  // Far: A says 0.75 N and B 0.25 N, the mean is 0.5 N, at every far point. Near: B has no rule.
  EXPECT_NEAR(compare.result()->largest_n, 0.25, kDifferenceRounding);
  EXPECT_NEAR(compare.result()->a_n, 0.5, kDifferenceRounding);
  EXPECT_NEAR(compare.result()->b_n, 0.25, kDifferenceRounding);
  EXPECT_NEAR(compare.result()->rms_n, 0.25, kDifferenceRounding);
  EXPECT_NEAR(compare.result()->noticeable, 0.25 / std::hypot(0.04, 0.12 * 0.5), kDifferenceRounding);
  EXPECT_GT(compare.result()->only_one, 0U);
  ASSERT_EQ(compare.result()->at.size(), 2U);
  EXPECT_GT(compare.result()->at[1], 6);
}

TEST_F(CompareControllerTest, ListsWhatDiffersBetweenAnyTwoStates) {
  auto other = edits.model();
  other.experts[0].rules[0].weight = 0.5;
  edits.apply(editing::finished(other, "weight"));
  other.inputs[1].terms[0].points = {0, 0, 5, 5.5};
  edits.apply(editing::finished(other, "near"));
  // From the first state to the last one.
  compare.choose(CompareSide::kA, {ChangeKind::kState, 0, {}});
  compare.choose(CompareSide::kB, {ChangeKind::kState, 2, {}});
  compare.compute();
  ASSERT_TRUE(QTest::qWaitFor([this] { return compare.result().has_value(); }, 5000));
  const auto& changes = compare.result()->changes;
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes[0].place, "term 'near' of 'depth'");
  EXPECT_EQ(changes[1].place, "rule of 'A': depth near, speed slow");
  compare.choose(CompareSide::kB, {ChangeKind::kState, 1, {}});
  compare.compute();
  ASSERT_TRUE(QTest::qWaitFor([this] { return compare.result().has_value(); }, 5000));
  EXPECT_EQ(compare.result()->changes.size(), 1U);
}

TEST_F(CompareControllerTest, ShowsAnotherVersionAndLeavesTheOpenModelAlone) {
  raiseLow();
  const auto open = models.current();
  EXPECT_FALSE(compare.shown());
  compare.toggle();
  EXPECT_EQ(compare.shown(), CompareSide::kB);
  EXPECT_TRUE(compare.showsAnother());
  EXPECT_EQ(scene.model()->model, tests::twoExperts());
  EXPECT_EQ(models.current(), open);
  EXPECT_TRUE(models.isModified());
  EXPECT_EQ(edits.model(), open->model);

  models.save();
  EXPECT_FALSE(models.isModified());
  EXPECT_EQ(scene.model()->model, tests::twoExperts());
  ModelController other;
  other.open(path);
  EXPECT_EQ(other.current()->model.output, edits.model().output);

  compare.toggle();
  EXPECT_EQ(compare.shown(), CompareSide::kA);
  EXPECT_EQ(scene.model()->model, models.current()->model);
  compare.end();
  EXPECT_FALSE(compare.shown());
}

TEST_F(CompareControllerTest, TheSwitchIsFeltWithinTwoTicks) {
  feel.start(QStringLiteral("virtual"));
  push();
  raiseLow();
  time.advance(feel, 80);
  const double a_n = feel.latest().model_force_n;
  EXPECT_NEAR(a_n, 0.3, kDifferenceRounding);

  compare.toggle();
  time.advance(feel, 3);
  EXPECT_LE(feel.editLatency()->last_ticks, 2U);
  EXPECT_LT(feel.latest().model_force_n, a_n);  // on its way: the difference fades within 50 ms
  time.advance(feel, 80);
  EXPECT_NEAR(feel.latest().model_force_n, 0.25, kDifferenceRounding);

  compare.toggle();
  time.advance(feel, 80);
  EXPECT_EQ(feel.latest().model_force_n, a_n);
  EXPECT_LE(feel.editLatency()->longest_ticks, 2U);
}

TEST_F(CompareControllerTest, AnExpertIsFeltAlone) {
  feel.start(QStringLiteral("virtual"));
  push();
  scene.setValue(1, 10);
  compare.choose(CompareSide::kB, {ChangeKind::kExpert, 0, "B"});
  compare.show(CompareSide::kB);
  EXPECT_EQ(scene.reading().mean.force_n, scene.reading().experts[1].force_n);
  EXPECT_EQ(scene.reading().mean.force_n, models.current()->compiled.evaluateExpert(1, scene.readingPoint()).force_n);
}

TEST_F(CompareControllerTest, AnEditEndsTheComparisonAndIsFelt) {
  raiseLow();
  compare.toggle();
  const QSignalSpy said(&compare, &CompareController::said);
  edits.begin();
  edits.update(editing::moveVertex(edits.base(), kNearShoulder, 3));
  // The models of a gesture are shown once per frame.
  ASSERT_TRUE(QTest::qWaitFor([&] { return !compare.shown(); }, tests::kPatience));
  ASSERT_EQ(said.count(), 1);
  EXPECT_EQ(scene.model()->model.inputs[1].terms[0].points[2], 3);
  EXPECT_EQ(scene.model()->model.output, edits.model().output);
  edits.commit();
  edits.undo();
  edits.undo();
  EXPECT_EQ(models.current()->model, tests::twoExperts());
}

TEST_F(CompareControllerTest, EditingGoesOnWhileTheOpenModelIsShown) {
  raiseLow();
  compare.show(CompareSide::kA);
  const QSignalSpy said(&compare, &CompareController::said);
  edits.apply(editing::moveVertex(edits.model(), kNearShoulder, 3));
  EXPECT_EQ(compare.shown(), CompareSide::kA);
  EXPECT_EQ(said.count(), 0);
  compare.toggle();
  EXPECT_EQ(scene.model()->model.inputs[1].terms[0].points[2], 4);  // before that edit, after the first one
  EXPECT_NE(scene.model()->model.output, tests::twoExperts().output);
}

TEST_F(CompareControllerTest, TheSameModelTwiceIsNothingToCompare) {
  const QSignalSpy refused(&compare, &CompareController::refused);
  compare.toggle();
  EXPECT_EQ(refused.count(), 1);
  EXPECT_FALSE(compare.shown());
}

TEST_F(CompareControllerTest, ADragThatIsTakenBackLeavesSomethingToCompute) {
  raiseLow();
  // As the card does: it asks whenever the result changes.
  QObject::connect(&compare, &CompareController::resultChanged, &compare, [this] { compare.compute(); });
  compare.compute();
  ASSERT_TRUE(QTest::qWaitFor([this] { return compare.result().has_value(); }, 5000));
  edits.begin();
  edits.update(editing::moveEdge(edits.base(), kLow, editing::Side::kLeft, 0.05));
  ASSERT_TRUE(QTest::qWaitFor([this] { return !compare.result(); }, 5000));
  edits.update(editing::moveEdge(edits.base(), kLow, editing::Side::kLeft, 0.06));
  edits.cancel();
  EXPECT_TRUE(QTest::qWaitFor([this] { return compare.result().has_value(); }, 5000));
}

TEST_F(CompareControllerTest, EndsWhileTheDifferenceIsComputed) {
  compare.choose(CompareSide::kB, {ChangeKind::kExpert, 0, "B"});
  const QSignalSpy known(&compare, &CompareController::resultChanged);
  compare.compute();
  // Another choice drops the question; its answer must not come.
  compare.choose(CompareSide::kB, {ChangeKind::kOpen, 0, {}});
  compare.compute();
  ASSERT_TRUE(QTest::qWaitFor([this] { return compare.result().has_value(); }, 5000));
  EXPECT_EQ(compare.result()->largest_n, 0);
  CompareController leaving(models, edits);
  leaving.compute();
}

TEST_F(CompareControllerTest, OffersTheOpenModelItsExpertsAndEveryState) {
  raiseLow();
  QStringList names;
  for (const auto& option : compare.options()) names.append(option.name);
  ASSERT_EQ(names.size(), 6);
  EXPECT_EQ(names[0], QStringLiteral("Open model, mean of 2 experts"));
  EXPECT_EQ(names[1], QStringLiteral("Before the last edit"));
  EXPECT_EQ(names[2], QStringLiteral("A alone"));
  EXPECT_EQ(names[3], QStringLiteral("B alone"));
  EXPECT_TRUE(names[4].startsWith(QStringLiteral("1 · "))) << names[4].toStdString();
  EXPECT_EQ(names[5], QStringLiteral("0 · Opened"));
}

TEST_F(CompareControllerTest, AnotherModelEndsTheComparison) {
  raiseLow();
  compare.toggle();
  models.reopen();
  EXPECT_FALSE(compare.shown());
  EXPECT_EQ(scene.model()->model, tests::twoExperts());
  EXPECT_EQ(compare.choice(CompareSide::kA).kind, ChangeKind::kOpen);
}

}  // namespace
}  // namespace tactus::workbench
