#include <QWheelEvent>
#include <gtest/gtest.h>
#include <qcustomplot.h>

#include "app/workbench/model/shown_ranges.h"
#include "app/workbench/understand/map/map_panel.h"

namespace tactus::workbench {
namespace {

const fuzzy::Variable kMapDepth{"depth", "Depth", "mm", 0, 600, {}};
const fuzzy::Variable kMapSpeed{"speed", "Speed", "mm/s", 0, 400, {}};
const fuzzy::Variable kMapForce{"force", "Force", "N", 0, 1, {}};

class ForceMapPlotTest : public testing::Test {
 protected:
  ForceMapPlotTest() {
    map.resize(500, 400);
    map.setAxes(kMapDepth, kMapSpeed, kMapForce);
    map.show();
    inner = map.findChild<QCustomPlot*>();
    inner->replot();
  }

  void wheel(double x, double y) {
    const QPointF place(inner->xAxis->coordToPixel(x), inner->yAxis->coordToPixel(y));
    QWheelEvent turn(place, inner->mapToGlobal(place), {}, {0, 120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                     false);
    QCoreApplication::sendEvent(inner, &turn);
  }

  ShownRanges ranges;
  ForceMapPlot map{ranges};
  QCustomPlot* inner = nullptr;
};

TEST_F(ForceMapPlotTest, TheWheelZoomsBothInputsAroundTheMouse) {
  wheel(150, 100);
  // A notch shows 1/1.25 = 0.8 of each axis, and the mouse stays where it points.
  EXPECT_NEAR(ranges.of(kMapDepth).high - ranges.of(kMapDepth).low, 480, 1e-9);
  EXPECT_NEAR(ranges.of(kMapSpeed).high - ranges.of(kMapSpeed).low, 320, 1e-9);
  EXPECT_NEAR(ranges.of(kMapDepth).low, 30, 2);  // to a pixel
  EXPECT_NEAR(inner->xAxis->range().lower, ranges.of(kMapDepth).low, 1e-9);
  EXPECT_NEAR(inner->yAxis->range().upper, ranges.of(kMapSpeed).high, 1e-9);
}

TEST_F(ForceMapPlotTest, WhatTheCurvesShowTheMapShowsTooAndAnotherModelKeepsIt) {
  ranges.show(kMapDepth, {0, 250});
  EXPECT_NEAR(inner->xAxis->range().upper, 250, 1e-9);
  EXPECT_NEAR(inner->yAxis->range().upper, 400, 1e-9);
  map.setAxes(kMapDepth, kMapSpeed, kMapForce);
  EXPECT_NEAR(inner->xAxis->range().upper, 250, 1e-9);
}

}  // namespace
}  // namespace tactus::workbench
