// What `tactus devices` says about the virtual device and about one behind a stand-in for OpenHaptics.
#include <cstdlib>
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/cli/run_program.h"
#include "tests/core/haptics/openhaptics/stand_in.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using nlohmann::json;

class Devices : public testing::Test {
 protected:
  void SetUp() override {
    setenv("TACTUS_LIBHD", "/nowhere/libHD.so", 1);
    setenv("TACTUS_CALIBRATIONS", folder_.file("calibrations.json").c_str(), 1);
    void* const library = dlopen(TACTUS_STAND_IN, RTLD_NOW | RTLD_GLOBAL);
    ASSERT_NE(library, nullptr);
    reinterpret_cast<haptics::stand_in::Reset>(dlsym(library, "standInReset"))();
    stand_in_ = reinterpret_cast<haptics::stand_in::GetState>(dlsym(library, "standInState"))();
    stand_in_->threaded = true;
  }
  void TearDown() override {
    unsetenv("TACTUS_LIBHD");
    unsetenv("TACTUS_CALIBRATIONS");
  }
  static void useStandIn() { setenv("TACTUS_LIBHD", TACTUS_STAND_IN, 1); }

  int runWith(const std::vector<std::string>& arguments, const std::string& typed = {}) {
    std::istringstream in(typed);
    std::ostringstream out;
    std::ostringstream err;
    const int status = run(arguments, in, out, err);
    out_ = out.str();
    err_ = err.str();
    return status;
  }

  support::TempFolder folder_;
  haptics::stand_in::State* stand_in_ = nullptr;
  std::string out_, err_;
};

/// The entry of the device with this id; null where there is none.
json entryOf(const json& list, const std::string& id) {
  for (const auto& device : list.at("devices")) {
    if (device.at("id") == id) return device;
  }
  return nullptr;
}

TEST_F(Devices, TheVirtualOneIsListedAndMarked) {
  ASSERT_EQ(runWith({"devices"}), 0) << err_;
  EXPECT_NE(out_.find("virtual: Virtual device (simulated), ready (simulated)\n"), std::string::npos) << out_;
  EXPECT_NE(unwrapped(out_).find("tried /nowhere/libHD.so"), std::string::npos) << out_;
}

TEST_F(Devices, TheListAsJsonHasWhatAProgramNeeds) {
  useStandIn();
  stand_in_->calibration = 0x5002;
  ASSERT_EQ(runWith({"devices", "--json"}), 0) << err_;
  const json list = json::parse(out_);
  const json entry = entryOf(list, "openhaptics");
  ASSERT_TRUE(entry.is_object()) << out_;
  EXPECT_EQ(entry.at("name"), "Stand-in (simulated)");
  EXPECT_EQ(entry.at("serial"), "S-0042");
  EXPECT_EQ(entry.at("backend"), "openhaptics");
  EXPECT_EQ(entry.at("usable"), true);
  EXPECT_EQ(entry.at("calibrated"), false);
  EXPECT_EQ(entry.at("advice"), "put the stylus into the inkwell and leave it there for a second");
  EXPECT_EQ(entryOf(list, "virtual").at("simulated"), true);
}

TEST_F(Devices, ADamagedFileOfCalibrationsIsANote) {
  writeText(folder_.file("calibrations.json"), "{");
  ASSERT_EQ(runWith({"devices", "--json"}), 0) << err_;
  EXPECT_NE(json::parse(out_).at("notes").dump().find("calibrations.json"), std::string::npos) << out_;
}

TEST_F(Devices, TheSelfTestOfTheVirtualOneRunsByItself) {
  ASSERT_EQ(runWith({"devices", "test", "virtual"}), 0) << err_;
  EXPECT_NE(out_.find("This device is simulated, and so is the person who holds it.\n"), std::string::npos);
  EXPECT_NE(out_.find("All checks passed, all of it simulated.\n"), std::string::npos) << out_;
}

TEST_F(Devices, ItsResultsAsJsonStandAlone) {
  ASSERT_EQ(runWith({"devices", "test", "virtual", "--json"}), 0) << err_;
  const json result = json::parse(out_);
  EXPECT_EQ(result.at("simulated"), true);
  EXPECT_EQ(result.at("passed"), true);
  EXPECT_EQ(result.at("checks").size(), 7u);
  EXPECT_NE(err_.find("> Move the handle"), std::string::npos);
}

TEST_F(Devices, ASelfTestThatFailsIsAnErrorWithTheAdvice) {
  useStandIn();
  stand_in_->calibration = 0x5002;
  EXPECT_EQ(runWith({"devices", "test", "openhaptics", "--json"}), 1);
  EXPECT_EQ(json::parse(out_).at("passed"), false);
  EXPECT_NE(
      err_.find("tactus: openhaptics: calibrated: found the device is not calibrated, wanted a check that passes: "
                "put the stylus into the inkwell"),
      std::string::npos)
      << err_;
  EXPECT_EQ(stand_in_->open_devices, 0);
  EXPECT_EQ(stand_in_->largest_force_n, 0);
}

TEST_F(Devices, WithoutAnIdTheHardwareIsTested) {
  useStandIn();
  stand_in_->calibration = 0x5002;
  EXPECT_EQ(runWith({"devices", "test"}), 1);
  EXPECT_TRUE(out_.starts_with("Self-test of openhaptics: Stand-in (simulated)\n")) << out_;
}

TEST_F(Devices, ADriverCalibratesItsDeviceWhenThePersonSaysSo) {
  useStandIn();
  stand_in_->calibration = 0x5001;
  stand_in_->calibration_styles = 1;  // encoder reset: waits for a person
  ASSERT_EQ(runWith({"devices", "calibrate", "openhaptics"}, "\n"), 0) << err_;
  EXPECT_EQ(stand_in_->calibration_updates.size(), 1u);
  EXPECT_NE(out_.find("hold the stylus in the reference posture"), std::string::npos) << out_;
  EXPECT_NE(out_.find("openhaptics: calibrated by its driver\n"), std::string::npos) << out_;
}

TEST_F(Devices, WhoStopsACalibrationGetsNone) {
  useStandIn();
  stand_in_->calibration = 0x5002;
  stand_in_->calibration_after_update = 0x5002;
  EXPECT_EQ(runWith({"devices", "calibrate", "openhaptics"}, "stop\n"), 1);
  EXPECT_NE(err_.find("tactus: openhaptics: found no calibration"), std::string::npos) << err_;
  EXPECT_EQ(runWith({"devices", "calibrate", "virtual"}), 1);
  EXPECT_NE(err_.find("virtual: found a device without a calibration"), std::string::npos) << err_;
}

TEST_F(Devices, DevicesThatAreNotThereAreWrongInput) {
  EXPECT_EQ(runWith({"devices", "test", "hid:ffff:ffff:none"}), 1);
  EXPECT_NE(err_.find("no such device"), std::string::npos) << err_;
  EXPECT_EQ(runWith({"devices", "test", "joystick"}), 1);
  EXPECT_EQ(runWith({"devices", "calibrate", "hid:ffff:ffff:none"}), 1);
}

TEST_F(Devices, WrongUsageIsSaidSo) {
  EXPECT_EQ(runWith({"devices", "calibrate"}), 2);
  EXPECT_EQ(runWith({"devices", "shake"}), 2);
  EXPECT_EQ(runWith({"devices", "calibrate", "hid:1:2", "--method", "guess"}), 2);
}

}  // namespace
}  // namespace tactus::cli
