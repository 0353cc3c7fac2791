#include "app/figures/surface_view.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tactus::figures {
namespace {

constexpr double kRounding = 1e-12;

TEST(SurfaceView, ByHandFromThirtyDegreesAboveAndSixtyToTheSide) {
  const SurfaceView seen({60, 30});
  // The corner (1, 0, 0) is (0.925, -0.55, -0.4) from the middle. Right: (1/2, sqrt(3)/2, 0); up: (-sqrt(3)/4, 1/4,
  // sqrt(3)/2).
  EXPECT_NEAR(seen({1, 0, 0}).x, 0.925 / 2 - 0.55 * std::sqrt(3) / 2, kRounding);
  EXPECT_NEAR(seen({1, 0, 0}).y, -0.925 * std::sqrt(3) / 4 - 0.55 / 4 - 0.4 * std::sqrt(3) / 2, kRounding);
  EXPECT_NEAR(seen.extent().x, 1.85 / 2 + 1.1 * std::sqrt(3) / 2, kRounding);
  EXPECT_NEAR(seen.extent().y, 1.85 * std::sqrt(3) / 4 + 1.1 / 4 + 0.8 * std::sqrt(3) / 2, kRounding);
}

TEST(SurfaceView, TheExtentIsThatOfTheCorners) {
  for (int azimuth = -180; azimuth <= 180; azimuth += 7) {
    for (int elevation = -90; elevation <= 90; elevation += 6) {
      const SurfaceView seen({double(azimuth), double(elevation)});
      double right = 0, top = 0;
      for (int corner = 0; corner < 8; ++corner) {
        const auto at = seen({corner & 1 ? 1.0 : 0.0, corner & 2 ? 1.0 : 0.0, corner & 4 ? 1.0 : 0.0});
        right = std::max(right, at.x);
        top = std::max(top, at.y);
      }
      ASSERT_NEAR(seen.extent().x, 2 * right, kRounding) << azimuth << ' ' << elevation;
      ASSERT_NEAR(seen.extent().y, 2 * top, kRounding) << azimuth << ' ' << elevation;
    }
  }
}

TEST(SurfaceView, ASlopeTurnsItsNormalAwayFromTheRise) {
  // A rise of 3/4 along x: the normal is (-3, 0, 4) / 5.
  const BoxVector normal = normalOf(0.75, 0);
  EXPECT_NEAR(normal.x, -0.6, kRounding);
  EXPECT_NEAR(normal.y, 0, kRounding);
  EXPECT_NEAR(normal.z, 0.8, kRounding);
}

TEST(SurfaceView, BothSidesOfACellAreLitAlike) {
  const SurfaceView above;
  const BoxVector up = {0, 0, 1};
  EXPECT_GT(brightness(up, above), 0.9);
  EXPECT_LE(brightness(up, above), 1.05);
  EXPECT_NEAR(brightness({0, 0, -1}, above), brightness(up, above), kRounding);
}

}  // namespace
}  // namespace tactus::figures
