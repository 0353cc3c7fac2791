#include "app/workbench/model/scene_controller.h"

#include <QSignalSpy>
#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

#include "app/workbench/model/places.h"

#include "tests/gui/sample_models.h"

namespace tactus::workbench {
namespace {

using tests::kDepth;
using tests::kSpeed;
constexpr double kDivisionRounding = 1e-15;  // one division of numbers below 1

class SceneControllerTest : public testing::Test {
 protected:
  void SetUp() override { models.open(folder.write(tests::twoExperts())); }

  tests::ModelFolder folder;
  ModelController models;
  SceneController scene{models};
};

TEST_F(SceneControllerTest, StartsWithDepthOnTheAxisAndTheMiddleOfTheUniverses) {
  EXPECT_EQ(scene.xInput(), kDepth);
  EXPECT_EQ(scene.value(kSpeed), 50);
  EXPECT_EQ(scene.readingX(), 5);
}

TEST_F(SceneControllerTest, ReadsTheForcesOfEveryExpert) {
  scene.setValue(kSpeed, 20);
  scene.setHover(8);
  const Reading far = scene.reading();
  EXPECT_NEAR(far.experts[0].force_n, 0.75, kDivisionRounding);
  EXPECT_NEAR(far.experts[1].force_n, 0.25, kDivisionRounding);
  EXPECT_NEAR(far.mean.force_n, 0.5, kDivisionRounding);
  scene.setHover(2);
  const Reading near = scene.reading();
  EXPECT_NEAR(near.mean.force_n, 0.25, kDivisionRounding);
  EXPECT_FALSE(near.experts[1].fired);
  scene.setHover(5.5);
  EXPECT_FALSE(scene.reading().mean.fired);
}

TEST_F(SceneControllerTest, WhatIsNoNumberIsNotRead) {
  scene.setValue(kDepth, 2);
  scene.setValue(kDepth, std::numeric_limits<double>::quiet_NaN());
  scene.setHover(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(scene.value(kDepth), 2);
  EXPECT_EQ(scene.readingX(), 2);
  scene.setValue(kDepth, std::numeric_limits<double>::infinity());
  EXPECT_EQ(scene.value(kDepth), 10);
}

TEST_F(SceneControllerTest, HoverReadsAndTheValueStays) {
  scene.setValue(kDepth, 2);
  scene.setHover(8);
  EXPECT_EQ(scene.readingX(), 8);
  EXPECT_EQ(scene.value(kDepth), 2);
  scene.clearHover();
  EXPECT_EQ(scene.readingX(), 2);
}

TEST_F(SceneControllerTest, CurvesChangeOnlyWithWhatTheyDependOn) {
  const QSignalSpy curves_changed(&scene, &SceneController::curvesChanged);
  const figures::ForceCurves* before = &scene.curves();
  const double speed_50 = before->mean.front().force_n;
  scene.setValue(kSpeed, 50);  // as it is
  scene.setValue(kDepth, 7);   // the x axis
  scene.setHover(3);           // a reading
  scene.setTermsOf(1);         // what is shown
  EXPECT_EQ(curves_changed.count(), 0);
  EXPECT_EQ(&scene.curves(), before);
  scene.setValue(kSpeed, 20);
  EXPECT_EQ(curves_changed.count(), 1);
  EXPECT_NEAR(speed_50, 0.5, kDivisionRounding);
  EXPECT_NEAR(scene.curves().mean.front().force_n, 0.25, kDivisionRounding);
}

TEST_F(SceneControllerTest, ValuesStayInTheUniverse) {
  scene.setValue(kSpeed, 1e9);
  EXPECT_EQ(scene.value(kSpeed), 100);
  scene.setValue(kSpeed, -1);
  EXPECT_EQ(scene.value(kSpeed), 0);
}

TEST_F(SceneControllerTest, ListenersOfAValueSeeItsCurves) {
  double seen = -1;
  QObject::connect(&scene, &SceneController::valueChanged, &scene,
                   [this, &seen] { seen = scene.curves().mean.front().force_n; });
  scene.curves();
  scene.setValue(kSpeed, 80);
  EXPECT_NEAR(seen, 0.75, kDivisionRounding);
}

TEST_F(SceneControllerTest, ShowsTheTermsOfOneExpert) {
  const fuzzy::Variable& speed = scene.model()->model.inputs[kSpeed];
  EXPECT_EQ(scene.terms(speed).size(), 2U);
  scene.setTermsOf(1);
  ASSERT_EQ(scene.terms(speed).size(), 1U);
  EXPECT_EQ(scene.terms(speed)[0].id, "any");
}

TEST_F(SceneControllerTest, ReopeningKeepsTheSetting) {
  scene.setXInput(kSpeed);
  scene.setValue(kDepth, 9);
  fuzzy::ForceModel model = tests::twoExperts();
  model.inputs[kDepth].max = 8;
  folder.write(model);
  models.reopen();
  EXPECT_EQ(scene.xInput(), kSpeed);
  EXPECT_EQ(scene.value(kDepth), 8);
}

TEST_F(SceneControllerTest, AnEditKeepsTheOperatingPoint) {
  scene.setXInput(kSpeed);
  scene.setValue(kSpeed, 20);
  scene.setValue(kDepth, 2);
  scene.setTermsOf(1);
  scene.setHover(30);
  const double before = scene.curves().mean.front().force_n;
  const QSignalSpy another(&scene, &SceneController::modelChanged);
  const QSignalSpy edited(&scene, &SceneController::modelEdited);
  const QSignalSpy curves_changed(&scene, &SceneController::curvesChanged);
  fuzzy::ForceModel model = tests::twoExperts();
  model.experts[0].rules[0].then = "high";
  ASSERT_TRUE(models.edit(model));
  EXPECT_EQ(another.count(), 0);
  EXPECT_EQ(edited.count(), 1);
  EXPECT_EQ(curves_changed.count(), 1);
  EXPECT_EQ(scene.xInput(), kSpeed);
  EXPECT_EQ(scene.value(kSpeed), 20);
  EXPECT_EQ(scene.value(kDepth), 2);
  EXPECT_EQ(scene.readingX(), 30);
  EXPECT_EQ(scene.termsOf(), 1U);
  EXPECT_NEAR(before, 0.25, kDivisionRounding);
  EXPECT_NEAR(scene.curves().mean.front().force_n, 0.75, kDivisionRounding);
}

TEST_F(SceneControllerTest, AnEditOfTheExpertsIsAnotherModel) {
  scene.setValue(kSpeed, 20);
  scene.setTermsOf(1);
  const QSignalSpy another(&scene, &SceneController::modelChanged);
  fuzzy::ForceModel model = tests::twoExperts();
  model.experts.erase(model.experts.begin());
  ASSERT_TRUE(models.edit(model));
  EXPECT_EQ(another.count(), 1);
  EXPECT_EQ(scene.value(kSpeed), 20);
  EXPECT_EQ(scene.termsOf(), 0U);  // still expert B
}

TEST_F(SceneControllerTest, FiguresNeedTheirInputs) {
  EXPECT_TRUE(figuresOf(scene.procedure().get(), scene.model()->model).empty());
  EXPECT_TRUE(figuresOf(nullptr, scene.model()->model).empty());
  fuzzy::ForceModel model = tests::twoExperts();
  const fuzzy::Variable speed = model.inputs[kSpeed];
  for (const char* id : {"lubrication", "neck_flexion"}) {
    model.inputs.push_back(speed);
    model.inputs.back().id = id;
  }
  models.open(folder.write(model, QStringLiteral("study.json")));
  const std::vector<procedure::Figure> figures = figuresOf(scene.procedure().get(), scene.model()->model);
  ASSERT_EQ(figures.size(), 5U);
  scene.setXInput(kSpeed);
  scene.applyFigure(figures[1]);  // Fig. 10a: force over depth, neck flexion 90 deg, speed 30 mm/s
  EXPECT_EQ(scene.xVariable().id, "depth");
  EXPECT_EQ(scene.value(kSpeed), 30);
  EXPECT_EQ(scene.value(3), 90);
}

TEST_F(SceneControllerTest, AFigureWithAFamilyShowsTheMeanAtEveryValue) {
  // Expert A at "near" (depth 2): low (0.25 N) while slow, high (0.75 N) while fast; 50 mm/s is both halves.
  procedure::Figure figure;
  figure.name = {{"en", "Fig. 10c"}};
  figure.varied = "speed";
  figure.values = {20, 80};
  const QSignalSpy another(&scene, &SceneController::familyChanged);
  scene.setXInput(kSpeed);
  scene.applyFigure(figure);
  EXPECT_EQ(scene.xInput(), kDepth);
  EXPECT_EQ(another.count(), 1);
  ASSERT_TRUE(scene.family().has_value());
  const FamilyCurves& curves = scene.familyCurves();
  ASSERT_EQ(curves.curves.size(), 2U);
  EXPECT_EQ(curves.x, scene.curves().x);
  EXPECT_NEAR(curves.curves[0].front().force_n, 0.25, kDivisionRounding);
  EXPECT_NEAR(curves.curves[1].front().force_n, 0.75, kDivisionRounding);
  EXPECT_EQ(familyLineText(scene.model()->model, *scene.family(), 1), QStringLiteral("Speed 80 mm/s"));

  // An edit keeps it and moves its curves; an own list of terms is another frame with the same inputs.
  fuzzy::ForceModel model = tests::twoExperts();
  model.experts[0].rules[0].then = "high";
  model.name = "another";
  ASSERT_TRUE(models.edit(model));
  ASSERT_TRUE(scene.family().has_value());
  EXPECT_NEAR(scene.familyCurves().curves[0].front().force_n, 0.75, kDivisionRounding);
  // What varies cannot be the axis.
  scene.setXInput(kSpeed);
  EXPECT_FALSE(scene.family().has_value());
  EXPECT_EQ(another.count(), 2);
  scene.setXInput(kDepth);
  scene.applyFigure(figure);
  scene.clearFamily();
  EXPECT_FALSE(scene.family().has_value());
}

TEST_F(SceneControllerTest, APartIsSampledAsFinelyAsTheWholeAndOutlivesAnEdit) {
  const auto between = [this](double low, double high) {
    const std::vector<double>& x = scene.curves().x;
    return std::count_if(x.begin(), x.end(), [&](double place) { return place >= low && place <= high; });
  };
  EXPECT_LT(between(2, 3), 80);
  QSignalSpy redrawn(&scene, &SceneController::curvesChanged);
  scene.ranges().show(scene.xVariable(), {2, 3});
  EXPECT_EQ(redrawn.count(), 1);
  EXPECT_GE(between(2, 3), static_cast<std::ptrdiff_t>(figures::kCurveSamples));
  // What another input shows changes nothing here.
  scene.ranges().show(scene.model()->model.inputs[kSpeed], {10, 20});
  EXPECT_EQ(redrawn.count(), 1);

  fuzzy::ForceModel model = tests::twoExperts();
  model.experts[0].rules[0].then = "high";
  ASSERT_TRUE(models.edit(model));
  EXPECT_EQ(scene.ranges().of(scene.xVariable()).low, 2);
  EXPECT_EQ(scene.ranges().of(scene.xVariable()).high, 3);
}

}  // namespace
}  // namespace tactus::workbench
