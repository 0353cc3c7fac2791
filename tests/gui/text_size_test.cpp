// At each size of the text, in a window of 1280 x 720 px, no label, button,
// choice or tab is cut.
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTest>
#include <gtest/gtest.h>
#include <qcustomplot.h>

#include "app/workbench/base/theme.h"
#include "app/workbench/features/features.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/tune/terms/membership_editor.h"
#include "app/workbench/understand/curves/curve_plot.h"
#include "app/workbench/workbench.h"

#include "tests/gui/cut_texts.h"
#include "tests/gui/sample_study.h"
#include "tests/gui/shown_bench.h"
#include "tests/support/ngt_model.h"

namespace tactus::workbench {
namespace {

fuzzy::ForceModel fourNurses() {
  fuzzy::ForceModel model = support::s4FiveRegions();
  for (const char* id : {"S1", "S2", "S3"}) {
    model.experts.push_back(model.experts.front());
    model.experts.back().id = id;
  }
  return model;
}

class TextSize : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    bench.window.resize(1280, 720);
    bench.window.show();
  }
  void TearDown() override { appearance::changeTextSize(*qApp, 100); }

  void openModel() {
    bench.models.open(folder.write(fourNurses()));
    appearance::changeTextSize(*qApp, GetParam());
  }
  void openStudy() {
    const QString path = folder.path(QStringLiteral("ward-7-autumn.tactus"));
    tests::makeStudyFile(path);
    bench.study.open(path);
    ASSERT_TRUE(tests::comesTrue([this] { return bench.study.isOpen() && !bench.study.isOpening(); }));
    bench.window.banner().hide();
  }

  void expectWhole(const QString& screen) {
    tests::settle(bench.window);
    ASSERT_EQ(bench.window.size(), QSize(1280, 720)) << screen.toStdString();
    const QByteArray pictures = qgetenv("TACTUS_PICTURES");
    if (!pictures.isEmpty()) {
      const QString name = QStringLiteral("/%1-%2.png").arg(screen).arg(GetParam());
      EXPECT_TRUE(bench.window.grab().save(QString::fromLocal8Bit(pictures) + name));
    }
    const QStringList cut = tests::cutTexts(bench.window);
    EXPECT_TRUE(cut.isEmpty()) << screen.toStdString() << ":\n  " << cut.join(QStringLiteral("\n  ")).toStdString();
  }
  /// No plot on the screen is reached by scrolling, and no table of terms is wider than its place.
  void expectNoPlotScrolls(const QString& screen) {
    for (QScrollArea* area : bench.window.findChildren<QScrollArea*>()) {
      const bool plots = !area->findChildren<QCustomPlot*>().isEmpty();
      if (!area->isVisible() || (!plots && qobject_cast<TermTable*>(area) == nullptr)) continue;
      const std::string where = (screen + QLatin1Char(' ') + area->accessibleName()).toStdString();
      EXPECT_EQ(area->horizontalScrollBar()->maximum(), 0) << where;
      EXPECT_TRUE(!plots || area->verticalScrollBar()->maximum() == 0) << where;
    }
  }
  /// The height of the axes of the plot of the type `Plot`, px; nothing while it is not on the screen.
  template <class Plot>
  std::optional<int> heightOf() {
    const auto* plot = bench.window.findChild<Plot*>();
    if (plot == nullptr || !plot->isVisible()) return std::nullopt;
    return plot->template findChild<QCustomPlot*>()->axisRect()->height();
  }
  void expectHighPlots(const QString& screen) {
    constexpr int kLeast = 200;  // px
    EXPECT_GE(heightOf<CurvePlot>().value_or(kLeast), kLeast) << screen.toStdString();
    EXPECT_GE(heightOf<MembershipEditorPlot>().value_or(kLeast), kLeast) << screen.toStdString();
  }

  /// The layout of `stage`, and each panel behind a tab.
  void expectStageWhole(Stage stage) {
    bench.window.enter(stage);
    expectWhole(stageId(stage));
    expectNoPlotScrolls(stageId(stage));
    expectHighPlots(stageId(stage));
    QList<Panel*> behind;
    for (Panel* panel : bench.window.panels().panels()) {
      if (bench.window.panels().isBehind(*panel)) behind << panel;
    }
    for (Panel* panel : behind) {
      panel->reveal();
      const QString screen = stageId(stage) + QLatin1Char('-') + panel->objectName();
      expectWhole(screen);
      expectNoPlotScrolls(screen);
      expectHighPlots(screen);
    }
  }

  tests::ModelFolder folder;
  QSettings settings{folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat};
  Workbench bench{settings, folder.path(QStringLiteral("autosave"))};
};

TEST_P(TextSize, NothingIsCutWhereAModelIsUnderstoodAndDelivered) {
  openModel();
  expectStageWhole(Stage::kUnderstand);
  expectStageWhole(Stage::kDeliver);
}

TEST_P(TextSize, NothingIsCutWhereAModelIsTuned) {
  openModel();
  expectStageWhole(Stage::kTune);
}

TEST_P(TextSize, NothingIsCutWhereAModelIsFelt) {
  openModel();
  bench.window.enter(Stage::kTune);
  bench.window.enterLayout(feelLayout());
  expectWhole(QStringLiteral("feel"));
  openStudy();
  bench.window.enterLayout(feelLayout());
  expectWhole(QStringLiteral("feel-study"));
}

TEST_P(TextSize, NothingIsCutAtTheStartAndInCollect) {
  appearance::changeTextSize(*qApp, GetParam());
  expectWhole(QStringLiteral("start"));
  openStudy();
  bench.window.enter(Stage::kCollect);
  expectWhole(QStringLiteral("collect"));
}

INSTANTIATE_TEST_SUITE_P(Percent, TextSize, testing::Values(100, 125, 150),
                         [](const testing::TestParamInfo<int>& size) { return std::to_string(size.param); });

}  // namespace
}  // namespace tactus::workbench
