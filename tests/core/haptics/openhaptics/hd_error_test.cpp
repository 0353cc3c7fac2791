#include "core/haptics/openhaptics/openhaptics_device.h"

#include "tests/core/haptics/openhaptics/loaded_stand_in.h"

namespace tactus::haptics {
namespace {

TEST(HdError, ForceErrorsLeaveTheLoopRunning) {
  EXPECT_EQ(faultOf(0), DeviceFault::kNone);
  EXPECT_EQ(faultOf(0x0200), DeviceFault::kWarmMotors);
  for (const std::uint32_t code : {0x0201u, 0x0202u, 0x0203u, 0x0204u})
    EXPECT_EQ(faultOf(code), DeviceFault::kForceLimited) << code;
  for (const std::uint32_t code : {0x0200u, 0x0201u, 0x0202u, 0x0203u, 0x0204u}) EXPECT_FALSE(endsLoop(code)) << code;
}

TEST(HdError, LostConnectionsDeadTimersAndBrokenFramesEndIt) {
  for (const std::uint32_t code : {0x0302u, 0x0304u, 0x0400u, 0x0401u}) {
    EXPECT_TRUE(endsLoop(code)) << code;
    EXPECT_EQ(faultOf(code), DeviceFault::kLost) << code;
  }
}

TEST(HdError, EverythingElseIsAFailure) {
  for (const std::uint32_t code : {0x0100u, 0x0102u, 0x0300u, 0x0303u, 0x0402u, 0x0500u, 0x0600u, 0x9999u}) {
    EXPECT_EQ(faultOf(code), DeviceFault::kFailed) << code;
    EXPECT_FALSE(endsLoop(code)) << code;
  }
}

TEST_F(WithStandIn, TheWholeStackIsEmptiedAndTheGravestCounts) {
  const HdApi& api = library_->api();
  standIn().errors_of_next_frame = {0x0201, 0x0200, 0x0204};
  api.begin_frame(7);
  api.end_frame(7);
  const HdErrors errors = drainErrors(api);
  EXPECT_EQ(errors.count, 3);
  EXPECT_EQ(errors.newest.code, 0x0204u);
  EXPECT_EQ(errors.gravest.code, 0x0200u);
  EXPECT_EQ(errors.fault, DeviceFault::kWarmMotors);
  EXPECT_EQ(drainErrors(api).count, 0);
}

TEST_F(WithStandIn, ALibraryThatNeverRunsOutOfErrorsIsCutOff) {
  standIn().error_for_ever = true;
  EXPECT_EQ(drainErrors(library_->api()).count, 64);
}

TEST_F(WithStandIn, TheSentenceHasNumberAndWordsOnOneLine) {
  EXPECT_EQ(describe(library_->api(), {0x0200, 7, 0}),
            "the motors are too warm (0x0200, internal 7, '" + base::oneLine("Warm\nmotors") + "')");
  EXPECT_EQ(describe(library_->api(), {0x12345, 0, 0}), "the driver reports an error (0x12345, 'words of the driver')");
}

}  // namespace
}  // namespace tactus::haptics
