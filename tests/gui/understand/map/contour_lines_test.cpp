#include <cmath>
#include <gtest/gtest.h>

#include "app/workbench/understand/map/force_map.h"

namespace tactus::workbench {
namespace {

template <class Force>
ForceMap mapOf(std::size_t side, Force force) {
  ForceMap map;
  map.side = side;
  for (std::size_t y = 0; y < side; ++y) {
    for (std::size_t x = 0; x < side; ++x) {
      map.force_n.push_back(force(static_cast<double>(x), static_cast<double>(y)));
      map.fired.push_back(1);
    }
  }
  return map;
}

double lengthOf(const std::vector<QLineF>& lines) {
  double length = 0;
  for (const QLineF& line : lines) length += line.length();
  return length;
}

TEST(ContourLines, OfAPlaneIsOneStraightLine) {
  const std::vector<QLineF> lines = contourLines(mapOf(11, [](double x, double y) { return x + y; }), 4.5);
  // From (4.5, 0) to (0, 4.5).
  EXPECT_NEAR(lengthOf(lines), std::hypot(4.5, 4.5), 1e-12);
  for (const QLineF& line : lines) {
    EXPECT_NEAR(line.x1() + line.y1(), 4.5, 1e-12);
    EXPECT_NEAR(line.x2() + line.y2(), 4.5, 1e-12);
  }
}

TEST(ContourLines, OfAConeIsACircle) {
  const auto lines = contourLines(mapOf(101, [](double x, double y) { return std::hypot(x - 50, y - 50); }), 30);
  // Chords of a circle of radius 30, each at most a diagonal long: shorter than the circle by less than 1 in 1000.
  EXPECT_NEAR(lengthOf(lines), 2 * M_PI * 30, 0.2);
}

TEST(ContourLines, ASaddleIsCutTwice) {
  ForceMap map;
  map.side = 2;
  map.force_n = {1, 0, 0, 1};
  map.fired = {1, 1, 1, 1};
  for (const double level : {0.4, 0.6}) {
    const std::vector<QLineF> lines = contourLines(map, level);
    ASSERT_EQ(lines.size(), 2U);
    // At 0.4 the high corners are joined, at 0.6 each stands alone; no line crosses the middle.
    for (const QLineF& line : lines) {
      EXPECT_NE(line.pointAt(0.5), QPointF(0.5, 0.5));
      const bool near_low_corner = (line.center().x() > 0.5) != (line.center().y() > 0.5);
      EXPECT_EQ(near_low_corner, level < 0.5);
    }
  }
}

TEST(ContourLines, NoneWhereNoRuleFires) {
  ForceMap map = mapOf(3, [](double x, double /*y*/) { return x; });
  EXPECT_EQ(contourLines(map, 0.5).size(), 2U);
  map.fired[0] = 0;
  EXPECT_EQ(contourLines(map, 0.5).size(), 1U);
}

TEST(ContourLevels, AreRoundNumbersInside) {
  const std::vector<double> levels = contourLevels(0, 1.1);
  ASSERT_EQ(levels.size(), 10U);
  EXPECT_DOUBLE_EQ(levels.front(), 0.1);
  EXPECT_DOUBLE_EQ(levels.back(), 1.0);
  EXPECT_EQ(contourLevels(-1, 1).front(), -0.8);
}

}  // namespace
}  // namespace tactus::workbench
