#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/haptics/simulated/virtual_device.h"

namespace tactus::haptics {
namespace {

TEST(LiveHand, FollowsWithoutOvershootAndNoFasterThanAllowed) {
  for (const double target_mm : {0.5, 20.0, -150.0}) {
    LiveHand hand(0.03, 300);
    hand.setTarget(target_mm);
    double before_mm = 0;
    for (int i = 0; i < 2000; ++i) {
      const HandTarget wish = hand.next();
      ASSERT_LE(std::abs(wish.speed_mm_s), 300);
      ASSERT_NEAR(wish.position_mm - before_mm, 0.001 * wish.speed_mm_s, 1e-12);
      ASSERT_LE(wish.position_mm / target_mm, 1 + 1e-12);
      before_mm = wish.position_mm;
    }
    EXPECT_NEAR(before_mm, target_mm, 1e-9);  // 1.5 s and more at a time constant of 30 ms
  }
}

TEST(LiveHand, ComesNearAsACriticallyDampedFollowerDoes) {
  // 1 - (1 + t/T) exp(-t/T) after t = 3 T is 0.8009; the step of 1 ms is off by about dt/T of the rest.
  LiveHand hand(0.03, 1e6);
  hand.setTarget(10);
  HandTarget wish;
  for (int i = 0; i < 90; ++i) wish = hand.next();
  EXPECT_NEAR(wish.position_mm, 8.009, 10 * 0.199 / 30 + 0.01);
}

TEST(LiveHand, IgnoresTargetsThatAreNoNumber) {
  LiveHand hand(0.03, 300);
  hand.setTarget(5);
  hand.setTarget(std::numeric_limits<double>::quiet_NaN());
  hand.setTarget(std::numeric_limits<double>::infinity());
  for (int i = 0; i < 2000; ++i) hand.next();
  EXPECT_NEAR(hand.next().position_mm, 5, 1e-9);
  hand.place(-3);
  EXPECT_NEAR(hand.next().position_mm, -3, 0.02);  // one millisecond of the way: 8 mm (dt/T)² = 0.009 mm
}

TEST(LiveHand, ButtonIsThatOfTheLastMillisecond) {
  LiveHand hand(0.03, 300);
  EXPECT_FALSE(hand.next().button);
  hand.setButton(true);
  EXPECT_TRUE(hand.next().button);
  hand.setButton(false);
  EXPECT_FALSE(hand.next().button);
}

}  // namespace
}  // namespace tactus::haptics
