// What finds room in a window of 1280 x 720 px, with a message above the panels: plots of at least 200 px, one row of
// legend, and nothing that scrolls where a model is felt.
#include <QLabel>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>
#include <qcustomplot.h>

#include "app/workbench/base/theme.h"
#include "app/workbench/features/features.h"
#include "app/workbench/feel/feel_panel.h"
#include "app/workbench/feel/recordings/recordings_card.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/model_header.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/understand/curves/curve_legend.h"
#include "app/workbench/understand/curves/curve_plot.h"
#include "app/workbench/workbench.h"

#include "tests/gui/sample_study.h"
#include "tests/gui/shown_bench.h"
#include "tests/support/ngt_model.h"

namespace tactus::workbench {
namespace {

constexpr int kLeastPlot = 200;  // px, of the issue about the small screen

fuzzy::ForceModel fourExperts() {
  fuzzy::ForceModel model = support::s4FiveRegions();
  const fuzzy::Expert first = model.experts.front();
  for (const char* id : {"S1", "S2", "S3"}) {
    model.experts.push_back(first);
    model.experts.back().id = id;
  }
  return model;
}

class RoomTest : public testing::Test {
 protected:
  void SetUp() override {
    bench.window.resize(1280, 720);
    bench.window.show();
    bench.models.open(folder.write(fourExperts()));
    bench.window.banner().showNote(QStringLiteral("Built from the answers in demo.tactus: 4 experts, SIMULATED."));
  }
  void TearDown() override { appearance::changeTextSize(*qApp, 100); }

  void enter(Stage stage) {
    bench.window.enter(stage);
    tests::settle(bench.window);
  }
  int plotHeight() { return bench.window.findChild<CurvePlot*>()->findChild<QCustomPlot*>()->axisRect()->height(); }
  FeelPanel& feel() { return *bench.views.feel; }
  int scrolls() { return feel().findChild<QScrollArea*>()->verticalScrollBar()->maximum(); }

  tests::ModelFolder folder;
  QSettings settings{folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat};
  Workbench bench{settings, folder.path(QStringLiteral("autosave"))};
};

TEST_F(RoomTest, CurvesAreHighAndTheirLegendIsOneRow) {
  for (const Stage stage : {Stage::kUnderstand, Stage::kTune}) {
    enter(stage);
    EXPECT_GE(plotHeight(), kLeastPlot) << stageId(stage).toStdString();
    const auto* legend = bench.window.findChild<CurveLegend*>();
    EXPECT_EQ(legend->height(), legend->chipAt(0)->sizeHint().height());
    for (int i = 0; i < 5; ++i) EXPECT_TRUE(legend->chipAt(i)->isVisible()) << i;
  }
}

TEST_F(RoomTest, WhatFindsNoPlaceInTheLegendIsInItsMenu) {
  enter(Stage::kTune);
  auto* legend = bench.window.findChild<CurveLegend*>();
  legend->resize(300, legend->height());
  QToolButton* more = nullptr;
  for (QToolButton* button : legend->findChildren<QToolButton*>()) {
    if (button->text().startsWith(QLatin1Char('+'))) more = button;
  }
  ASSERT_NE(more, nullptr);
  ASSERT_TRUE(more->isVisible());
  emit more->menu()->aboutToShow();
  const QList<QAction*> hidden = more->menu()->actions();
  EXPECT_EQ(more->text(), QStringLiteral("+%1").arg(hidden.size()));
  // The last experts left the row before the mean did.
  EXPECT_TRUE(legend->chipAt(0)->isVisible());
  const auto s3 = std::find_if(hidden.begin(), hidden.end(),
                               [](const QAction* action) { return action->text() == QLatin1String("S3"); });
  ASSERT_NE(s3, hidden.end());
  (*s3)->trigger();
  EXPECT_FALSE(bench.window.findChild<CurvePlot*>()->isExpertShown(3));
}

TEST_F(RoomTest, TheLineOfTheModelStandsBesideTheMenusOfALowWindow) {
  enter(Stage::kTune);
  const ModelHeader& header = bench.window.header();
  EXPECT_EQ(header.parentWidget(), bench.window.menuBar());
  EXPECT_TRUE(header.isVisible());
  EXPECT_GE(bench.window.menuBar()->height(), header.minimumSizeHint().height());
  for (const QAction* menu : bench.window.menuBar()->actions()) {
    const QRect words = bench.window.menuBar()->actionGeometry(const_cast<QAction*>(menu));
    EXPECT_FALSE(words.intersects(header.geometry())) << menu->text().toStdString();
  }
  bench.window.resize(1600, 900);
  tests::settle(bench.window);
  EXPECT_NE(header.parentWidget(), bench.window.menuBar());
  EXPECT_TRUE(header.isVisible());
}

TEST_F(RoomTest, NothingScrollsWhereAModelIsFelt) {
  const QString path = folder.path(QStringLiteral("feel.tactus"));
  tests::makeStudyFile(path);
  bench.study.open(path);
  ASSERT_TRUE(tests::comesTrue([this] { return bench.study.isOpen() && !bench.study.isOpening(); }));
  enter(Stage::kTune);
  EXPECT_EQ(scrolls(), 0);
  // Who wants to record finds it in a drawer.
  auto* drawer = feel().findChild<DrawerButton*>();
  ASSERT_TRUE(drawer->isVisible());
  drawer->click();
  const auto* card = bench.window.findChild<RecordingsCard*>();
  EXPECT_TRUE(card->isVisible());
  EXPECT_EQ(card->window()->windowType(), Qt::Popup);
  card->window()->hide();

  bench.window.enterLayout(feelLayout());
  tests::settle(bench.window);
  EXPECT_FALSE(drawer->isVisible());
  EXPECT_TRUE(card->isVisible());
  EXPECT_EQ(card->window(), &bench.window);
  EXPECT_EQ(scrolls(), 0);
}

TEST_F(RoomTest, TheFirstWindowOfASmallScreenHasRoomToo) {
  // What is left of 1280 x 720 px inside the frame of a window.
  bench.window.resize(1264, 672);
  enter(Stage::kTune);
  EXPECT_EQ(scrolls(), 0);
  bench.window.enterLayout(feelLayout());
  tests::settle(bench.window);
  EXPECT_EQ(scrolls(), 0);
}

TEST_F(RoomTest, LargeTextCutsNoStageOfTheRail) {
  enter(Stage::kUnderstand);
  for (const int percent : appearance::kTextSizes) {
    appearance::changeTextSize(*qApp, percent);
    tests::settle(bench.window);
    for (const StageButton* button : bench.window.findChildren<StageButton*>()) {
      QFont bold = theme::smallFont();
      bold.setWeight(QFont::DemiBold);
      EXPECT_LE(QFontMetrics(bold).horizontalAdvance(button->text()), button->width()) << percent;
    }
  }
}

TEST_F(RoomTest, ALastingSignStandsInTheStrip) {
  auto* sign = new QLabel(QStringLiteral("Serving"));
  bench.window.strip().addState(sign);
  enter(Stage::kTune);
  EXPECT_TRUE(sign->isVisible());
  EXPECT_EQ(sign->parentWidget(), &bench.window.strip());
}

TEST_F(RoomTest, InTheFeelLayoutNoStageIsMarked) {
  const auto marked = [this] {
    QStringList names;
    for (const StageButton* button : bench.window.findChildren<StageButton*>()) {
      if (button->isChecked()) names << button->text();
    }
    return names;
  };
  enter(Stage::kTune);
  EXPECT_EQ(marked(), QStringList{stageName(Stage::kTune)});
  const QStringList before = marked();
  bench.window.enterLayout(feelLayout());
  EXPECT_EQ(marked(), QStringList());
  bench.window.leaveLayout();
  EXPECT_EQ(marked(), before);
  bench.window.enterLayout(feelLayout());
  bench.window.enter(Stage::kDeliver);
  EXPECT_EQ(marked(), QStringList{stageName(Stage::kDeliver)});
}

}  // namespace
}  // namespace tactus::workbench
