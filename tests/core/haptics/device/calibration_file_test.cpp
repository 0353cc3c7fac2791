#include "core/haptics/device/calibration_file.h"

#include <filesystem>
#include <gtest/gtest.h>

#include "core/base/files/file.h"

#include "tests/core/haptics/device/sample_calibration.h"
#include "tests/support/temp_folder.h"

namespace tactus::haptics {
namespace {

class CalibrationFile : public testing::Test {
 protected:
  std::string refusal(const std::string& text) {
    EXPECT_TRUE(base::writeFileAtomically(path_, text));
    const auto file = readCalibrationFile(path_);
    return file ? "accepted" : file.error().message().substr(path_.size() + 2);
  }
  /// The file of `sample`.
  std::string storedText() {
    std::filesystem::remove(path_);
    EXPECT_TRUE(storeCalibration(path_, sample()));
    return *base::readFile(path_, 100000);
  }
  /// The same with one text replaced.
  std::string changedText(const std::string& old_text, const std::string& new_text) {
    std::string text = storedText();
    const auto at = text.find(old_text);
    EXPECT_NE(at, std::string::npos) << old_text;
    return text.replace(at, old_text.size(), new_text);
  }
  std::string refusalWith(const std::string& old_text, const std::string& new_text) {
    return refusal(changedText(old_text, new_text));
  }

  support::TempFolder folder_;
  std::string path_ = folder_.file("devices.json");
};

TEST_F(CalibrationFile, ReadsBackWhatItStored) {
  EXPECT_TRUE(readCalibrationFile(path_)->calibrations.empty()) << "no file yet";
  ASSERT_TRUE(storeCalibration(path_, sample()));
  auto other = sample();
  other.serial = "8";
  other.friction_out_n = 0.1 + 0.2;
  ASSERT_TRUE(storeCalibration(path_, other));
  const auto file = readCalibrationFile(path_);
  ASSERT_TRUE(file) << file.error().message();
  EXPECT_EQ(file->calibrations, (std::vector{sample(), other}));
  EXPECT_EQ(*findCalibration(file->calibrations, "hid:1209:ffb0:7", "8"), other);
  EXPECT_EQ(findCalibration(file->calibrations, "hid:1209:ffb0:7", "9"), nullptr);
}

TEST_F(CalibrationFile, ANewMeasurementTakesThePlaceOfTheOldOne) {
  ASSERT_TRUE(storeCalibration(path_, sample()));
  auto newer = sample();
  newer.full_scale_n = 13;
  ASSERT_TRUE(storeCalibration(path_, newer));
  EXPECT_EQ(readCalibrationFile(path_)->calibrations, std::vector{newer});
}

TEST_F(CalibrationFile, AnAxisIsKeptBesideTheMeasurements) {
  const DeviceAxis axis{"openhaptics", "S-0042", {0, 0, 1}};
  ASSERT_TRUE(storeAxis(path_, {"openhaptics", "S-0042", {1, 0, 0}}));
  ASSERT_TRUE(storeCalibration(path_, sample()));
  ASSERT_TRUE(storeAxis(path_, axis));
  const auto file = readCalibrationFile(path_);
  ASSERT_TRUE(file) << file.error().message();
  EXPECT_EQ(file->axes, std::vector{axis}) << "the newer one";
  EXPECT_EQ(file->calibrations, std::vector{sample()});
  EXPECT_EQ(findAxis(file->axes, "openhaptics", "S-0043"), nullptr);
  EXPECT_FALSE(storeAxis(path_, {"openhaptics", "S-0042", {0, 0, 0}}));
}

TEST_F(CalibrationFile, AFileWithoutAxesIsReadToo) {
  EXPECT_EQ(refusal(R"({"tactus_devices": 1, "devices": []})"), "accepted");
}

TEST_F(CalibrationFile, NonsenseIsRefusedWithItsPlace) {
  EXPECT_EQ(refusalWith("12.5", "-3"), "/devices/0/full_scale_n: found -3, wanted a number from 0.05 to 500");
  EXPECT_TRUE(
      refusalWith("12.5", "\"12\"").starts_with("/devices/0/full_scale_n: found the string '12', wanted a num"));
  EXPECT_EQ(refusalWith("0.0125", "0"), "/devices/0/mm_per_count: found 0, wanted a number from 1e-06 to 100");
  EXPECT_EQ(refusalWith("0.31", "99"), "/devices/0/friction_in_n: found 99, wanted a number from 0 to 12.5");
  EXPECT_EQ(refusalWith("0.6", "0.9"),
            "/devices/0/inwards: found a vector of length 1.2041594578792296, wanted length 1");
  EXPECT_EQ(refusalWith("0.6", "0.6, 0"), "/devices/0/inwards: found 4 numbers, wanted three numbers");
  EXPECT_EQ(refusalWith("-1", "-2"), "/devices/0/force_sign: found another number, wanted 1 or -1 three times");
  EXPECT_EQ(refusalWith("\"serial\"", "\"seriel\""),
            "/devices/0: found no key 'serial', wanted a key 'serial' with a string");
  EXPECT_EQ(refusalWith("\"axes\": []", "\"axes\": [], \"more\": 1"),
            "/more: found an unknown key, wanted 'tactus_devices', 'devices' or 'axes'");
  EXPECT_EQ(refusalWith("\"tactus_devices\": 1", "\"tactus_devices\": 2"),
            "/tactus_devices: found version 2, newer than this program, wanted at most version 1");
}

TEST_F(CalibrationFile, AKeyThatStandsTwiceIsRefused) {
  const std::string reason = refusalWith("\"full_scale_n\": 12.5", "\"full_scale_n\": 12.5, \"full_scale_n\": 0.06");
  EXPECT_TRUE(reason.starts_with("/devices/0/full_scale_n: found ")) << reason;
}

TEST_F(CalibrationFile, HostileFilesAreRefusedInOneSentence) {
  const std::string deep =
      "{\"tactus_devices\": 1, \"devices\": " + std::string(500'000, '[') + std::string(500'000, ']') + "}";
  for (const std::string& text : {deep, std::string(900'000, '['), changedText("12.5", "1e400"), std::string("{"),
                                  std::string("[]"), std::string("not JSON"), std::string(2'000'000, ' ')}) {
    const std::string reason = refusal(text);
    EXPECT_NE(reason, "accepted") << text.substr(0, 80);
    EXPECT_EQ(reason.find('\n'), std::string::npos) << reason;
    EXPECT_LT(reason.size(), 300U) << reason;
  }
}

TEST_F(CalibrationFile, OtherFilesAreRefused) {
  EXPECT_EQ(refusal("{}"), "found no key 'tactus_devices', wanted a key 'tactus_devices' with a number");
  EXPECT_EQ(refusal("{\"tactus_devices\": 1, \"devices\": {}}"), "/devices: found an object, wanted an array");
  EXPECT_EQ(refusal("{\"tactus_devices\": 1, \"devices\": [3]}"), "/devices/0: found the number 3, wanted an object");
}

TEST_F(CalibrationFile, TwoEntriesOfOneDeviceAreRefused) {
  const std::string text = storedText();
  const auto begin = text.find('{', 1);
  const auto end = text.find('}', begin);
  const std::string entry = text.substr(begin, end + 1 - begin);
  EXPECT_EQ(refusal(std::string(text).insert(end + 1, "," + entry)),
            "/devices/1: found a second entry of 'hid:1209:ffb0:7', wanted one entry per device and serial number");
}

TEST_F(CalibrationFile, ABrokenFileIsNotOverwritten) {
  ASSERT_TRUE(base::writeFileAtomically(path_, "not JSON"));
  EXPECT_FALSE(storeCalibration(path_, sample()));
  EXPECT_EQ(*base::readFile(path_, 100), "not JSON");
}

}  // namespace
}  // namespace tactus::haptics
