#include "app/workbench/plot/axis_zoom.h"

#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <gtest/gtest.h>
#include <limits>
#include <qcustomplot.h>

#include "app/workbench/model/shown_ranges.h"
#include "app/workbench/plot/plot_style.h"

namespace tactus::workbench {
namespace {

const fuzzy::Variable kZoomedDepth{"depth", "Depth", "mm", 0, 600, {}};
const fuzzy::Variable kZoomedSpeed{"speed", "Speed", "mm/s", 0, 400, {}};

void expectRange(const ShownRanges& ranges, const fuzzy::Variable& input, double low, double high) {
  EXPECT_NEAR(ranges.of(input).low, low, 1e-9);
  EXPECT_NEAR(ranges.of(input).high, high, 1e-9);
}

TEST(ShownRanges, ZoomKeepsTheCenterAndStaysInTheUniverse) {
  ShownRanges ranges;
  EXPECT_FALSE(ranges.isPart(kZoomedDepth));
  ranges.zoom(kZoomedDepth, 150, 0.5);
  expectRange(ranges, kZoomedDepth, 75, 375);  // 150 stays a quarter of the way
  ranges.zoom(kZoomedDepth, 75, 0.5);
  expectRange(ranges, kZoomedDepth, 75, 225);
  ranges.zoom(kZoomedDepth, 75, 100);
  expectRange(ranges, kZoomedDepth, 0, 600);
  EXPECT_FALSE(ranges.isPart(kZoomedDepth));
  // Never less than a two-hundredth.
  ranges.zoom(kZoomedDepth, 300, 1e-9);
  expectRange(ranges, kZoomedDepth, 298.5, 301.5);
}

TEST(ShownRanges, PanStopsAtTheEnds) {
  ShownRanges ranges;
  ranges.show(kZoomedDepth, {100, 200});
  ranges.pan(kZoomedDepth, 50);
  expectRange(ranges, kZoomedDepth, 150, 250);
  ranges.pan(kZoomedDepth, 1000);
  expectRange(ranges, kZoomedDepth, 500, 600);
  ranges.pan(kZoomedDepth, -1000);
  expectRange(ranges, kZoomedDepth, 0, 100);
}

TEST(ShownRanges, EachInputHasItsOwnAndAnotherUniverseIsRespected) {
  ShownRanges ranges;
  QSignalSpy changed(&ranges, &ShownRanges::changed);
  ranges.show(kZoomedDepth, {400, 600});
  EXPECT_EQ(changed.count(), 1);
  ranges.show(kZoomedDepth, {400, 600});
  EXPECT_EQ(changed.count(), 1) << "nothing changed";
  expectRange(ranges, kZoomedSpeed, 0, 400);
  fuzzy::Variable shorter = kZoomedDepth;
  shorter.max = 500;
  expectRange(ranges, shorter, 400, 500);
  shorter.max = 300;
  expectRange(ranges, shorter, 0, 300);
  ranges.show(kZoomedDepth, {std::numeric_limits<double>::quiet_NaN(), 3});
  expectRange(ranges, kZoomedDepth, 400, 600);
}

class AxisZoomTest : public testing::Test {
 protected:
  AxisZoomTest() {
    plot->resize(700, 300);
    styleAxis(*plot->xAxis, kZoomedDepth);
    zoom = new AxisZoom(*plot, ranges);
    zoom->setInputs(kZoomedDepth);
    plot->show();
    plot->replot();
  }
  QPoint at(double depth_mm) const {
    return {static_cast<int>(plot->xAxis->coordToPixel(depth_mm)), plot->axisRect()->center().y()};
  }
  void wheel(QPoint place, int eighths) {
    QWheelEvent event(place, plot->mapToGlobal(place), {}, {0, eighths}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(plot.get(), &event);
  }

  ShownRanges ranges;
  std::unique_ptr<QCustomPlot> plot{makePlot(nullptr)};
  AxisZoom* zoom = nullptr;
};

TEST_F(AxisZoomTest, TheWheelZoomsAroundTheMouse) {
  const double under = plot->xAxis->pixelToCoord(at(150).x());
  wheel(at(150), 240);
  EXPECT_NEAR(plot->xAxis->range().size(), 600 / (1.25 * 1.25), 1e-6);
  EXPECT_NEAR(plot->xAxis->pixelToCoord(at(under).x()), under, 1.5);
  EXPECT_EQ(plot->xAxis->range().lower, ranges.of(kZoomedDepth).low);
  wheel(at(150), -2400);
  EXPECT_FALSE(ranges.isPart(kZoomedDepth));
}

TEST_F(AxisZoomTest, ShiftAndDragMovesAndIsNoPress) {
  ranges.show(kZoomedDepth, {100, 300});
  QSignalSpy pressed(plot.get(), &QCustomPlot::mousePress);
  const QPoint from = at(200);
  QTest::mousePress(plot.get(), Qt::LeftButton, Qt::ShiftModifier, from);
  QTest::mouseMove(plot.get(), from - QPoint(60, 0));
  QTest::mouseRelease(plot.get(), Qt::LeftButton, Qt::ShiftModifier, from - QPoint(60, 0));
  EXPECT_EQ(pressed.count(), 0);
  const double moved = 60.0 * 200 / plot->axisRect()->width();
  EXPECT_NEAR(ranges.of(kZoomedDepth).low, 100 + moved, 1);
  QTest::mouseClick(plot.get(), Qt::LeftButton, Qt::NoModifier, from);
  EXPECT_EQ(pressed.count(), 1);
}

TEST_F(AxisZoomTest, AShiftClickIsNoDragAndADragIsNoClick) {
  ranges.show(kZoomedDepth, {100, 300});
  QSignalSpy clicked(zoom, &AxisZoom::shiftClicked);
  const QPoint place = at(200);
  QTest::mouseClick(plot.get(), Qt::LeftButton, Qt::ShiftModifier, place);
  ASSERT_EQ(clicked.count(), 1);
  EXPECT_EQ(clicked.front().front().toPointF(), QPointF(place));
  EXPECT_EQ(ranges.of(kZoomedDepth).low, 100);
  QTest::mousePress(plot.get(), Qt::LeftButton, Qt::ShiftModifier, place);
  QTest::mouseMove(plot.get(), place - QPoint(60, 0));
  QTest::mouseRelease(plot.get(), Qt::LeftButton, Qt::ShiftModifier, place - QPoint(60, 0));
  EXPECT_EQ(clicked.count(), 1);
}

TEST_F(AxisZoomTest, ADoubleClickShowsAllInEveryPlotOfTheInput) {
  const std::unique_ptr<QCustomPlot> other(makePlot(nullptr));
  auto* other_zoom = new AxisZoom(*other, ranges);
  other_zoom->setInputs(kZoomedDepth);
  QSignalSpy told(other_zoom, &AxisZoom::changed);
  wheel(at(150), 360);
  EXPECT_EQ(other->xAxis->range().lower, plot->xAxis->range().lower);
  EXPECT_EQ(told.count(), 1);
  QTest::mouseDClick(plot.get(), Qt::LeftButton, Qt::NoModifier, at(150));
  EXPECT_EQ(other->xAxis->range().upper, 600);
}

TEST_F(AxisZoomTest, TicksOfAPartAreRound) {
  ranges.show(kZoomedDepth, {103.3, 251.7});
  plot->replot();
  const QVector<double> ticks = plot->xAxis->tickVector();
  ASSERT_GE(ticks.size(), 3);
  for (const double tick : ticks) EXPECT_NEAR(std::remainder(tick, 5), 0, 1e-9) << tick;
  ranges.showAll(kZoomedDepth);
  plot->replot();
  EXPECT_EQ(plot->xAxis->tickVector().front(), 0);
  EXPECT_EQ(plot->xAxis->tickVector().back(), 600);
}

}  // namespace
}  // namespace tactus::workbench
