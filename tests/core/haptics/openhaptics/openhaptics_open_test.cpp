#include <cstdlib>
#include <limits>

#include "tests/core/haptics/openhaptics/loaded_stand_in.h"

namespace tactus::haptics {
namespace {

class OpenHapticsOpen : public WithStandIn {
 protected:
  std::string refusal(const std::string& name = {}) {
    OpenHapticsSettings chosen = settings();
    chosen.name = name;
    const auto device = OpenHapticsDevice::open(library_, std::move(chosen));
    EXPECT_FALSE(device);
    return device ? "" : device.error().message();
  }
};

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(OpenHapticsOpen, ReadsWhatTheDeviceIs) {
  const auto device = open();
  ASSERT_TRUE(device);
  const DeviceInfo& info = device->info();
  EXPECT_EQ(info.id, "openhaptics");
  EXPECT_EQ(info.name, "Stand-in (simulated)");
  EXPECT_EQ(info.serial, "S-0042");
  EXPECT_EQ(info.backend, "openhaptics");
  EXPECT_FALSE(info.simulated);
  EXPECT_EQ(info.position_axes, 3);
  EXPECT_EQ(info.force_axes, 3);
  EXPECT_EQ(info.max_force_n, 3.3);
  EXPECT_EQ(info.continuous_force_n, 0.88);
  EXPECT_EQ(info.max_stiffness_n_mm, 0.5);
  EXPECT_FALSE(info.count_mm);
  EXPECT_FALSE(info.quiet_after_s);
  EXPECT_EQ(standIn().calls, std::vector<std::string>{"init "});
}

TEST_F(OpenHapticsOpen, SaysWhetherItIsCalibratedAndChangesNothing) {
  EXPECT_TRUE(open()->calibrated());
  standIn().calibration = hd::kNeedsUpdate;
  EXPECT_FALSE(open()->calibrated());
  EXPECT_TRUE(standIn().calibration_updates.empty());
}

TEST_F(OpenHapticsOpen, TriesTheNamesThatSomeInstallationsNeed) {
  standIn().accepted_names = {"Default PHANToM"};
  ASSERT_TRUE(open());
  const std::vector<std::string> tried = {"init ", "init Default Device", "init Default PHANToM", "disable device"};
  EXPECT_EQ(standIn().calls, tried);
}

TEST_F(OpenHapticsOpen, ANameThatWasChosenIsTheOnlyOne) {
  standIn().accepted_names = {"", "left"};
  OpenHapticsSettings chosen = settings();
  chosen.name = "left";
  const auto device = open(std::move(chosen));
  ASSERT_TRUE(device);
  EXPECT_EQ(device->info().id, "openhaptics:left");
  EXPECT_EQ(standIn().calls, std::vector<std::string>{"init left"});
  standIn().open_devices = 0;
  const std::string message = refusal("right");
  EXPECT_TRUE(message.starts_with("openhaptics:right: found the device does not answer (0x0302, internal 11, "))
      << message;
  EXPECT_FALSE(contains(message, "also by the names"));
  standIn().open_devices = 1;
}

TEST_F(OpenHapticsOpen, NoDeviceSaysTheReasonOfTheDefaultNameAndWhatToDo) {
  setenv("GTDD_HOME", "/nowhere", 1);
  standIn().accepted_names = {};
  const std::string message = refusal();
  unsetenv("GTDD_HOME");
  for (const char* part :
       {"openhaptics: found the device does not answer (0x0302", "Default Device and Default PHANToM", "plugged in",
        "Touch Setup", "open in no other program", "GTDD_HOME"})
    EXPECT_TRUE(contains(message, part)) << part << ": " << message;
  EXPECT_EQ(standIn().open_devices, 0);
}

TEST_F(OpenHapticsOpen, ADeviceThatIsOpenElsewhereIsNotTriedByOtherNames) {
  standIn().taken_elsewhere = true;
  const std::string message = refusal();
  EXPECT_TRUE(contains(message, "the device is open already (0x0301")) << message;
  EXPECT_TRUE(contains(message, "a device that no other program has open (Touch Setup, Touch Diagnostics")) << message;
  EXPECT_EQ(standIn().calls, std::vector<std::string>{"init "});
}

TEST_F(OpenHapticsOpen, ThisProcessOpensItOnce) {
  const auto device = open();
  ASSERT_TRUE(device);
  EXPECT_TRUE(contains(refusal(), "the device is open already"));
  EXPECT_EQ(standIn().open_devices, 1);
}

TEST_F(OpenHapticsOpen, AHandleThatComesWithAnErrorIsGivenBack) {
  standIn().gives_handle_with_error = true;
  standIn().init_error = 0x0300;
  EXPECT_TRUE(contains(refusal(), "the device reports a fault (0x0300"));
  EXPECT_EQ(standIn().open_devices, 0);
}

TEST_F(OpenHapticsOpen, WarmMotorsAreNoReasonToRefuse) {
  standIn().gives_handle_with_error = true;
  standIn().init_error = 0x0200;
  EXPECT_TRUE(open());
}

TEST_F(OpenHapticsOpen, AnInvalidLicenseIsNamed) {
  standIn().accepted_names = {};
  standIn().init_error = 0x0600;
  EXPECT_TRUE(contains(refusal(), "wanted a valid OpenHaptics license"));
}

TEST_F(OpenHapticsOpen, WithoutALargestForceThereIsNothingToLimitBy) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double force_n : {0.0, -1.0, 51.0, nan}) {
    standIn().max_force_n = force_n;
    EXPECT_TRUE(contains(refusal(), "openhaptics: largest force: found ")) << force_n;
    EXPECT_EQ(standIn().open_devices, 0);
  }
}

TEST_F(OpenHapticsOpen, LimitsThatMakeNoSenseAreLeftOut) {
  standIn().continuous_force_n = 4;  // above the largest
  standIn().stiffness_n_mm = 400;    // N/m, a wrong unit
  const auto device = open();
  ASSERT_TRUE(device);
  EXPECT_FALSE(device->info().continuous_force_n);
  EXPECT_FALSE(device->info().max_stiffness_n_mm);
}

}  // namespace
}  // namespace tactus::haptics
