#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QMenuBar>
#include <QTabBar>
#include <map>

#include "app/workbench/base/refresh.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/menus.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/understand/map/force_map.h"
#include "app/workbench/understand/map/map_panel.h"

#include "tests/gui/shown_bench.h"

namespace tactus::workbench {
namespace {

using tests::kPatience;

class BenchViewTest : public tests::ShownBench {
 protected:
  BenchViewTest() : ShownBench(Stage::kUnderstand) {}

  QDockWidget* dock(const char* id) { return bench.window.findChild<QDockWidget*>(QLatin1String(id)); }

  /// Whether the panel can be seen: not closed, and not behind a tab.
  static bool isSeen(const QDockWidget& panel) {
    return panel.isVisible() && panel.widget()->childAt(20, 20) != nullptr;
  }
  bool isSeen(const char* id) { return isSeen(*dock(id)); }

  /// As settle(), without a picture, whose making paints. What an event posts is done, too.
  void rest() {
    int rounds = 0;
    ASSERT_TRUE(QTest::qWaitFor([&] { return ++rounds > 3 && tests::isQuiet(bench.window); }, kPatience));
  }

  void hideAll() {
    for (QDockWidget* panel : bench.window.findChildren<QDockWidget*>()) panel->hide();
    settle();
  }
};

TEST_F(BenchViewTest, HiddenPanelsComputeNothing) {
  hideAll();
  const std::uint64_t before = bench.scene.evaluations();
  fuzzy::ForceModel model = tests::twoExperts();
  for (int i = 0; i < 20; ++i) {
    bench.scene.setValue(0, i);
    bench.scene.setValue(1, i * 0.1);
    bench.scene.setHover(i * 0.2);
    model.inputs[0].terms[0].points[2] = 40 + 0.1 * i;
    ASSERT_TRUE(bench.models.edit(model));
    QCoreApplication::processEvents();
  }
  settle();
  EXPECT_EQ(bench.scene.evaluations(), before);
}

TEST_F(BenchViewTest, AShownPanelCatchesUp) {
  hideAll();
  bench.scene.setValue(0, 20);
  const std::uint64_t before = bench.scene.evaluations();
  dock("curves")->show();
  EXPECT_TRUE(QTest::qWaitFor([&] { return bench.scene.evaluations() > before; }, kPatience));
}

TEST_F(BenchViewTest, AnIdleWindowComputesNothing) {
  const std::uint64_t before = bench.scene.evaluations();
  bench.window.update();
  settle();
  EXPECT_EQ(bench.scene.evaluations(), before);
}

TEST_F(BenchViewTest, OnlyPanelsWhoseInputsChangedCompute) {
  hideAll();
  dock("map")->show();
  settle();
  const std::uint64_t before = bench.scene.evaluations();
  bench.scene.setValue(0, 33);  // an axis of the map: only the force at the cross is new
  settle();
  EXPECT_LE(bench.scene.evaluations() - before, 1U);
}

TEST_F(BenchViewTest, PanelsBehindATabComputeNothing) {
  hideAll();
  dock("reading")->show();
  dock("map")->show();
  bench.window.panels().tabifyDockWidget(dock("reading"), dock("map"));
  dock("reading")->raise();
  settle();
  const std::uint64_t before = bench.scene.evaluations();
  fuzzy::ForceModel model = tests::twoExperts();
  model.inputs[0].terms[0].points[2] = 41;
  ASSERT_TRUE(bench.models.edit(model));
  settle();
  // The forces here: the mean and two experts.
  EXPECT_EQ(bench.scene.evaluations() - before, 3U);
  dock("map")->raise();
  const std::uint64_t of_map = 3 * ForceMapController::kSides.back() * ForceMapController::kSides.back();
  EXPECT_TRUE(QTest::qWaitFor([&] { return bench.scene.evaluations() - before > of_map; }, kPatience));
}

TEST_F(BenchViewTest, AMinimizedWindowComputesNothing) {
  bench.window.showMinimized();
  rest();
  const std::uint64_t before = bench.scene.evaluations();
  fuzzy::ForceModel model = tests::twoExperts();
  model.inputs[0].terms[0].points[2] = 41;
  ASSERT_TRUE(bench.models.edit(model));
  bench.scene.setValue(0, 20);
  rest();
  EXPECT_EQ(bench.scene.evaluations(), before);
  bench.window.showNormal();
  EXPECT_TRUE(QTest::qWaitFor([&] { return bench.scene.evaluations() > before; }, kPatience));
}

TEST_F(BenchViewTest, CurvesAreNotComputedForTheInputOnTheirAxis) {
  hideAll();
  dock("curves")->show();
  settle();
  const std::uint64_t before = bench.scene.evaluations();
  bench.scene.setValue(1, 7);  // depth: what is read on the curves is new, the curves are not
  settle();
  EXPECT_EQ(bench.scene.evaluations() - before, 3U);
}

TEST_F(BenchViewTest, AThousandMovesComputeOncePerFrame) {
  hideAll();
  dock("curves")->show();
  settle();
  // Mean and two experts along the axis, the same of the model before and after for their difference, and the cursor.
  const auto one = bench.scene.curves().x.size() * 9 + 3;
  const std::uint64_t before = bench.scene.evaluations();
  QElapsedTimer clock;
  clock.start();
  bench.terms.setVariable("speed");
  bench.terms.beginMove({0, Grip::Part::kVertex, 2, false});
  for (int i = 0; i < 1000; ++i) {
    bench.terms.moveBy(-0.01 * (i + 1));
    QCoreApplication::processEvents();
  }
  bench.terms.endMove();
  settle();
  const auto frames = static_cast<std::uint64_t>(clock.elapsed() / Refresh::kFrameMs + 2);
  const std::uint64_t computed = bench.scene.evaluations() - before;
  EXPECT_GT(computed, 0U);
  EXPECT_LE(computed, frames * (one + 60));  // up to some more places at the vertices that move
}

TEST_F(BenchViewTest, AClickInTheMapSetsTheOperatingPoint) {
  auto* plot = bench.window.findChild<ForceMapPlot*>();
  ASSERT_TRUE(plot->isVisible());
  QWidget* canvas = plot->findChild<QWidget*>();
  QTest::mouseClick(canvas, Qt::LeftButton, {}, QPoint(plot->width() / 3, plot->height() / 2));
  const double depth = bench.scene.value(1);
  const double speed = bench.scene.value(0);
  EXPECT_GT(depth, 0);
  EXPECT_LT(depth, 5);
  EXPECT_GT(speed, 25);
  EXPECT_LT(speed, 75);
  QTest::mouseClick(canvas, Qt::LeftButton, {}, QPoint(plot->width() / 2, plot->height() / 4));
  EXPECT_GT(bench.scene.value(1), depth);
  EXPECT_GT(bench.scene.value(0), speed);
}

TEST_F(BenchViewTest, TheMapFollowsAnEdit) {
  auto* plot = bench.window.findChild<ForceMapPlot*>();
  const QImage before = plot->grab().toImage();
  fuzzy::ForceModel model = tests::twoExperts();
  model.experts[0].rules[0].then = "high";
  ASSERT_TRUE(bench.models.edit(model));
  EXPECT_TRUE(QTest::qWaitFor([&] { return plot->grab().toImage() != before; }, kPatience));
  ASSERT_TRUE(bench.models.edit(tests::twoExperts()));
  EXPECT_TRUE(QTest::qWaitFor([&] { return plot->grab().toImage() == before; }, kPatience));
}

TEST_F(BenchViewTest, TheStripTypesTheOperatingPoint) {
  auto* strip = bench.window.findChild<OperatingStrip*>();
  const auto boxes = strip->findChildren<QDoubleSpinBox*>();
  ASSERT_EQ(boxes.size(), 2);
  boxes[0]->selectAll();
  QTest::keyClicks(boxes[0], QStringLiteral("12.5"));
  QTest::keyClick(boxes[0], Qt::Key_Return);
  EXPECT_EQ(bench.scene.value(0), 12.5);
  bench.scene.setValue(1, 3);
  EXPECT_EQ(boxes[1]->value(), 3);
}

TEST_F(BenchViewTest, TheWindowSaysWhatIsNotSaved) {
  EXPECT_FALSE(bench.window.isWindowModified());
  fuzzy::ForceModel model = tests::twoExperts();
  model.experts[0].rules[0].then = "high";
  ASSERT_TRUE(bench.models.edit(model));
  EXPECT_TRUE(bench.window.isWindowModified());
  bench.models.save();
  EXPECT_FALSE(bench.window.isWindowModified());
}

TEST_F(BenchViewTest, EachStageKeepsItsLayout) {
  EXPECT_TRUE(isSeen("map"));
  EXPECT_FALSE(isSeen("membership_editor"));
  dock("map")->close();
  bench.window.enter(Stage::kTune);
  settle();
  EXPECT_TRUE(isSeen("membership_editor"));
  EXPECT_TRUE(isSeen("curves"));
  EXPECT_TRUE(isSeen("feel"));
  const QRect curves = dock("curves")->geometry();
  EXPECT_GT(curves.left(), dock("membership_editor")->geometry().right());
  EXPECT_GT(dock("feel")->geometry().top(), curves.bottom());
  for (const char* id : {"membership_editor", "curves", "feel"}) EXPECT_GT(dock(id)->width(), 400) << id;
  bench.window.enter(Stage::kUnderstand);
  settle();
  EXPECT_FALSE(isSeen("map"));
  EXPECT_TRUE(isSeen("rules"));
  bench.window.panels().resetLayout();
  settle();
  EXPECT_TRUE(isSeen("map"));
  for (const char* id : {"curves", "map", "rules", "reading"}) EXPECT_GT(dock(id)->width(), 200) << id;
}

TEST_F(BenchViewTest, GoingToAndFroMovesNothing) {
  const auto seen = [&] {
    std::map<QString, QRect> places;
    for (const auto* panel : bench.window.findChildren<QDockWidget*>()) {
      if (isSeen(*panel)) places[panel->objectName()] = panel->geometry();
    }
    return places;
  };
  std::map<Stage, std::map<QString, QRect>> before;
  for (const Stage stage : {Stage::kTune, Stage::kUnderstand}) {
    bench.window.enter(stage);
    settle();
    before[stage] = seen();
  }
  EXPECT_EQ(before[Stage::kUnderstand].size(), 4U);  // and two behind tabs
  EXPECT_EQ(before[Stage::kTune].size(), 3U);        // and seven behind tabs
  for (int round = 0; round < 2; ++round) {
    for (const Stage stage : {Stage::kTune, Stage::kUnderstand}) {
      bench.window.enter(stage);
      settle();
      EXPECT_EQ(seen(), before[stage]) << stageId(stage).toStdString() << " in round " << round;
    }
  }
}

TEST_F(BenchViewTest, APanelFromTheOtherStageFindsRoomBesideTheOthers) {
  dock("history")->toggleViewAction()->trigger();
  settle();
  ASSERT_TRUE(isSeen("history"));
  EXPECT_FALSE(dock("history")->isFloating());
  EXPECT_GT(dock("history")->width(), 100);
  for (const char* id : {"curves", "map", "rules", "reading"}) {
    EXPECT_TRUE(isSeen(id)) << id;
    EXPECT_FALSE(dock(id)->geometry().intersects(dock("history")->geometry())) << id;
  }
}

TEST_F(BenchViewTest, WhatIsBehindATabIsHiddenAndComputesNothing) {
  bench.window.enter(Stage::kTune);
  settle();
  ASSERT_FALSE(isSeen("map"));
  dock("curves")->close();
  settle();
  const std::uint64_t before = bench.scene.evaluations();
  bench.scene.setValue(0, 20);
  settle();
  EXPECT_EQ(bench.scene.evaluations(), before);
  dock("map")->raise();
  settle();
  EXPECT_TRUE(isSeen("map"));
  EXPECT_FALSE(isSeen("feel"));
  EXPECT_GT(bench.scene.evaluations(), before);
}

TEST_F(BenchViewTest, NoLineRunsUnderTheTabsOfPanels) {
  for (const Stage stage : {Stage::kUnderstand, Stage::kTune, Stage::kUnderstand}) {
    bench.window.enter(stage);
    settle();
    int bars = 0;
    for (const auto* tabs : bench.window.panels().findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly)) {
      if (!tabs->isVisible()) continue;
      ++bars;
      EXPECT_FALSE(tabs->drawBase()) << tabs->tabText(0).toStdString();
      EXPECT_FALSE(tabs->accessibleName().isEmpty());
    }
    EXPECT_EQ(bars, 2);
  }
}

TEST_F(BenchViewTest, ATitleIsShownOnce) {
  bench.window.enter(Stage::kTune);
  settle();
  EXPECT_GT(dock("curves")->titleBarWidget()->height(), 0);
  EXPECT_EQ(dock("feel")->titleBarWidget()->height(), 0);
  // Taken out of the window, it has no tab that names it.
  dock("feel")->setFloating(true);
  settle();
  EXPECT_GT(dock("feel")->titleBarWidget()->height(), 0);
  dock("feel")->setFloating(false);
  settle();
  EXPECT_EQ(dock("feel")->titleBarWidget()->height(), 0);
}

TEST_F(BenchViewTest, AMessageMovesNothing) {
  const QRect before = bench.window.panels().geometry();
  bench.window.say(QStringLiteral("Nasopharynx: right foot 125 to 132 mm"));
  settle();
  EXPECT_EQ(bench.window.strip().message(), QStringLiteral("Nasopharynx: right foot 125 to 132 mm"));
  EXPECT_EQ(bench.window.panels().geometry(), before);
}

TEST_F(BenchViewTest, TheTimeOfAPictureGivesWayToTheOperatingPoint) {
  OperatingStrip strip(bench.models, bench.scene);
  QLabel time(QStringLiteral("Plots after 23 ms"));
  strip.setFrameTime(&time);
  emit bench.scene.modelChanged();
  time.show();
  strip.resize(1500, 40);
  strip.show();
  settle();
  const int wanted = strip.sizeHint().width();
  const QList<QDoubleSpinBox*> numbers = strip.findChildren<QDoubleSpinBox*>();
  ASSERT_FALSE(numbers.isEmpty());
  for (const int width : {wanted - 10, wanted + 10}) {
    strip.resize(width, strip.height());
    settle();
    EXPECT_EQ(time.width() > 1, width > wanted) << width;
    for (const QDoubleSpinBox* number : numbers) EXPECT_GE(number->width(), number->sizeHint().width()) << width;
  }
}

TEST_F(BenchViewTest, TheLayoutIsThereAtTheNextStart) {
  dock("rules")->close();
  ASSERT_TRUE(bench.window.close());
  Workbench next(settings, folder.path(QStringLiteral("autosave of the next")));
  next.window.resize(1280, 720);
  next.window.show();
  next.models.open(folder.path(QStringLiteral("sample.tactus.json")));
  tests::settle(next.window);
  EXPECT_EQ(next.window.panels().stage(), Stage::kUnderstand);
  EXPECT_FALSE(next.window.findChild<QDockWidget*>(QStringLiteral("rules"))->isVisible());
  EXPECT_TRUE(next.window.findChild<QDockWidget*>(QStringLiteral("map"))->isVisible());
}

TEST_F(BenchViewTest, OnlyStagesThatWorkCanBeEntered) {
  // A model alone: no study to collect for.
  const QStringList work = {QStringLiteral("Understand"), QStringLiteral("Tune"), QStringLiteral("Deliver")};
  for (const StageButton* button : bench.window.findChildren<StageButton*>()) {
    EXPECT_EQ(button->isEnabled(), work.contains(button->text())) << button->text().toStdString();
    EXPECT_TRUE(button->isVisible()) << button->text().toStdString();
    EXPECT_FALSE(button->accessibleDescription().isEmpty());
  }
}

TEST_F(BenchViewTest, TheSheetListsEveryShortcutOnce) {
  const ShortcutSheet sheet(*bench.window.menuBar(), &bench.window);
  QStringList texts;
  for (const QLabel* label : sheet.findChildren<QLabel*>()) texts << label->text();
  for (const char* keys : {"Ctrl+O", "Ctrl+S", "F5", "Ctrl+3", "F1", "Ctrl+/", "Ctrl+Shift+R"}) {
    EXPECT_EQ(texts.count(QLatin1String(keys)), 1) << keys;
  }
  // On a small screen, with a title bar.
  EXPECT_LE(sheet.sizeHint().width(), 1280);
  EXPECT_LE(sheet.sizeHint().height(), 680);
}

}  // namespace
}  // namespace tactus::workbench
