#include <cmath>
#include <gtest/gtest.h>

#include "app/workbench/understand/map/surface_mesh.h"

namespace tactus::workbench {
namespace {

constexpr double kPixelRounding = 1e-9;  // px; of numbers below 1000
// Wide enough that the height of the area decides, and as high as a box seen from the side, 100 px to its unit.
const QRectF kArea(0, 0, 1000, 80);

TEST(SurfaceProjection, FromTheFrontXGoesRightAndTheForceUp) {
  const SurfaceProjection seen({0, 0}, kArea);
  // The box is 1.85 wide and 0.8 high, its middle at (500, 40).
  EXPECT_NEAR(seen({0, 0, 0}).x(), 500 - 92.5, kPixelRounding);
  EXPECT_NEAR(seen({1, 0, 0}).x(), 500 + 92.5, kPixelRounding);
  EXPECT_NEAR(seen({0, 0, 0}).y(), 80, kPixelRounding);
  EXPECT_NEAR(seen({0, 0, 1}).y(), 0, kPixelRounding);
  // Along y nothing moves on the screen, and the low end is the nearer one.
  EXPECT_NEAR(seen({0, 1, 0}).x(), 500 - 92.5, kPixelRounding);
  EXPECT_NEAR(seen.nearness({0, 0, 0}), 0.55, kPixelRounding);
  EXPECT_NEAR(seen.nearness({0, 1, 0}), -0.55, kPixelRounding);
}

TEST(SurfaceProjection, FromTheHighEndOfXItIsYThatGoesRight) {
  const SurfaceProjection seen({90, 0}, kArea);
  EXPECT_NEAR(seen({0.5, 0, 0.5}).x(), 500 - 55, kPixelRounding);
  EXPECT_NEAR(seen({0.5, 1, 0.5}).x(), 500 + 55, kPixelRounding);
  EXPECT_GT(seen.nearness({1, 0, 0}), seen.nearness({0, 0, 0}));
}

TEST(SurfaceProjection, FromStraightAboveTheForceIsNotSeen) {
  // The diagonal of the floor, sqrt(1.85^2 + 1.1^2) = 2.1523, fills the height: 37.17 px to the unit.
  const SurfaceProjection seen({0, 90}, kArea);
  const double unit = 80 / std::hypot(1.85, 1.1);
  EXPECT_NEAR(seen({0, 1, 0}).x(), 500 - 0.925 * unit, kPixelRounding);
  EXPECT_NEAR(seen({0, 1, 0}).y(), 40 - 0.55 * unit, kPixelRounding);
  EXPECT_NEAR(seen({0, 1, 1}).y(), seen({0, 1, 0}).y(), kPixelRounding);
  EXPECT_NEAR(seen.nearness({0.5, 0.5, 1}), 0.4, kPixelRounding);
}

TEST(SurfaceProjection, ByHandFromThirtyDegreesAboveAndSixtyToTheSide) {
  const SurfaceProjection seen({60, 30}, QRectF(0, 0, 2000, 1000));
  // The unit: 1000 px for 0.8 cos 30 + 2.1523 sin 30 = 1.7690.
  const double unit = 1000 / (0.8 * std::sqrt(3) / 2 + std::hypot(1.85, 1.1) / 2);
  // The corner (1, 0, 0) is (0.925, -0.55, -0.4) from the middle. Right: (1/2, sqrt(3)/2, 0); up: (-sqrt(3)/4, 1/4,
  // sqrt(3)/2).
  const double right = 0.925 / 2 - 0.55 * std::sqrt(3) / 2;
  const double up = -0.925 * std::sqrt(3) / 4 - 0.55 / 4 - 0.4 * std::sqrt(3) / 2;
  EXPECT_NEAR(seen({1, 0, 0}).x(), 1000 + right * unit, kPixelRounding);
  EXPECT_NEAR(seen({1, 0, 0}).y(), 500 - up * unit, kPixelRounding);
}

TEST(SurfaceProjection, TheWholeBoxStaysInItsAreaFromEveryAngle) {
  const QRectF area(40, 20, 500, 320);
  const QRectF with_rounding = area.adjusted(-kPixelRounding, -kPixelRounding, kPixelRounding, kPixelRounding);
  for (int azimuth = -180; azimuth <= 180; azimuth += 7) {
    for (int elevation = -90; elevation <= 90; elevation += 6) {
      const SurfaceProjection seen({double(azimuth), double(elevation)}, area);
      for (unsigned corner = 0; corner < 8; ++corner) {
        const QPointF at = seen({double(corner & 1U), double(corner >> 1U & 1U), double(corner >> 2U)});
        ASSERT_TRUE(with_rounding.contains(at)) << azimuth << ' ' << elevation;
      }
    }
  }
}

TEST(SurfaceProjection, ZoomAndShiftAreOfTheScreen) {
  const SurfaceProjection plain({20, 40}, kArea);
  const SurfaceProjection near({20, 40}, kArea, 2, {10, -5});
  const QPointF from_middle = plain({0.2, 0.9, 0.4}) - kArea.center();
  const QPointF expected = kArea.center() + 2 * from_middle + QPointF(10, -5);
  EXPECT_NEAR(near({0.2, 0.9, 0.4}).x(), expected.x(), kPixelRounding);
  EXPECT_NEAR(near({0.2, 0.9, 0.4}).y(), expected.y(), kPixelRounding);
}

}  // namespace
}  // namespace tactus::workbench
