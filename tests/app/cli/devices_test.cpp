// What `tactus devices` says about the virtual device and about one behind a stand-in for OpenHaptics.
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <iostream>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "app/cli/terminal.h"
#include "app/devices/device_list.h"

#include "tests/app/cli/run_program.h"
#include "tests/core/haptics/openhaptics/stand_in.h"
#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using Json = nlohmann::json;

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
Json entryOf(const Json& list, const std::string& id) {
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
  const Json list = Json::parse(out_);
  const Json entry = entryOf(list, "openhaptics");
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
  EXPECT_NE(Json::parse(out_).at("notes").dump().find("calibrations.json"), std::string::npos) << out_;
}

TEST_F(Devices, TheSelfTestOfTheVirtualOneRunsByItself) {
  ASSERT_EQ(runWith({"devices", "test", "virtual"}), 0) << err_;
  EXPECT_NE(out_.find("This device is simulated, and so is the person who holds it.\n"), std::string::npos);
  EXPECT_NE(out_.find("All checks passed, all of it simulated.\n"), std::string::npos) << out_;
}

TEST_F(Devices, ItsResultsAsJsonStandAlone) {
  ASSERT_EQ(runWith({"devices", "test", "virtual", "--json"}), 0) << err_;
  const Json result = Json::parse(out_);
  EXPECT_EQ(result.at("simulated"), true);
  EXPECT_EQ(result.at("passed"), true);
  EXPECT_EQ(result.at("checks").size(), 7u);
  EXPECT_NE(err_.find("> Move the handle"), std::string::npos);
}

TEST_F(Devices, ASelfTestThatFailsIsAnErrorWithTheAdvice) {
  useStandIn();
  stand_in_->calibration = 0x5002;
  EXPECT_EQ(runWith({"devices", "test", "openhaptics", "--json"}), 1);
  EXPECT_EQ(Json::parse(out_).at("passed"), false);
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

TEST_F(Devices, TheInsertionAxisOfADriversDeviceIsConfigurable) {
  useStandIn();
  ASSERT_EQ(runWith({"devices", "calibrate", "openhaptics", "--inwards=0,3,-4"}), 0) << err_;
  EXPECT_TRUE(out_.starts_with("openhaptics: the tube goes along 0,0.6,-0.8; stored in ")) << out_;
  EXPECT_EQ(stand_in_->open_devices, 0);
  EXPECT_EQ(stand_in_->largest_force_n, 0);
  const devices::DeviceSettings settings{TACTUS_STAND_IN, folder_.file("calibrations.json")};
  const auto opened = devices::open("openhaptics", settings);
  ASSERT_TRUE(opened) << opened.error().message();
  EXPECT_NEAR(opened->axis.inwards().y, 0.6, 1e-12);
  EXPECT_NEAR(opened->axis.inwards().z, -0.8, 1e-12);
  EXPECT_EQ(opened->axis_advice,
            "turn its insertion axis around: tactus devices calibrate openhaptics --inwards=0,-0.6,0.8");
}

TEST_F(Devices, AnAxisThatIsNoneIsRefused) {
  useStandIn();
  EXPECT_EQ(runWith({"devices", "calibrate", "openhaptics", "--inwards=0,0,0"}), 1);
  EXPECT_NE(err_.find("direction of the insertion axis: found (0, 0, 0), wanted finite numbers that are not all 0"),
            std::string::npos)
      << err_;
  for (const char* text :
       {"--inwards=0,0", "--inwards=0,0,1,0", "--inwards=x,0,1", "--inwards=0,,1", "--inwards=0,0,1,"})
    EXPECT_EQ(runWith({"devices", "calibrate", "openhaptics", text}), 1) << text;
  EXPECT_NE(err_.find("wanted three numbers such as 0,0,-1"), std::string::npos) << err_;
  EXPECT_EQ(runWith({"devices", "calibrate", "hid:1209:ffb0", "--inwards=0,0,1"}), 1);
  EXPECT_NE(err_.find("wanted a calibration, which measures the axis too"), std::string::npos) << err_;
  EXPECT_EQ(runWith({"devices", "calibrate", "virtual", "--inwards=0,0,1"}), 1);
}

/// Raises a signal when a text appears, as a person who presses Ctrl-C there.
class Interrupting final : public std::stringbuf {
 public:
  explicit Interrupting(std::string at) : at_(std::move(at)) {}

 protected:
  int sync() override {
    if (!raised_ && unwrapped(str()).find(at_) != std::string::npos) {
      raised_ = true;
      std::raise(SIGINT);
    }
    return 0;
  }

 private:
  std::string at_;
  bool raised_ = false;
};

TEST_F(Devices, CtrlCStopsTheDeviceInOrderAndEndsWithOneSentence) {
  useStandIn();
  for (const std::string command : {"test", "calibrate"}) {
    if (command == "calibrate") {
      stand_in_->calibration = 0x5001;
      stand_in_->calibration_styles = 1;
    }
    Interrupting buffer(command == "test" ? "Move the handle" : "press Enter");
    std::ostream out(&buffer);
    std::istringstream in;
    std::ostringstream err;
    EXPECT_EQ(run({"devices", command, "openhaptics"}, in, out, err), 1);
    const std::string said = err.str();
    EXPECT_TRUE(said.starts_with("tactus: openhaptics: found an interruption, and the device was stopped, wanted "))
        << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_EQ(stand_in_->open_devices, 0);
    EXPECT_FALSE(stand_in_->running);
    EXPECT_FALSE(stand_in_->force_output);
    EXPECT_EQ(stand_in_->force_n[2], 0);
  }
}

TEST(InterruptSignals, TheFirstIsAFlagTheSecondEndsTheProgram) {
  {
    const InterruptSignals signals;
    EXPECT_FALSE(signals.raised());
    std::raise(SIGTERM);
    EXPECT_TRUE(signals.raised());
  }
  EXPECT_FALSE(InterruptSignals().raised()) << "a new one begins anew";
  EXPECT_EXIT(
      {
        const InterruptSignals signals;
        std::raise(SIGINT);
        std::raise(SIGINT);
        std::_Exit(0);
      },
      testing::KilledBySignal(SIGINT), "");
}

TEST(TypedLines, AKeyboardOnWhichNobodyTypesHoldsNothingUp) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const int kept = dup(STDIN_FILENO);
  dup2(ends[0], STDIN_FILENO);
  TypedLines lines(std::cin);
  EXPECT_EQ(lines.next(), std::nullopt);
  EXPECT_FALSE(lines.ended());
  ASSERT_EQ(write(ends[1], "one\ntwo\nthr", 11), 11);
  EXPECT_EQ(lines.next(), "one");
  EXPECT_EQ(lines.next(), "two");
  EXPECT_EQ(lines.next(), std::nullopt);
  ASSERT_EQ(write(ends[1], "ee", 2), 2);
  close(ends[1]);
  EXPECT_EQ(lines.next(), "three");
  EXPECT_EQ(lines.next(), std::nullopt);
  EXPECT_TRUE(lines.ended());
  dup2(kept, STDIN_FILENO);
  close(kept);
  close(ends[0]);
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
