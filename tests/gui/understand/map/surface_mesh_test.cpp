#include "app/workbench/understand/map/surface_mesh.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

#include "tests/gui/understand/map/sample_maps.h"

namespace tactus::workbench {
namespace {

constexpr double kMeshRounding = 1e-12;

TEST(SurfaceMesh, HeightsAreSharesOfTheUniverse) {
  const SurfaceMesh mesh(tests::sampleMap(3, [](double x, double y) { return 1 + x + 2 * y; }), 0, 8);
  ASSERT_EQ(mesh.cells(), 2U);
  EXPECT_NEAR(mesh.node(0, 0).z, 1.0 / 8, kMeshRounding);
  EXPECT_NEAR(mesh.node(1, 2).z, 3.5 / 8, kMeshRounding);
  EXPECT_EQ(mesh.node(1, 2).x, 0.5);
  EXPECT_EQ(mesh.node(1, 2).y, 1);
  // The middle of the cell from (0.5, 0.5) to (1, 1).
  EXPECT_NEAR(mesh.cell(1, 1).height, (1 + 0.75 + 1.5) / 8, kMeshRounding);
}

TEST(SurfaceMesh, TheNormalStandsOnAPlane) {
  const SurfaceMesh mesh(tests::sampleMap(5, [](double x, double y) { return 0.5 * x + 0.25 * y; }), 0, 1);
  // Along x the plane rises by 0.5 * 0.8 on 1.85, along y by 0.25 * 0.8 on 1.1.
  const BoxVector along_x = {1.85, 0, 0.4};
  const BoxVector along_y = {0, 1.1, 0.2};
  for (std::size_t i = 0; i < 4; ++i) {
    const BoxVector& normal = mesh.cell(i, 3 - i).normal;
    EXPECT_NEAR(dot(normal, along_x), 0, kMeshRounding);
    EXPECT_NEAR(dot(normal, along_y), 0, kMeshRounding);
    EXPECT_NEAR(dot(normal, normal), 1, kMeshRounding);
    EXPECT_GT(normal.z, 0);
  }
}

TEST(SurfaceMesh, WhereNoRuleFiresIsAHole) {
  // Nothing at the node (4, 4) of 9 x 9: the four cells around it are holes.
  const auto force = [](double x, double y) { return x == 0.5 && y == 0.5 ? -1 : 0.3; };
  const SurfaceMesh fine(tests::sampleMap(9, force), 0, 1);
  for (std::size_t y = 0; y < 8; ++y) {
    for (std::size_t x = 0; x < 8; ++x) {
      EXPECT_EQ(fine.cell(x, y).hole, (x == 3 || x == 4) && (y == 3 || y == 4));
    }
  }
  EXPECT_FALSE(heightAt(fine, 0.49, 0.51));
  EXPECT_NEAR(*heightAt(fine, 0.1, 0.9), 0.3, kMeshRounding);
}

TEST(SurfaceMesh, ACoarseMeshClosesNoHole) {
  // The places without a rule lie between the nodes that the coarse mesh has.
  const auto force = [](double x, double /*y*/) { return x > 0.6 && x < 0.64 ? -1 : 0.3; };
  const ForceMap map = tests::sampleMap(33, force);  // x = 20/32 = 0.625
  const SurfaceMesh coarse(map, 0, 1, 8);
  ASSERT_EQ(coarse.cells(), 4U);
  for (std::size_t x = 0; x < 4; ++x) EXPECT_EQ(coarse.cell(x, 0).hole, x == 2);
}

TEST(PaintOrder, EveryCellOnce) {
  for (const BoxVector viewer : {BoxVector{1, 1, 1}, BoxVector{-1, 1, 0}, BoxVector{0, -1, -1}, BoxVector{-1, -1, 0}}) {
    const PaintOrder order(7, viewer);
    std::vector<int> painted(49, 0);
    for (std::size_t i = 0; i < order.count(); ++i) {
      const auto [x, y] = order.at(i);
      ++painted[y * 7 + x];
    }
    for (const int times : painted) EXPECT_EQ(times, 1);
  }
}

// The property that makes the picture right: whoever goes from a cell toward the viewer comes over cells only that are
// painted later.
TEST(PaintOrder, OnTheWayToTheViewerCellsArePaintedLaterFromEveryAngle) {
  constexpr std::size_t kCells = 20;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<std::size_t> painted(kCells * kCells);
  for (int angle = 0; angle < 400; ++angle) {
    const SurfaceProjection seen({share(random) * 360 - 180, share(random) * 180 - 90}, QRectF(0, 0, 400, 300));
    const BoxVector viewer = seen.toViewer();
    const PaintOrder order(kCells, viewer);
    for (std::size_t i = 0; i < order.count(); ++i) painted[order.at(i)[1] * kCells + order.at(i)[0]] = i;
    for (int ray = 0; ray < 50; ++ray) {
      double x = share(random);
      double y = share(random);
      std::size_t last = 0;
      while (x >= 0 && x < 1 && y >= 0 && y < 1) {
        const auto column = static_cast<std::size_t>(x * kCells);
        const auto row = static_cast<std::size_t>(y * kCells);
        ASSERT_GE(painted[row * kCells + column], last);
        last = painted[row * kCells + column];
        x += viewer.x / kBox.x * 0.01 + (viewer.x == 0 && viewer.y == 0 ? 1 : 0);
        y += viewer.y / kBox.y * 0.01;
        if (std::hypot(viewer.x, viewer.y) < 0.02) break;  // straight from above no cell covers another
      }
    }
  }
}

TEST(SurfaceSections, AHillHidesWhatStandsBehindIt) {
  // A wall across the middle of x, high 0.8 to the low 0.1 beside it.
  const auto force = [](double x, double /*y*/) { return std::abs(x - 0.5) < 0.05 ? 0.8 : 0.1; };
  const SurfaceMesh mesh(tests::sampleMap(101, force), 0, 1);
  const SurfaceProjection from_high_x({90, 10}, QRectF(0, 0, 400, 300));
  EXPECT_TRUE(isCovered(mesh, {0.3, 0.5, 0.1}, from_high_x.toViewer()));
  EXPECT_FALSE(isCovered(mesh, {0.7, 0.5, 0.1}, from_high_x.toViewer()));
  EXPECT_FALSE(isCovered(mesh, {0.5, 0.5, 0.8}, from_high_x.toViewer()));
  // The shadow of the wall: 0.7 * 0.8 high, tan 10 = 0.1763, so 3.18 long, more than the box.
  EXPECT_TRUE(isCovered(mesh, {0.02, 0.5, 0.1}, from_high_x.toViewer()));
  // From 60 degrees above it is 0.323 long, 0.175 of x: from 0.45 down to 0.275.
  const SurfaceProjection from_above({90, 60}, QRectF(0, 0, 400, 300));
  EXPECT_TRUE(isCovered(mesh, {0.3, 0.5, 0.1}, from_above.toViewer()));
  EXPECT_FALSE(isCovered(mesh, {0.25, 0.5, 0.1}, from_above.toViewer()));
  // From below the wall is a groove, which hides nothing of the plane around it.
  const SurfaceProjection from_below({90, -20}, QRectF(0, 0, 400, 300));
  EXPECT_FALSE(isCovered(mesh, {0.3, 0.5, 0.1}, from_below.toViewer()));
}

TEST(SurfaceSections, LinesHaveGapsAtHolesAndBehindHills) {
  const auto force = [](double x, double /*y*/) { return x > 0.4 && x < 0.6 ? -1 : 0.5; };
  const SurfaceMesh mesh(tests::sampleMap(101, force), 0, 1);
  const SurfaceProjection above({0, 60}, QRectF(0, 0, 400, 300));
  const auto runs = visibleSections(mesh, 0.2, 0.5, above.toViewer());
  // Along x left and right of the hole, along y one line.
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_LE(runs[0].back().x, 0.4 + kMeshRounding);
  EXPECT_GE(runs[1].front().x, 0.6 - kMeshRounding);
  for (const BoxPoint& point : runs[2]) EXPECT_EQ(point.x, 0.2);
}

}  // namespace
}  // namespace tactus::workbench
