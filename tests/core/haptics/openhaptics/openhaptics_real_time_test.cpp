// Nothing in a frame of ours allocates, locks, waits or writes.
#include "tests/core/haptics/openhaptics/loaded_stand_in.h"
#include "tests/support/real_time_trap.h"

namespace tactus::haptics {
namespace {

TEST_F(WithStandIn, AFrameIsRealTimeSafeWithAndWithoutErrors) {
  const auto device = open();
  ASSERT_TRUE(device->start());
  Asking program(*device, {0, 0, 1});
  ASSERT_TRUE(device->ownLoop()->run(program));
  step();
  standIn().errors_of_next_frame = {0x0200, 0x0201};
  step();  // the stack of the stand-in has its memory now
  program.force_n = {};
  steps(600);
  program.force_n = {0, 0, 1};
  standIn().errors_of_next_frame = {0x0200};
  support::RealTimeTrap trap;
  for (int frame = 0; frame < 100; ++frame) step();
  trap.disarm();
  EXPECT_EQ(trap.hits(), 0) << trap.first();
  EXPECT_EQ(program.seen.fault, DeviceFault::kWarmMotors);
}

}  // namespace
}  // namespace tactus::haptics
