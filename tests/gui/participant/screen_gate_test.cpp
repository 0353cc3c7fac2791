#include <gtest/gtest.h>

#include "app/workbench/participant/participant_controller.h"

namespace tactus::workbench {
namespace {

constexpr std::int64_t kMs = 1'000'000;

TEST(ScreenGate, OpensThreeTenthsOfASecondAfterTheFirstFrame) {
  ScreenGate gate;
  EXPECT_FALSE(gate.takesInput(10'000 * kMs)) << "not painted yet";
  gate.painted(1000 * kMs);
  EXPECT_FALSE(gate.takesInput(1299 * kMs));
  EXPECT_TRUE(gate.takesInput(1300 * kMs));
  gate.painted(1350 * kMs);  // another frame of the same screen
  EXPECT_TRUE(gate.takesInput(1351 * kMs));
  EXPECT_EQ(gate.paintedNs(), 1000 * kMs);
}

TEST(ScreenGate, AHeldKeyAnswersNothingUntilItWasLetGo) {
  ScreenGate gate;
  gate.held(true, 900 * kMs);
  gate.painted(1000 * kMs);
  EXPECT_FALSE(gate.takesInput(5000 * kMs));
  EXPECT_TRUE(gate.isSettled(5000 * kMs)) << "the hand on the device is no key";
  gate.held(false, 5000 * kMs);
  EXPECT_FALSE(gate.takesInput(5299 * kMs));
  EXPECT_TRUE(gate.takesInput(5300 * kMs));
  gate.held(true, 5400 * kMs);
  EXPECT_TRUE(gate.takesInput(5400 * kMs)) << "a new press counts";
}

TEST(ScreenGate, TheNextScreenBeginsAnew) {
  ScreenGate gate;
  gate.painted(1000 * kMs);
  gate.held(true, 1400 * kMs);
  gate.close();
  EXPECT_FALSE(gate.takesInput(9000 * kMs));
  gate.painted(9000 * kMs);
  EXPECT_FALSE(gate.takesInput(9900 * kMs)) << "the key of the screen before is still down";
  gate.held(false, 9900 * kMs);
  EXPECT_TRUE(gate.takesInput(10'200 * kMs));
}

}  // namespace
}  // namespace tactus::workbench
