#include <gtest/gtest.h>
#include <vector>

#include "app/workbench/participant/participant_controller.h"

namespace tactus::workbench {
namespace {

class DeviceButtonTest : public testing::Test {
 protected:
  // Samples at 1 kHz with the buttons `down`; what they were taken for.
  std::vector<ButtonPress> hold(std::uint32_t down, int milliseconds) {
    std::vector<ButtonPress> out;
    for (int i = 0; i < milliseconds; ++i) {
      haptics::Sample sample;
      sample.time_ns = time_ns_ += 1'000'000;
      sample.buttons = down;
      if (const auto press = button.add(sample)) out.push_back(*press);
    }
    return out;
  }

  DeviceButton button;

 private:
  std::int64_t time_ns_ = 0;
};

TEST_F(DeviceButtonTest, AShortPressIsATapAndALongOneIsHeldOnce) {
  EXPECT_TRUE(hold(0, 400).empty());
  EXPECT_TRUE(hold(1, 300).empty());
  EXPECT_EQ(hold(0, 10), std::vector{ButtonPress::kTap});
  EXPECT_TRUE(hold(1, 790).empty());
  EXPECT_EQ(hold(1, 1000), std::vector{ButtonPress::kHeld});
  EXPECT_TRUE(hold(0, 10).empty());
}

TEST_F(DeviceButtonTest, BetweenTheTwoNothingIsMeant) {
  hold(0, 400);
  EXPECT_TRUE(hold(1, 600).empty());
  EXPECT_TRUE(hold(0, 10).empty());
}

TEST_F(DeviceButtonTest, APressThatHeldTheTubeOrCameTooSoonAnswersNothing) {
  hold(1, 500);
  EXPECT_TRUE(hold(0, 100).empty());
  hold(1, 50);
  EXPECT_TRUE(hold(0, 10).empty()) << "let go 0.1 s before";
}

TEST_F(DeviceButtonTest, TheOtherButtonIsNotThisOne) {
  hold(0, 400);
  EXPECT_TRUE(hold(2, 100).empty());
  EXPECT_TRUE(hold(0, 10).empty());
}

}  // namespace
}  // namespace tactus::workbench
