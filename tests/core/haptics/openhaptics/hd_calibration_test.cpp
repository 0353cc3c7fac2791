#include "core/haptics/openhaptics/openhaptics_device.h"

#include "tests/core/haptics/openhaptics/loaded_stand_in.h"

namespace tactus::haptics {
namespace {

using HdCalibrationTest = WithStandIn;

TEST_F(HdCalibrationTest, ACalibratedDeviceIsLeftAlone) {
  HdCalibration calibration(library_->api(), hd::kInkwell);
  EXPECT_FALSE(calibration.calibrated());
  calibration.look();
  EXPECT_TRUE(calibration.calibrated());
  EXPECT_TRUE(standIn().calibration_updates.empty());
}

TEST_F(HdCalibrationTest, InTheInkwellItIsTakenOver) {
  standIn().calibration = hd::kNeedsManualInput;
  HdCalibration calibration(library_->api(), hd::kInkwell);
  calibration.look();
  EXPECT_FALSE(calibration.calibrated());
  EXPECT_TRUE(standIn().calibration_updates.empty());
  standIn().calibration = hd::kNeedsUpdate;
  calibration.look();
  EXPECT_TRUE(calibration.calibrated());
  EXPECT_EQ(standIn().calibration_updates, std::vector<unsigned>{hd::kInkwell});
}

TEST_F(HdCalibrationTest, OnceCalibratedTheInkwellDoesNotShiftPositions) {
  HdCalibration calibration(library_->api(), hd::kInkwell);
  calibration.look();
  standIn().calibration = hd::kNeedsUpdate;
  calibration.look();
  EXPECT_TRUE(calibration.calibrated());
  EXPECT_TRUE(standIn().calibration_updates.empty());
}

TEST_F(HdCalibrationTest, AnEncoderResetWaitsForAPerson) {
  standIn().calibration = hd::kNeedsUpdate;
  HdCalibration calibration(library_->api(), hd::kEncoderReset);
  calibration.look();
  EXPECT_FALSE(calibration.calibrated());
  EXPECT_TRUE(standIn().calibration_updates.empty());
  calibration.request();
  EXPECT_TRUE(calibration.requested());
  calibration.look();
  EXPECT_TRUE(calibration.calibrated());
  EXPECT_FALSE(calibration.requested());
  EXPECT_EQ(standIn().calibration_updates, std::vector<unsigned>{hd::kEncoderReset});
}

TEST_F(HdCalibrationTest, AFailedUpdateIsNoCalibration) {
  standIn().calibration = hd::kNeedsUpdate;
  standIn().calibration_after_update = hd::kNeedsManualInput;
  HdCalibration calibration(library_->api(), hd::kAutomatic);
  calibration.look();
  EXPECT_FALSE(calibration.calibrated());
  EXPECT_EQ(standIn().calibration_updates, std::vector<unsigned>{hd::kAutomatic});
}

TEST_F(HdCalibrationTest, CalibrationCanBeLost) {
  HdCalibration calibration(library_->api(), hd::kInkwell);
  calibration.look();
  standIn().calibration = hd::kNeedsManualInput;
  calibration.look();
  EXPECT_FALSE(calibration.calibrated());
}

TEST(CalibrationAdvice, SaysWhatAPersonDoes) {
  EXPECT_EQ(calibrationAdvice(hd::kInkwell | hd::kEncoderReset),
            "put the stylus into the inkwell and leave it there for a second");
  EXPECT_EQ(calibrationAdvice(hd::kAutomatic), "move the stylus slowly through its whole space");
  EXPECT_EQ(calibrationAdvice(hd::kEncoderReset),
            "hold the stylus in the reference posture of the device's manual and calibrate");
  EXPECT_EQ(calibrationAdvice(0), "calibrate it with its maker's program (Touch Setup, Touch Diagnostics)");
}

}  // namespace
}  // namespace tactus::haptics
