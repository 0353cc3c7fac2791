#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "experiments/stroke_segmentation.h"

namespace tactus::experiments {
namespace {

constexpr double kStepS = 0.004;

TEST(SmoothMotion, AParabolaComesBackWithItsSpeed) {
  std::vector<double> positions;
  for (int i = 0; i < 150; ++i) {
    const double t = i * kStepS;
    positions.push_back(5 + 20 * t + 30 * t * t);
  }
  const SmoothMotion motion(positions, kStepS);
  for (const double t : {0.0, 0.1, 0.3, 0.596}) {
    // The penalty leaves parabolas free; what is left is the rounding of the normal equations.
    EXPECT_NEAR(motion.speedMmS(t), 20 + 60 * t, 1e-3);
    EXPECT_NEAR(motion.positionMm(t), 5 + 20 * t + 30 * t * t, 1e-4);
  }
  EXPECT_EQ(motion.speedMmS(-1), motion.speedMmS(0));
}

TEST(SmoothMotion, TremorIsNoMovement) {
  for (const double hz : {8.0, 9.3, 10.0, 11.7}) {
    std::vector<double> positions;
    for (int i = 0; i < 150; ++i) {
      const double t = i * kStepS;
      positions.push_back(25 * t + 0.3 * std::sin(2 * std::numbers::pi * hz * t + 1));
    }
    const SmoothMotion motion(positions, kStepS);
    // Tremor alone has speeds of up to 15 to 22 mm/s; 0.5 mm/s is a tenth of the smallest speed that matters.
    for (double t = 0.1; t < 0.5; t += 0.01) EXPECT_NEAR(motion.speedMmS(t), 25, 0.5) << hz << " Hz at " << t;
  }
}

}  // namespace
}  // namespace tactus::experiments
