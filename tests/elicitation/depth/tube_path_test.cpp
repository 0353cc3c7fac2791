#include "elicitation/depth/tube_path.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace tactus::elicitation {
namespace {

TubePath path(std::vector<ImagePoint> points, double mm_per_px = 1) {
  auto made = TubePath::through(std::move(points), mm_per_px);
  EXPECT_TRUE(made) << made.error().message();
  return *made;
}

TEST(TubePath, TwoPointsAreALine) {
  const TubePath line = path({{10, 20}, {40, 60}}, 0.5);  // 50 px
  EXPECT_NEAR(line.lengthMm(), 25, 1e-12);
  EXPECT_NEAR(line.at(10).x, 22, 1e-9);
  EXPECT_NEAR(line.at(10).y, 36, 1e-9);
  EXPECT_NEAR(line.direction(10).x, 0.6, 1e-12);
  EXPECT_EQ(line.at(-5), (ImagePoint{10, 20}));
  EXPECT_EQ(line.at(99), (ImagePoint{40, 60}));
  // From the side: the foot of the perpendicular.
  EXPECT_NEAR(line.depthNear({22 + 8, 36 - 6}), 10, 1e-6);
}

TEST(TubePath, AHalfCircleThroughThirteenPointsHasItsLength) {
  std::vector<ImagePoint> points;
  for (int i = 0; i <= 12; ++i) {
    const double angle = std::numbers::pi * i / 12;
    points.push_back({100 * std::cos(angle), 100 * std::sin(angle)});
  }
  const TubePath arc = path(points);
  // The natural ends flatten the first and last piece a little.
  EXPECT_NEAR(arc.lengthMm(), 100 * std::numbers::pi, 0.25);
  const double middle = arc.depthNear({0, 140});
  EXPECT_NEAR(middle, 50 * std::numbers::pi, 0.2);
  EXPECT_NEAR(std::hypot(arc.at(middle).x, arc.at(middle).y), 100, 0.05);
  EXPECT_NEAR(arc.depthOfPoint(6), middle, 1e-6);
  EXPECT_EQ(arc.gapNear({100 * std::cos(0.4), 100 * std::sin(0.4)}), 1U);
  const auto outline = arc.outline(5);
  EXPECT_GE(outline.size(), 63U);
  EXPECT_EQ(outline.front(), points.front());
}

// facts/participant.md 1.4: the way of our anatomy drawing, as it is clicked on an image of 0.33 mm per pixel.
TEST(TubePath, TheAnatomyDrawingHasItsDepthsWithinAMillimeter) {
  constexpr double kMmPerPx = 0.33;
  const std::vector<ImagePoint> drawn_mm = {
      {0, 0},       {4, -6},      {11, -8},     {24, -7},     {45, -4.2},   {62, -2},   {74, 0},      {83, 6},
      {88, 16},     {90, 28},     {90, 42},     {90, 56},     {91, 70},     {93.5, 85}, {97, 99},     {100.5, 109},
      {104.5, 122}, {109.5, 138}, {115.5, 157}, {121.5, 178}, {127, 198},   {130, 212}, {132.5, 230}, {134, 248},
      {133.5, 266}, {131, 282},   {127, 297},   {121, 312},   {114.5, 324}, {109, 333}, {106, 341},   {103, 356},
      {97, 372},    {86, 385},    {72, 392},    {60, 392}};
  std::vector<ImagePoint> clicked;
  for (const ImagePoint& point : drawn_mm) {
    clicked.push_back({std::round(point.x / kMmPerPx) + 200, std::round(point.y / kMmPerPx) + 200});
  }
  const TubePath tube = path(clicked, kMmPerPx);
  struct Row {
    double depth_mm, x, y;
  };
  const Row table[] = {{20, 16.3, -7.8},    {64, 60, -2.3},    {70, 65.9, -1.5},    {94, 85.6, 10},
                       {115, 90.1, 30.4},   {120, 90.1, 35.4}, {150, 90.5, 65.4},   {175, 94.6, 90},
                       {200, 102, 113.9},   {290, 127.5, 200}, {365, 132.4, 274.6}, {415, 116, 321.5},
                       {440, 105.4, 343.9}, {470, 96.7, 372.5}};
  for (const Row& row : table) {
    EXPECT_NEAR(tube.depthNear({row.x / kMmPerPx + 200, row.y / kMmPerPx + 200}), row.depth_mm, 1) << row.depth_mm;
  }
  EXPECT_NEAR(tube.lengthMm(), 514, 1);
}

TEST(TubePath, WhatIsNoPathIsRefused) {
  EXPECT_FALSE(TubePath::through({{1, 1}}, 0.33));
  EXPECT_FALSE(TubePath::through({{1, 1}, {1, 1}}, 0.33));
  EXPECT_FALSE(TubePath::through({{1, 1}, {2, std::numeric_limits<double>::quiet_NaN()}}, 0.33));
  for (const double scale : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(TubePath::through({{1, 1}, {2, 2}}, scale));
  }
}

TEST(TubePath, AKnownLengthGivesTheScale) {
  EXPECT_NEAR(*mmPerPixel({0, 0}, {30, 40}, 16.5), 0.33, 1e-12);
  EXPECT_FALSE(mmPerPixel({0, 0}, {0, 0.5}, 10));
  EXPECT_FALSE(mmPerPixel({0, 0}, {30, 40}, 0));
}

}  // namespace
}  // namespace tactus::elicitation
