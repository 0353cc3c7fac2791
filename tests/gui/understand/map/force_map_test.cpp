#include "app/workbench/understand/map/force_map.h"

#include <QSignalSpy>
#include <QTest>
#include <array>
#include <cmath>
#include <ctime>
#include <gtest/gtest.h>
#include <utility>

#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/shown_ranges.h"
#include "app/workbench/understand/map/map_panel.h"

#include "tests/gui/patience.h"
#include "tests/gui/quiet.h"
#include "tests/gui/sample_models.h"

namespace tactus::workbench {
namespace {

using tests::kDepth;
using tests::kSpeed;
constexpr double kBatchRounding = 1e-15;  // a batch agrees with one evaluation to 4 ulp of numbers below 1

class ForceMapTest : public testing::Test {
 protected:
  void SetUp() override { models.open(folder.write(tests::twoExperts())); }

  void finish() {
    map.update();
    ASSERT_TRUE(QTest::qWaitFor([this] { return map.isFinest(); }, tests::kPatience));
  }

  tests::ModelFolder folder;
  ModelController models;
  SceneController scene{models};
  ForceMapController map{scene};
};

TEST_F(ForceMapTest, EveryPlaceIsTheModel) {
  finish();
  ASSERT_NE(map.map(), nullptr);
  ASSERT_EQ(map.xInput(), kDepth);
  ASSERT_EQ(map.yInput(), kSpeed);
  const std::size_t side = map.map()->side;
  EXPECT_EQ(side, ForceMapController::kSides.back());
  for (std::size_t y = 0; y < side; y += 7) {
    for (std::size_t x = 0; x < side; x += 7) {
      const double n = static_cast<double>(side - 1);
      const std::array point = {std::lerp(0.0, 100.0, static_cast<double>(y) / n),
                                std::lerp(0.0, 10.0, static_cast<double>(x) / n)};
      const fuzzy::Evaluation here = models.current()->compiled.evaluate(point);
      ASSERT_EQ(map.map()->isFired(x, y), here.fired);
      if (here.fired) {
        ASSERT_NEAR(map.map()->force(x, y), here.force_n, kBatchRounding);
      }
    }
  }
}

TEST_F(ForceMapTest, OfAPartAsManyPlacesAreComputedAsOfTheWhole) {
  finish();
  scene.ranges().show(scene.model()->model.inputs[kDepth], {7, 9});
  finish();
  const ForceMap& part = *map.map();
  EXPECT_EQ(part.side, ForceMapController::kSides.back());
  EXPECT_EQ(part.x_part.low, 7);
  EXPECT_EQ(part.x_part.high, 9);
  EXPECT_EQ(part.y_part.high, 100);
  // Depth 8, speed 20: A says 0.75 N, B 0.25 N.
  EXPECT_NEAR(part.force(100, 40), 0.5, kBatchRounding);
  const double place = std::lerp(7.0, 9.0, 13.0 / 200);
  const fuzzy::Evaluation here = models.current()->compiled.evaluate(std::array{20.0, place});
  EXPECT_NEAR(part.force(13, 40), here.force_n, kBatchRounding);
  scene.ranges().showAll(scene.model()->model.inputs[kDepth]);
  finish();
  EXPECT_EQ(map.map()->x_part.high, 10);
}

TEST_F(ForceMapTest, AxesCanChangePlaces) {
  map.setAxes(kSpeed, kSpeed);
  EXPECT_EQ(map.xInput(), kSpeed);
  EXPECT_EQ(map.yInput(), kDepth);
  finish();
  // Depth 8, speed 20: A says 0.75 N, B 0.25 N.
  EXPECT_NEAR(map.map()->force(40, 160), 0.5, kBatchRounding);
  // Depth 5.5: nobody.
  EXPECT_FALSE(map.map()->isFired(40, 110));
}

TEST_F(ForceMapTest, OneExpertAlone) {
  map.setExpert(1);
  finish();
  EXPECT_NEAR(map.map()->force(160, 40), 0.25, kBatchRounding);
  EXPECT_FALSE(map.map()->isFired(40, 40));
}

TEST_F(ForceMapTest, TheFirstMapIsThereAtOnceAndTheNewestOrderWins) {
  const QSignalSpy changed(&map, &ForceMapController::mapChanged);
  map.update();
  EXPECT_GE(changed.count(), 1);
  fuzzy::ForceModel model = tests::twoExperts();
  model.experts[0].rules[0].then = "high";
  ASSERT_TRUE(models.edit(model));
  finish();
  EXPECT_NEAR(map.map()->force(40, 40), 0.75, kBatchRounding);
}

TEST_F(ForceMapTest, AMapThatNobodySeesIsComputedNoFurther) {
  map.addViewer();
  map.addViewer();
  map.update();
  map.removeViewer();
  map.removeViewer();
  const std::uint64_t before = scene.evaluations();
  EXPECT_TRUE(tests::isQuiet(map));
  EXPECT_EQ(scene.evaluations(), before);
  map.addViewer();
  finish();
  EXPECT_EQ(map.map()->side, ForceMapController::kSides.back());
}

TEST_F(ForceMapTest, TwoViewsCostNoMoreThanOne) {
  finish();
  scene.setValue(kSpeed, 33);  // an axis of the map
  const std::uint64_t before = scene.evaluations();
  map.update();
  EXPECT_EQ(scene.evaluations(), before);
  EXPECT_TRUE(map.isFinest());
  EXPECT_EQ(&map.forceAtPoint(), &map.forceAtPoint());
  EXPECT_EQ(scene.evaluations(), before + 1);
}

TEST_F(ForceMapTest, WhatWasChosenStaysWhereAnotherFrameHasIt) {
  map.setAxes(kSpeed, kDepth);
  map.setExpert(1);
  fuzzy::ForceModel model = tests::twoExperts();
  std::swap(model.experts[0], model.experts[1]);
  ASSERT_TRUE(models.edit(model));
  EXPECT_EQ(map.xInput(), kSpeed);
  EXPECT_EQ(map.yInput(), kDepth);
  EXPECT_EQ(map.expert(), 0U);  // still expert B
  model.experts.erase(model.experts.begin());
  ASSERT_TRUE(models.edit(model));
  EXPECT_EQ(map.expert(), std::nullopt);
}

TEST_F(ForceMapTest, AFigureWithASurfaceSetsTheAxes) {
  map.setAxes(kSpeed, kDepth);
  map.setExpert(1);
  procedure::Figure figure;
  figure.map = {"depth", "speed"};
  scene.applyFigure(figure);
  EXPECT_EQ(map.xInput(), kDepth);
  EXPECT_EQ(map.yInput(), kSpeed);
  EXPECT_EQ(map.expert(), std::nullopt);
}

TEST_F(ForceMapTest, TheForceAtThePointIsThatOfTheScene) {
  scene.setValue(kSpeed, 20);
  scene.setValue(kDepth, 8);
  EXPECT_NEAR(map.forceAtPoint().force_n, 0.5, kBatchRounding);  // A says 0.75 N, B 0.25 N
  map.setExpert(0);
  EXPECT_NEAR(map.forceAtPoint().force_n, 0.75, kBatchRounding);
  scene.setValue(kDepth, 5.5);
  EXPECT_FALSE(map.forceAtPoint().fired);
}

double cpuMsOfThisThread() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

TEST_F(ForceMapTest, OfManyExpertsTheFineMapIsComputedBesideTheWindow) {
  fuzzy::ForceModel model = tests::twoExperts();
  constexpr std::size_t kExperts = 40;
  while (model.experts.size() < kExperts) {
    fuzzy::Expert next = model.experts[model.experts.size() % 2];
    next.id = "X" + std::to_string(model.experts.size());
    next.label.clear();
    model.experts.push_back(std::move(next));
  }
  models.open(folder.write(model));
  const double before_ms = cpuMsOfThisThread();
  map.finish();
  const double whole_ms = cpuMsOfThisThread() - before_ms;
  model.experts[0].rules[0].then = "high";
  ASSERT_TRUE(models.edit(model));
  map.update();
  ASSERT_FALSE(map.isFinest());
  const double begun_ms = cpuMsOfThisThread();
  QSignalSpy changed(&map, &ForceMapController::mapChanged);
  while (!map.isFinest()) ASSERT_TRUE(changed.wait(60'000));
  // The time on a processor, whatever else the machine does: this thread only waits.
  EXPECT_LT(cpuMsOfThisThread() - begun_ms, whole_ms / 4);
  const std::array point = {20.0, 4.0};
  EXPECT_NEAR(map.map()->force(80, 40), models.current()->compiled.evaluate(point).force_n, 1e-12);
}

TEST_F(ForceMapTest, AFileGetsTheWholeMapAlsoWhileItIsComputed) {
  map.update();
  map.finish();
  EXPECT_TRUE(map.isFinest());
  EXPECT_EQ(map.map()->side, ForceMapController::kSides.back());
}

// It was left as coarse as it was, and never rested.
TEST_F(ForceMapTest, GoesOnWhereItsPanelWasHiddenMeanwhile) {
  fuzzy::ForceModel many = tests::twoExperts();  // that the whole map is more than a slice of work
  for (int i = 0; i < 200; ++i) {
    many.experts.push_back(many.experts.front());
    many.experts.back().id = "X" + std::to_string(i);
  }
  models.open(folder.write(many));
  MapPanel panel(scene, map);
  panel.resize(600, 400);
  bool hidden = false;
  QObject::connect(&map, &ForceMapController::mapChanged, &panel, [&] {
    if (map.isFinest() || std::exchange(hidden, true)) return;
    panel.hide();
    panel.show();
  });
  panel.show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return map.map() != nullptr; }, tests::kPatience));
  ASSERT_TRUE(QTest::qWaitFor([&] { return tests::isQuiet(panel); }, tests::kPatience));
  EXPECT_TRUE(hidden) << "the first map is a coarse one";
  EXPECT_EQ(map.map()->side, ForceMapController::kSides.back());
}

}  // namespace
}  // namespace tactus::workbench
