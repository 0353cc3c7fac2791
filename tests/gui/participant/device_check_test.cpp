#include <gtest/gtest.h>

#include "app/workbench/participant/participant_course.h"

namespace tactus::workbench {
namespace {

class DeviceCheckTest : public testing::Test {
 protected:
  // The hand for a time, moving evenly to `to_mm`.
  void hand(bool holds, double seconds, double to_mm) {
    const int ticks = static_cast<int>(seconds * 1000);
    const double from_mm = sample_.position_mm;
    for (int i = 1; i <= ticks; ++i) {
      ++sample_.tick;
      sample_.time_ns += 1'000'000;
      sample_.enabled = holds;
      sample_.position_mm = from_mm + (to_mm - from_mm) * i / ticks;
      check.add({&sample_, 1});
    }
  }

  DeviceCheck check;

 private:
  haptics::Sample sample_;
};

TEST_F(DeviceCheckTest, HoldStillPushLetGo) {
  hand(false, 0.1, 0);
  EXPECT_EQ(check.step(), DeviceStep::kHold);
  hand(true, 0.5, 0);
  EXPECT_EQ(check.step(), DeviceStep::kStill);
  hand(true, 0.6, 1);  // tremor and drift below 3 mm are still
  EXPECT_EQ(check.step(), DeviceStep::kPush);
  hand(true, 0.5, 15);
  EXPECT_EQ(check.step(), DeviceStep::kPush) << "14 mm are no push of 20 mm";
  hand(true, 0.5, 25);
  EXPECT_EQ(check.step(), DeviceStep::kRelease);
  hand(false, 0.1, 25);
  EXPECT_EQ(check.step(), DeviceStep::kReady);
}

TEST_F(DeviceCheckTest, AMovingHandIsNotStillAndALetGoHandleBeginsAgain) {
  hand(false, 0.1, 0);
  hand(true, 2, 40);  // 20 mm/s: never 1 s within 3 mm
  EXPECT_EQ(check.step(), DeviceStep::kStill);
  hand(true, 1.1, 40);
  EXPECT_EQ(check.step(), DeviceStep::kPush);
  hand(false, 0.1, 40);
  EXPECT_EQ(check.step(), DeviceStep::kHold);
}

TEST_F(DeviceCheckTest, AButtonThatIsStuckIsNeverHeld) {
  hand(true, 5, 0);
  EXPECT_EQ(check.step(), DeviceStep::kHold);
}

}  // namespace
}  // namespace tactus::workbench
