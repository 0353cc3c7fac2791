#include "app/workbench/plot/plot_menu.h"

#include <QClipboard>
#include <QDockWidget>
#include <QFile>
#include <QMimeData>
#include <QSettings>
#include <QTest>
#include <algorithm>
#include <gtest/gtest.h>
#include <utility>

#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/understand/curves/curves_panel.h"
#include "app/workbench/understand/map/map_panel.h"
#include "app/workbench/workbench.h"
#include "core/base/tables/csv.h"

#include "tests/gui/shown_bench.h"

namespace tactus::workbench {
namespace {

class PlotMenuTest : public testing::Test {
 protected:
  void SetUp() override {
    fuzzy::ForceModel model = tests::twoExperts();
    model.provenance = fuzzy::Provenance{"", {}, {}, "All answers are simulated."};
    bench.window.resize(1280, 720);
    bench.window.show();
    bench.models.open(folder.write(model));
    bench.window.enter(Stage::kUnderstand);
    QCoreApplication::processEvents();
  }

  PlotMenu& curves() { return bench.views.curves->plotMenu(); }
  PlotMenu& map() { return bench.views.map->plotMenu(); }

  base::CsvTable saved(PlotMenu& plot) {
    const QString path = folder.path(QStringLiteral("plot.csv"));
    EXPECT_TRUE(plot.saveTable(path).has_value());
    auto read = base::CsvTable::read(path.toStdString());
    EXPECT_TRUE(read.has_value());
    return std::move(*read);
  }

  QByteArray bytes(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll();
  }

  tests::ModelFolder folder;
  QSettings settings{folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat};
  Workbench bench{settings, folder.path(QStringLiteral("autosave"))};
};

TEST_F(PlotMenuTest, TheTableOfTheCurvesIsThatOfTheModel) {
  bench.scene.setValue(0, 20);
  const base::CsvTable table = saved(curves());
  EXPECT_EQ(table.columns(), (std::vector<std::string>{"depth_mm", "force_n", "force_A_n", "force_B_n",
                                                       "lowest_force_n", "highest_force_n"}));
  const fuzzy::CompiledModel& compiled = bench.models.current()->compiled;
  ASSERT_GT(table.rowCount(), 500U);
  for (std::size_t row = 0; row < table.rowCount(); row += 7) {
    const std::vector<double> point{20, table.number(row, 0).value()};
    const fuzzy::Evaluation mean = compiled.evaluate(point);
    ASSERT_EQ(mean.fired, !table.cell(row, 1).empty());
    if (mean.fired) {
      EXPECT_EQ(table.number(row, 1).value(), mean.force_n);
    }
    const fuzzy::Evaluation a = compiled.evaluateExpert(0, point);
    const fuzzy::Evaluation b = compiled.evaluateExpert(1, point);
    EXPECT_EQ(b.fired, !table.cell(row, 3).empty());
    // A range is one of two at least.
    ASSERT_EQ(a.fired && b.fired, !table.cell(row, 4).empty());
    if (a.fired && b.fired) {
      EXPECT_EQ(table.number(row, 4).value(), std::min(a.force_n, b.force_n));
      EXPECT_EQ(table.number(row, 5).value(), std::max(a.force_n, b.force_n));
    }
  }
}

TEST_F(PlotMenuTest, TheCaptionHoldsTheSettingsInFull) {
  bench.scene.setValue(0, 100.0 / 3);
  const QString path = folder.path(QStringLiteral("plot.csv"));
  ASSERT_TRUE(curves().saveTable(path).has_value());
  const QByteArray text = bytes(path);
  EXPECT_TRUE(text.startsWith("# Two experts: Force along Depth\n# Speed 33.333333333333336 mm/s\n"))
      << text.left(200).toStdString();
  EXPECT_TRUE(text.contains("# Contains simulated data\n"));
}

TEST_F(PlotMenuTest, TheTableOfTheMapIsThatOfTheModel) {
  const base::CsvTable table = saved(map());
  EXPECT_EQ(table.columns(), (std::vector<std::string>{"depth_mm", "speed_mm_s", "force_n"}));
  ASSERT_EQ(table.rowCount(), 201U * 201U);
  const fuzzy::CompiledModel& compiled = bench.models.current()->compiled;
  for (std::size_t row = 0; row < table.rowCount(); row += 401) {
    const std::vector<double> point{table.number(row, 1).value(), table.number(row, 0).value()};
    const fuzzy::Evaluation here = compiled.evaluate(point);
    ASSERT_EQ(here.fired, !table.cell(row, 2).empty());
    // Batch and single points agree to 4 ulp.
    if (here.fired) {
      EXPECT_NEAR(table.number(row, 2).value(), here.force_n, 1e-14);
    }
  }
}

TEST_F(PlotMenuTest, AHiddenMapIsSavedAsItWouldBeShown) {
  bench.window.findChild<QDockWidget*>(QStringLiteral("map"))->close();
  const base::CsvTable before = saved(map());
  bench.scene.setXInput(0);
  fuzzy::ForceModel model = tests::twoExperts();
  model.experts[0].rules[2].then = "low";
  ASSERT_TRUE(bench.models.edit(model));
  const base::CsvTable after = saved(map());
  EXPECT_EQ(before.cell(200, 2), "0.5");
  EXPECT_EQ(after.cell(200, 2), "0.25");
}

TEST_F(PlotMenuTest, ThePictureHasTheLegendAndTheCaption) {
  const QString path = folder.path(QStringLiteral("plot.svg"));
  ASSERT_TRUE(curves().savePicture(path).has_value());
  const QByteArray svg = bytes(path);
  for (const char* words : {"Two experts: Force along Depth", "Speed 50 mm/s", "Contains simulated data", ">Mean<"}) {
    EXPECT_TRUE(svg.contains(words)) << words;
  }
  const QString png = folder.path(QStringLiteral("plot.png"));
  ASSERT_TRUE(curves().savePicture(png).has_value());
  EXPECT_EQ(QImage(png).width(), 2000);
}

TEST_F(PlotMenuTest, APictureLeavesTheScreenAsItIs) {
  tests::settle(bench.window);
  const QImage before = bench.window.grab().toImage();
  for (PlotMenu* plot : {&curves(), &map()}) ASSERT_TRUE(plot->savePicture(folder.path(QStringLiteral("a.svg"))));
  tests::settle(bench.window);
  EXPECT_EQ(bench.window.grab().toImage(), before);
}

TEST_F(PlotMenuTest, TheClipboardGetsPictureAndTable) {
  curves().copyPicture();
  EXPECT_EQ(QGuiApplication::clipboard()->image().width(), 2000);
  curves().copyTable();
  EXPECT_TRUE(QGuiApplication::clipboard()->text().contains(QStringLiteral("\ndepth_mm\tforce_n\t")));
  EXPECT_TRUE(
      QGuiApplication::clipboard()->mimeData()->data(QStringLiteral("text/csv")).contains("\ndepth_mm,force_n,"));
}

TEST_F(PlotMenuTest, TheKeysCopyThePlotWithTheFocus) {
  QGuiApplication::clipboard()->clear();
  map().setFocus();
  QTest::keyClick(&bench.window, Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(bench.window.strip().message().contains(QStringLiteral("Force over Depth and Speed")));
  EXPECT_FALSE(QGuiApplication::clipboard()->image().isNull());
}

TEST_F(PlotMenuTest, WhatCannotBeWrittenLeavesNothing) {
  const QString nowhere = folder.path(QStringLiteral("no/such/folder/plot.csv"));
  EXPECT_FALSE(curves().saveTable(nowhere).has_value());
  EXPECT_FALSE(QFile::exists(nowhere));
}

TEST_F(PlotMenuTest, EveryPlotOfTheScreenHasTheButton) {
  // Understand: curves, map, output sets.
  int shown = 0;
  for (const PlotMenu* menu : bench.window.findChildren<PlotMenu*>()) shown += menu->isVisible() ? 1 : 0;
  EXPECT_EQ(shown, 3);
}

}  // namespace
}  // namespace tactus::workbench
