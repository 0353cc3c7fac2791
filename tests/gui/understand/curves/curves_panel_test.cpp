#include "app/workbench/understand/curves/curves_panel.h"

#include <QApplication>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QMimeData>
#include <QToolButton>
#include <algorithm>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/understand/curves/curve_legend.h"
#include "app/workbench/understand/curves/curve_plot.h"
#include "app/workbench/understand/curves/reading_model.h"
#include "core/base/tables/csv.h"

#include "tests/app/link/test_client.h"
#include "tests/gui/shown_bench.h"

namespace tactus::workbench {
namespace {

class CurvesPanelTest : public tests::ShownBench {
 protected:
  CurvesPanelTest() : ShownBench(Stage::kTune) {}

  bool drop(const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    enter.ignore();
    QCoreApplication::sendEvent(&panel, &enter);
    if (!enter.isAccepted()) return false;
    QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&panel, &drop);
    settle();
    return true;
  }

  bool says(const QWidget& place, const QString& words) {
    const QList<QLabel*> labels = place.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
      return label->isVisible() && (label->text().contains(words) || label->toolTip().contains(words));
    });
  }

  LegendChip* chip(const QString& name) {
    for (LegendChip* chip : panel.findChildren<LegendChip*>()) {
      if (chip->isVisible() && chip->text() == name) return chip;
    }
    return nullptr;
  }

  QStringList legend() {
    QStringList names;
    for (const LegendEntry& entry : plot.legend()) names << entry.name;
    return names;
  }

  QImage picture() { return plot.grab().toImage(); }

  CurvesPanel& panel = *bench.window.findChild<CurvesPanel*>();
  CurvePlot& plot = *bench.window.findChild<CurvePlot*>();
};

TEST_F(CurvesPanelTest, AClickInTheLegendHidesALine) {
  const QImage before = picture();
  QTest::mouseClick(chip(QStringLiteral("B")), Qt::LeftButton);
  settle();
  EXPECT_FALSE(plot.isExpertShown(1));
  EXPECT_NE(picture(), before);
  EXPECT_EQ(legend(),
            (QStringList{QStringLiteral("Mean"), QStringLiteral("A"), QStringLiteral("Range of the experts")}));
  // Another axis brings new lines, and the line stays hidden.
  bench.scene.setXInput(0);
  settle();
  EXPECT_FALSE(plot.isExpertShown(1));
  QTest::mouseClick(chip(QStringLiteral("B")), Qt::LeftButton);
  bench.scene.setXInput(1);
  settle();
  EXPECT_EQ(picture(), before);
}

TEST_F(CurvesPanelTest, TheMouseReadsTheDifferenceToTheOperatingPoint) {
  bench.scene.setValue(0, 20);
  bench.scene.setValue(1, 2);
  settle();
  EXPECT_FALSE(plot.accessibleDescription().contains(QStringLiteral("Δ")));
  bench.scene.setHover(8);
  settle();
  // Near: A alone says low, 0.25 N. Far: A says high, 0.75 N, and B low, so the mean is 0.5 N.
  EXPECT_EQ(plot.accessibleDescription(), QStringLiteral("8 mm   mean 0.500 N   Δ +6 mm, +0.250 N"));
}

TEST_F(CurvesPanelTest, ASecondCursorMeasuresWithoutTheMouse) {
  bench.scene.setValue(0, 20);
  bench.scene.setValue(1, 8);
  QSignalSpy changed(&panel, &CurvesPanel::markChanged);
  panel.setMark(2);
  settle();
  // The forces are those of the test above.
  EXPECT_EQ(plot.accessibleDescription(), QStringLiteral("8 mm   mean 0.500 N   Δ +6 mm, +0.250 N"));
  bench.scene.setHover(2);
  settle();
  EXPECT_EQ(plot.accessibleDescription(), QStringLiteral("2 mm   mean 0.250 N"));
  bench.scene.clearHover();
  // Another axis has other places.
  bench.scene.setXInput(0);
  settle();
  EXPECT_FALSE(panel.mark());
  EXPECT_EQ(changed.count(), 2);
}

TEST_F(CurvesPanelTest, AClickWithShiftSetsTheSecondCursorAndTakesItAway) {
  auto* canvas = plot.findChild<QCustomPlot*>();
  const QPoint place(static_cast<int>(canvas->xAxis->coordToPixel(4)), canvas->axisRect()->center().y());
  const double before = bench.scene.value(1);
  QTest::mouseClick(canvas, Qt::LeftButton, Qt::ShiftModifier, place);
  ASSERT_TRUE(panel.mark());
  EXPECT_NEAR(*panel.mark(), 4, 0.1);
  EXPECT_EQ(bench.scene.value(1), before);
  QTest::mouseClick(canvas, Qt::LeftButton, Qt::ShiftModifier, place);
  EXPECT_FALSE(panel.mark());
}

TEST_F(CurvesPanelTest, ASimulatorStandsOnTheCurvesWhileItSaysWhereItIs) {
  const QImage before = picture();
  const double depth_before = bench.scene.value(1);
  bench.link.start();
  QFile token(bench.link.tokenFile());
  ASSERT_TRUE(token.open(QIODevice::ReadOnly));
  link::TestClient client(static_cast<std::uint16_t>(bench.link.address().section(QLatin1Char(':'), 1).toUInt()));
  ASSERT_TRUE(client.send(link::helloOf(token.readLine().trimmed().toStdString(), R"("want":[],"name":"Phantom 2")") +
                          R"({"felt":{"time_s":1,"depth_mm":4,"speed_mm_s":20,"force_n":0.6}})"
                          "\n"));
  // At 4 mm, over 0.6 N, is its mark; its name is beside it.
  const QPoint tip = plot.mapFrom(&panel, panel.pixelOf(4, 0.6));
  QRect changed;
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return !(changed = tests::differenceOf(before, picture())).isEmpty(); }, tests::kPatience));
  EXPECT_TRUE(changed.contains(tip)) << changed.x() << ' ' << changed.y() << ", " << tip.x() << ' ' << tip.y();
  EXPECT_GT(changed.width(), QFontMetrics(theme::smallFont()).horizontalAdvance(QStringLiteral("Phantom 2")));
  EXPECT_EQ(bench.scene.value(1), depth_before) << "the operating point stays";
  // It says nothing more.
  EXPECT_TRUE(QTest::qWaitFor([&] { return picture() == before; }, tests::kPatience));
}

TEST_F(CurvesPanelTest, TheRangeCanBeTakenAway) {
  const QImage before = picture();
  QTest::mouseClick(chip(QStringLiteral("Range")), Qt::LeftButton);
  settle();
  EXPECT_NE(picture(), before);
  EXPECT_EQ(chip(QStringLiteral("± 1 SD")), nullptr);  // of two experts nobody offers one
}

TEST_F(CurvesPanelTest, AnEditLeavesAGhostAndSaysHowFarItWent) {
  EXPECT_FALSE(says(panel, QStringLiteral("max ΔF"))) << "nothing is edited yet";
  const QImage fresh = picture();
  fuzzy::ForceModel model = tests::twoExperts();
  model.experts[0].rules[2].then = "low";
  ASSERT_TRUE(bench.edits.apply(editing::finished(model, "far is low")));
  settle();
  EXPECT_TRUE(says(panel, QStringLiteral("max ΔF anywhere at least 0.250 N (3.5 JND) at")));
  EXPECT_TRUE(legend().contains(QStringLiteral("Before the last edit")));
  const QImage with_ghost = picture();
  QTest::mouseClick(chip(QStringLiteral("Before the last edit")), Qt::LeftButton);
  settle();
  EXPECT_NE(picture(), with_ghost);
  EXPECT_FALSE(legend().contains(QStringLiteral("Before the last edit")));
  bench.edits.undo();
  settle();
  EXPECT_EQ(picture(), fresh);
}

TEST_F(CurvesPanelTest, AReferenceIsDroppedComparedAndTakenAway) {
  const QImage before = picture();
  // At depths from 7 to 10 the mean of the sample is 0.5 N, 0.2 N above the reference.
  ASSERT_TRUE(drop(folder.writeText("depth_mm,force_n\n7,0.3\n9,0.3\n", QStringLiteral("method two.csv"))));
  EXPECT_NE(picture(), before);
  EXPECT_TRUE(legend().contains(QStringLiteral("method two")));
  EXPECT_TRUE(says(panel, QStringLiteral("RMS 0.200 N · largest 0.200 N at 7 mm · over 7 to 9 mm")));

  // Expert A says 0.75 N there.
  bench.references.setExpert(0);
  settle();
  EXPECT_TRUE(says(panel, QStringLiteral("RMS 0.450 N")));
  fuzzy::ForceModel model = tests::twoExperts();
  model.experts[0].rules[2].then = "low";
  ASSERT_TRUE(bench.edits.apply(editing::finished(model, "far is low")));
  settle();
  EXPECT_TRUE(says(panel, QStringLiteral("RMS 0.050 N")));
  bench.edits.undo();

  // It belongs to its own axis.
  bench.scene.setXInput(0);
  settle();
  EXPECT_FALSE(legend().contains(QStringLiteral("method two")));
  bench.scene.setXInput(1);
  settle();
  const auto buttons = panel.findChild<ReferenceBar*>()->findChildren<QToolButton*>();
  ASSERT_EQ(buttons.size(), 2) << "take it away, and pull to it";
  QTest::mouseClick(buttons.first(), Qt::LeftButton);
  settle();
  EXPECT_EQ(picture(), before);
}

TEST_F(CurvesPanelTest, ABrokenReferenceGivesASentence) {
  ASSERT_TRUE(drop(folder.writeText("depth_mm,force_n\n9,0.3\n7,0.3\n", QStringLiteral("back.csv"))));
  EXPECT_TRUE(bench.window.banner().isVisible());
  EXPECT_TRUE(bench.window.banner().message().contains(QStringLiteral("line 3, column 'depth_mm'")));
  EXPECT_TRUE(bench.references.all().empty());
  EXPECT_FALSE(drop(folder.writeText("x", QStringLiteral("note.txt"))));
}

TEST_F(CurvesPanelTest, WhatWasSavedCanBeLaidOver) {
  const QString path = folder.path(QStringLiteral("saved.csv"));
  ASSERT_TRUE(panel.plotMenu().saveTable(path).has_value());
  ASSERT_TRUE(drop(path));
  // The model is compared with itself.
  ASSERT_EQ(bench.references.differences().size(), 1U);
  EXPECT_EQ(bench.references.differences().front()->largest_n, 0);
}

TEST_F(CurvesPanelTest, AFamilyTakesThePlaceOfTheExperts) {
  bench.scene.setValue(0, 50);
  settle();
  const QImage experts = picture();
  procedure::Figure figure;
  figure.name = {{"en", "Fig. 10c"}};
  figure.varied = "speed";
  figure.values = {20, 80};
  bench.scene.applyFigure(figure);
  settle();
  EXPECT_EQ(legend(),
            (QStringList{QStringLiteral("Mean"), QStringLiteral("Speed 20 mm/s"), QStringLiteral("Speed 80 mm/s")}));
  EXPECT_NE(chip(QStringLiteral("Speed 20 mm/s")), nullptr);
  EXPECT_EQ(chip(QStringLiteral("A")), nullptr);

  // At depth 0 expert A speaks alone: 0.25 N at 20 mm/s, 0.75 N at 80 mm/s.
  const QString path = folder.path(QStringLiteral("family.csv"));
  ASSERT_TRUE(panel.plotMenu().saveTable(path).has_value());
  const auto table = base::CsvTable::read(path.toStdString());
  ASSERT_TRUE(table.has_value());
  EXPECT_EQ(table->columns(),
            (std::vector<std::string>{"depth_mm", "force_n", "force_at_speed_20_mm_s_n", "force_at_speed_80_mm_s_n"}));
  EXPECT_NEAR(table->number(0, 2).value(), 0.25, 1e-15);
  EXPECT_NEAR(table->number(0, 3).value(), 0.75, 1e-15);

  QTest::mouseClick(chip(QStringLiteral("80 mm/s")), Qt::LeftButton);
  settle();
  EXPECT_EQ(legend(), (QStringList{QStringLiteral("Mean"), QStringLiteral("Speed 20 mm/s")}));
  bench.scene.clearFamily();
  settle();
  EXPECT_EQ(picture(), experts);
}

TEST_F(CurvesPanelTest, AKeyInTheLegendLeavesTheFocusThere) {
  LegendChip* const b = chip(QStringLiteral("B"));
  b->setFocus();
  QTest::keyClick(b, Qt::Key_Space);
  settle();
  EXPECT_FALSE(plot.isExpertShown(1));
  EXPECT_EQ(chip(QStringLiteral("B")), b);
  EXPECT_EQ(bench.window.focusWidget(), b);
}

TEST_F(CurvesPanelTest, WhoWasHiddenStaysHiddenInAnotherFrame) {
  QTest::mouseClick(chip(QStringLiteral("B")), Qt::LeftButton);
  bench.references.setExpert(1);
  fuzzy::ForceModel model = tests::twoExperts();
  std::swap(model.experts[0], model.experts[1]);
  ASSERT_TRUE(bench.models.edit(model));
  settle();
  EXPECT_FALSE(plot.isExpertShown(0));
  EXPECT_TRUE(plot.isExpertShown(1));
  EXPECT_EQ(bench.references.expert(), 0U);
}

TEST_F(CurvesPanelTest, WhatWasChosenHoldsAtTheNextStart) {
  QTest::mouseClick(chip(QStringLiteral("Range")), Qt::LeftButton);
  bench.ghost.setOn(false);
  ASSERT_TRUE(drop(folder.writeText("series,depth_mm,force_n\none,1,0.3\none,2,0.3\ntwo,1,0.4\ntwo,2,0.4\n",
                                    QStringLiteral("methods.csv"))));
  bench.references.remove(QStringLiteral("one"));
  Workbench next(settings, folder.path(QStringLiteral("autosave of the next")));
  show(next);
  tests::settle(next.window);
  EXPECT_FALSE(next.ghost.isOn());
  ASSERT_EQ(next.references.all().size(), 1U);
  EXPECT_EQ(next.references.all().front().name, QStringLiteral("two"));
  QStringList names;
  for (const LegendEntry& entry : next.window.findChild<CurvePlot*>()->legend()) names << entry.name;
  EXPECT_EQ(names,
            (QStringList{QStringLiteral("Mean"), QStringLiteral("A"), QStringLiteral("B"), QStringLiteral("two")}));
}

TEST_F(CurvesPanelTest, AnotherLookIsThatOfAFreshStart) {
  const auto fill = [this](Workbench& shown) {
    fuzzy::ForceModel model = tests::twoExperts();
    model.experts[0].rules[2].then = "low";
    ASSERT_TRUE(shown.edits.apply(editing::finished(model, "far is low")));
    shown.references.open(folder.writeText("depth_mm,force_n\n7,0.3\n9,0.3\n", QStringLiteral("method.csv")));
    tests::settle(shown.window);
  };
  fill(bench);
  theme::changeLook(*qApp, theme::Look::kDark);
  settle();
  const QImage changed = panel.grab().toImage();
  {
    QSettings others(folder.path(QStringLiteral("others.ini")), QSettings::IniFormat);
    Workbench fresh(others);
    show(fresh);
    fill(fresh);
    EXPECT_EQ(fresh.window.findChild<CurvesPanel*>()->grab().toImage(), changed);
  }
  theme::changeLook(*qApp, theme::Look::kLight);
}

}  // namespace
}  // namespace tactus::workbench
