#include <cmath>
#include <gtest/gtest.h>

#include "core/haptics/safety/safety.h"

namespace tactus::haptics {
namespace {

// exp(-x) is computed as 1 / (1 + x + x²/2 + x³/6), x up to 1.5: within 3 % of it.
TEST(Watchdog, AStaleForceDecaysNoSlowerThanTenMillisecondsAndEndsWithoutAStep) {
  const LimitSettings limits;
  EXPECT_EQ(staleShare(0, limits), 1);
  EXPECT_EQ(staleShare(0.005, limits), 1);
  EXPECT_EQ(staleShare(0.020, limits), 0);
  EXPECT_EQ(staleShare(1e9, limits), 0);
  const double last = std::exp(-1.5);
  double before = 1;
  for (double age_s = 0.0051; age_s < 0.02; age_s += 0.0001) {
    const double share = staleShare(age_s, limits);
    const double decay = std::exp(-(age_s - 0.005) / 0.01);
    EXPECT_LE(share, decay);
    EXPECT_NEAR(share, (decay - last) / (1 - last), 0.03);
    EXPECT_LE(share, before);
    EXPECT_LE(before - share, 0.0001 * 500 / 3);  // 3 N fall no faster than the slew toward zero
    before = share;
  }
  EXPECT_LT(before, 0.01);
}

TEST(Watchdog, NamesTheCauseThatTheOthersFollowFrom) {
  const LimitSettings limits;
  EXPECT_FALSE(overdue({0.1, 0.05, 0.1}, limits));
  EXPECT_EQ(overdue({0.2, 0.2, 0.2}, limits), (Trip{TripCause::kServoLate, 0.2, 0.1, 0}));
  EXPECT_EQ(overdue({0.2, 0.2, 0.001}, limits), (Trip{TripCause::kDeviceSilent, 0.2, 0.1, 0}));
  EXPECT_EQ(overdue({0.001, 0.06, 0.001}, limits), (Trip{TripCause::kWriteStuck, 0.06, 0.05, 0}));
}

}  // namespace
}  // namespace tactus::haptics
