#include "app/workbench/plot/chart.h"

#include <cmath>
#include <gtest/gtest.h>
#include <qcustomplot.h>

namespace tactus::workbench {
namespace {

constexpr QSize kSize(400, 300);

struct ChartTest : testing::Test {
  ChartTest() {
    view.resize(kSize);
    chart.x.universe = {"depth", "Depth", "mm", 0, 100, {}};
    chart.y.universe = {"force", "Force", "N", 0, 2, {}};
  }

  QImage picture() {
    QImage image(kSize, QImage::Format_RGB32);
    QCPPainter painter(&image);
    view.paintPicture(painter, kSize);
    return image;
  }
  /// The color at a place in the units of the axes.
  QColor colorAt(double x, double y) {
    const QImage drawn = picture();
    const QRect area = view.plot().axisRect()->rect();
    return drawn.pixelColor(area.left() + static_cast<int>(std::lround(x / 100 * (area.width() - 1))),
                            area.bottom() - static_cast<int>(std::lround(y / 2 * (area.height() - 1))));
  }

  ChartView view;
  Chart chart;
};

TEST_F(ChartTest, APartLiesWhereItsNumbersAre) {
  chart.x.grid = chart.y.grid = false;
  view.setChart(chart);
  const QColor card = colorAt(50, 1);
  chart.parts.emplace_back(ChartBar{10, 20, 0, 1, Qt::red});
  chart.parts.emplace_back(ChartBand{{30, 40}, {0.5, 0.5}, {1.5, 1.5}, Qt::green});
  chart.parts.emplace_back(ChartLine{{50, 60}, {1, 1}, Qt::NoPen, {}, QBrush(Qt::blue)});
  chart.parts.emplace_back(ChartRule{Qt::Vertical, 70, QPen(Qt::magenta, 5)});
  chart.parts.emplace_back(ChartRule{Qt::Horizontal, 1.8, QPen(Qt::cyan, 5)});
  chart.parts.emplace_back(
      ChartLine{{80}, {1}, Qt::NoPen, {ChartDots::Shape::kSquare, 12, QPen(Qt::NoPen), QBrush(Qt::yellow)}});
  view.setChart(chart);
  const struct {
    double x, y;
    QColor wanted;
  } places[] = {{15, 0.5, Qt::red}, {15, 1.3, card},      {35, 1, Qt::green},  {35, 0.2, card},     {55, 0.5, Qt::blue},
                {55, 1.3, card},    {70, 1, Qt::magenta}, {25, 1.8, Qt::cyan}, {80, 1, Qt::yellow}, {90, 1, card}};
  for (const auto& place : places) {
    EXPECT_EQ(colorAt(place.x, place.y).name(), place.wanted.name()) << place.x << ' ' << place.y;
  }
}

TEST_F(ChartTest, APartLiesOverThoseBeforeIt) {
  const ChartBar below{0, 100, 0, 2, Qt::red};
  const ChartLine above{{0, 100}, {1, 1}, QPen(Qt::blue, 9)};
  chart.parts = {below, above};
  view.setChart(chart);
  EXPECT_EQ(colorAt(50, 1).name(), QColor(Qt::blue).name());
  chart.parts = {above, below};
  view.setChart(chart);
  EXPECT_EQ(colorAt(50, 1).name(), QColor(Qt::red).name());
}

TEST_F(ChartTest, ALineEndsWhereItHasNoNumberAndMayGoBack) {
  chart.x.grid = chart.y.grid = false;
  chart.parts = {ChartLine{{0, 40, 50, 60, 100}, {1, 1, std::nan(""), 1, 1}, QPen(Qt::blue, 9)}};
  view.setChart(chart);
  EXPECT_EQ(colorAt(20, 1).name(), QColor(Qt::blue).name());
  EXPECT_NE(colorAt(50, 1).name(), QColor(Qt::blue).name());
  // Across, then back above: not in the order of x.
  ChartLine back{{20, 80, 80, 20}, {0.5, 0.5, 1.5, 1.5}, QPen(Qt::blue, 9)};
  back.is_function_of_x = false;
  chart.parts = {back};
  view.setChart(chart);
  for (const QPointF at : {QPointF(50, 0.5), {80, 1}, {50, 1.5}})
    EXPECT_EQ(colorAt(at.x(), at.y()).name(), QColor(Qt::blue).name()) << at.x();
  EXPECT_NE(colorAt(20, 1).name(), QColor(Qt::blue).name()) << "it is open";
}

TEST_F(ChartTest, TheAxesAreThoseOfTheChart) {
  chart.x.label = QStringLiteral("Depth (mm)");
  chart.y = membershipAxis();
  view.setChart(chart);
  const QCustomPlot& plot = view.plot();
  EXPECT_EQ(plot.xAxis->label(), chart.x.label);
  EXPECT_EQ(plot.xAxis->range(), QCPRange(0, 100));
  EXPECT_EQ(plot.yAxis->range(), QCPRange(0, 1.06));
  const auto* const steps = dynamic_cast<const QCPAxisTickerFixed*>(plot.yAxis->ticker().data());
  ASSERT_NE(steps, nullptr);
  EXPECT_EQ(steps->tickStep(), 0.5);
}

TEST_F(ChartTest, AnotherChartLeavesNothingOfTheOneBefore) {
  const QImage empty = picture();
  chart.parts = {ChartBar{0, 100, 0, 2, Qt::red},
                 ChartText{QStringLiteral("words"), {50, 1}, Qt::AlignCenter, Qt::blue}};
  chart.legend = {{QStringLiteral("red"), QPen(Qt::red)}};
  view.setChart(chart);
  EXPECT_NE(picture(), empty);
  EXPECT_EQ(view.legend().size(), 1U);
  view.setChart({chart.x, chart.y});
  EXPECT_TRUE(view.legend().empty());
  EXPECT_EQ(view.plot().itemCount() + view.plot().plottableCount(), 0);
  view.clear();
  EXPECT_EQ(picture(), empty) << "neither axes nor lines";
}

}  // namespace
}  // namespace tactus::workbench
