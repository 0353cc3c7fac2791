#include <gtest/gtest.h>

#include "core/haptics/safety/safety.h"

namespace tactus::haptics {
namespace {

/// The switch under a contact that is scripted millisecond by millisecond.
class EnableSwitchTest : public testing::Test {
 protected:
  EnableSettings settings_;
  EnableSwitch switch_;
  bool armed_ = true;
  double position_mm_ = 0;

  bool tick(std::optional<bool> down, int times = 1) {
    for (int i = 0; i < times; ++i) switch_.update({++ms_ * 1'000'000, armed_, down, position_mm_}, settings_);
    return switch_.on();
  }
  /// Ticks until the switch is on, with the contact down.
  int ticksUntilOn() {
    for (int i = 1; i <= 100; ++i)
      if (tick(true)) return i;
    return -1;
  }

 private:
  std::int64_t ms_ = 1000;
};

TEST_F(EnableSwitchTest, APressCountsAfterFifteenMilliseconds) {
  tick(false);
  EXPECT_EQ(ticksUntilOn(), 16);  // the first tick of the press is time 0
}

TEST_F(EnableSwitchTest, AReleaseCountsAtOnceAndABounceStartsTheDebounceAgain) {
  tick(false);
  ticksUntilOn();
  EXPECT_FALSE(tick(false));
  EXPECT_FALSE(tick(true, 10));
  EXPECT_FALSE(tick(false));
  EXPECT_FALSE(tick(true, 15));
  EXPECT_TRUE(tick(true));
}

TEST_F(EnableSwitchTest, AContactThatIsDownAtTheStartEnablesNothing) {
  EXPECT_FALSE(tick(true, 1000));
  tick(false);
  EXPECT_EQ(ticksUntilOn(), 16);
}

TEST_F(EnableSwitchTest, ArmingWithTheContactDownNeedsAReleaseFirst) {
  armed_ = false;
  tick(false);
  EXPECT_FALSE(tick(true, 100));
  armed_ = true;
  EXPECT_FALSE(tick(true, 1000));
  tick(false);
  EXPECT_TRUE(tick(true, 16));
}

TEST_F(EnableSwitchTest, DisarmingSwitchesOffAndAsksForARelease) {
  tick(false);
  ticksUntilOn();
  armed_ = false;
  EXPECT_FALSE(tick(true));
  EXPECT_FALSE(switch_.letGo());
  tick(false);
  EXPECT_TRUE(switch_.letGo());
  armed_ = true;
  tick(true, 100);
  EXPECT_TRUE(switch_.letGo());
}

TEST_F(EnableSwitchTest, LettingGoWhileArmedIsNotLettingGoAfterDisarming) {
  tick(false, 10);
  EXPECT_FALSE(switch_.letGo());
}

TEST_F(EnableSwitchTest, AnUnknownContactSwitchesNothing) {
  tick(false);
  ticksUntilOn();
  EXPECT_TRUE(tick(std::nullopt, 100));
  tick(false);
  tick(true, 10);
  tick(std::nullopt, 100);
  EXPECT_FALSE(tick(true, 14));
  EXPECT_TRUE(tick(true, 2));
}

TEST_F(EnableSwitchTest, APressOutsideTheStartZoneIsSpent) {
  settings_.start_zone_mm = 5;
  position_mm_ = 5.1;
  tick(false);
  EXPECT_FALSE(tick(true, 100));
  position_mm_ = -5;
  EXPECT_FALSE(tick(true, 100));
  tick(false);
  EXPECT_TRUE(tick(true, 16));
  position_mm_ = 60;  // the zone is for the start only
  EXPECT_TRUE(tick(true, 10));
}

TEST_F(EnableSwitchTest, AnotherKindOfSwitchStartsAnew) {
  tick(false);
  ticksUntilOn();
  settings_.kind = EnableKind::kPedal;
  EXPECT_FALSE(tick(true, 100));
  tick(false);
  EXPECT_TRUE(tick(true, 16));
  settings_.kind = EnableKind::kButton;
  settings_.button_mask = 2;
  EXPECT_FALSE(tick(true));
}

TEST_F(EnableSwitchTest, ALatchStaysOnUntilTheNextPress) {
  settings_.kind = EnableKind::kLatch;
  tick(false);
  EXPECT_EQ(ticksUntilOn(), 16);
  EXPECT_TRUE(tick(true, 500));
  EXPECT_TRUE(tick(false, 500));
  EXPECT_FALSE(tick(true));       // off at once
  EXPECT_FALSE(tick(true, 500));  // the same press does not switch on again
  tick(false, 20);
  EXPECT_TRUE(tick(true, 16));
}

TEST_F(EnableSwitchTest, AContactThatBouncesAfterTheFirstPressDoesNotSwitchTheLatchOff) {
  settings_.kind = EnableKind::kLatch;
  tick(false);
  ticksUntilOn();
  for (int i = 0; i < 5; ++i) {
    EXPECT_TRUE(tick(false, 3));
    EXPECT_TRUE(tick(true, 2));
  }
}

TEST_F(EnableSwitchTest, ALatchLetsGoInTheReleaseZone) {
  settings_.kind = EnableKind::kLatch;
  settings_.release_zone_mm = -20;
  tick(false);
  ticksUntilOn();
  tick(false, 50);
  position_mm_ = -20;
  EXPECT_TRUE(tick(false));
  position_mm_ = -20.1;
  EXPECT_FALSE(tick(false));
  EXPECT_FALSE(tick(true, 100));  // nor does a press there
  position_mm_ = 0;
  EXPECT_FALSE(tick(true, 100));
  tick(false, 20);
  EXPECT_TRUE(tick(true, 16));
}

}  // namespace
}  // namespace tactus::haptics
