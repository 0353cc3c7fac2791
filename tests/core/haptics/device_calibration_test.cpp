#include "core/haptics/device_calibration.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <limits>

#include "core/base/file.h"

#include "tests/support/temp_folder.h"

namespace tactus::haptics {
namespace {

DeviceCalibration sample() {
  DeviceCalibration c;
  c.device = "hid:1209:ffb0:7";
  c.serial = "7";
  c.full_scale_n = 12.5;
  c.force_sign = {1, 1, -1};
  c.mm_per_count = 0.0125;
  c.inwards = {0.6, 0, -0.8};
  c.origin_mm = {1, 2, 3.25};
  c.friction_in_n = 0.31;
  c.silent_when_still = true;
  c.measured_at = "2026-11-21T08:00:00Z";
  c.procedure = "guided 1, spring scale";
  return c;
}

class CalibrationFile : public testing::Test {
 protected:
  std::string refusal(const std::string& text) {
    EXPECT_TRUE(base::writeFileAtomically(path_, text));
    const auto entries = readCalibrations(path_);
    return entries ? "accepted" : entries.error().message().substr(path_.size() + 2);
  }
  /// The file of `sample` with one text replaced.
  std::string refusalWith(const std::string& old_text, const std::string& new_text) {
    std::filesystem::remove(path_);
    EXPECT_TRUE(storeCalibration(path_, sample()));
    std::string text = *base::readFile(path_, 100000);
    const auto at = text.find(old_text);
    EXPECT_NE(at, std::string::npos) << old_text;
    return refusal(text.replace(at, old_text.size(), new_text));
  }

  support::TempFolder folder_;
  std::string path_ = folder_.file("devices.json");
};

TEST_F(CalibrationFile, ReadsBackWhatItStored) {
  EXPECT_TRUE(readCalibrations(path_)->empty()) << "no file yet";
  ASSERT_TRUE(storeCalibration(path_, sample()));
  auto other = sample();
  other.serial = "8";
  other.friction_out_n = 0.1 + 0.2;
  ASSERT_TRUE(storeCalibration(path_, other));
  const auto entries = readCalibrations(path_);
  ASSERT_TRUE(entries) << entries.error().message();
  EXPECT_EQ(*entries, (std::vector{sample(), other}));
  EXPECT_EQ(*findCalibration(*entries, "hid:1209:ffb0:7", "8"), other);
  EXPECT_EQ(findCalibration(*entries, "hid:1209:ffb0:7", "9"), nullptr);
}

TEST_F(CalibrationFile, ANewMeasurementTakesThePlaceOfTheOldOne) {
  ASSERT_TRUE(storeCalibration(path_, sample()));
  auto newer = sample();
  newer.full_scale_n = 13;
  ASSERT_TRUE(storeCalibration(path_, newer));
  EXPECT_EQ(*readCalibrations(path_), std::vector{newer});
}

TEST_F(CalibrationFile, NonsenseIsRefusedWithItsPlace) {
  EXPECT_EQ(refusalWith("12.5", "-3"), "/devices/0/full_scale_n: found -3, wanted a number from 0.05 to 500");
  EXPECT_EQ(refusalWith("12.5", "\"12\""), "/devices/0/full_scale_n: found '\"12\"', wanted a number");
  EXPECT_EQ(refusalWith("0.0125", "0"), "/devices/0/mm_per_count: found 0, wanted a number from 1e-06 to 100");
  EXPECT_EQ(refusalWith("0.31", "99"), "/devices/0/friction_in_n: found 99, wanted a number from 0 to 12.5");
  EXPECT_EQ(refusalWith("0.6", "0.9"),
            "/devices/0/inwards: found a vector of length 1.2041594578792296, wanted length 1");
  EXPECT_EQ(refusalWith("-1", "-2"), "/devices/0/force_sign: found another number, wanted 1 or -1 three times");
  EXPECT_EQ(refusalWith("\"serial\"", "\"seriel\""), "/devices/0/serial: found nothing, wanted a value");
  EXPECT_EQ(refusalWith("\"tactus_devices\": 1", "\"tactus_devices\": 2"), "/tactus_devices: found 2, wanted 1");
}

TEST_F(CalibrationFile, OtherFilesAreRefused) {
  EXPECT_EQ(refusal("{"), "found text that is not JSON, wanted a calibration file");
  EXPECT_EQ(refusal("[]"), "found no whole number under 'tactus_devices', wanted a calibration file");
  EXPECT_EQ(refusal("{\"tactus_devices\": 1, \"devices\": {}}"),
            "found other keys, wanted 'tactus_devices' and an array 'devices'");
  EXPECT_EQ(refusal("{\"tactus_devices\": 1, \"devices\": [3]}"), "/devices/0: found '3', wanted an object");
}

TEST_F(CalibrationFile, TwoEntriesOfOneDeviceAreRefused) {
  ASSERT_TRUE(storeCalibration(path_, sample()));
  std::string text = *base::readFile(path_, 100000);
  const auto begin = text.find('{', 1);
  const auto end = text.rfind('}', text.rfind(']'));
  const std::string entry = text.substr(begin, end + 1 - begin);
  EXPECT_EQ(refusal(text.insert(end + 1, "," + entry)),
            "/devices/1: found a second entry of 'hid:1209:ffb0:7', wanted one entry per device and serial number");
}

TEST_F(CalibrationFile, ABrokenFileIsNotOverwritten) {
  ASSERT_TRUE(base::writeFileAtomically(path_, "not JSON"));
  EXPECT_FALSE(storeCalibration(path_, sample()));
  EXPECT_EQ(*base::readFile(path_, 100), "not JSON");
}

TEST(DeviceCalibration, NumbersThatAreNoneAreRefused) {
  auto c = sample();
  EXPECT_TRUE(checkCalibration(c));
  c.full_scale_n = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(checkCalibration(c));
  c = sample();
  c.origin_mm.y = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(checkCalibration(c));
  c = sample();
  c.inwards = {};
  EXPECT_FALSE(checkCalibration(c));
}

TEST(DeviceCalibration, GivesTheInsertionAxis) {
  const AxisMapping axis = axisOf(sample());
  EXPECT_NEAR(axis.positionMm({1.6, 2, 2.45}), 0.6 * 0.6 + 0.8 * 0.8, 1e-12);
}

}  // namespace
}  // namespace tactus::haptics
