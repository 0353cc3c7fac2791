#include "app/devices/device_list.h"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>

#include "tests/core/haptics/openhaptics/loaded_stand_in.h"
#include "tests/support/temp_folder.h"

namespace tactus::devices {
namespace {

using haptics::HidDevice;
using haptics::HidDeviceKind;

/// The stand-in is untouched.
class LookAtOpenHaptics : public haptics::WithStandIn {};
class OpenDevice : public haptics::WithStandIn {};

HidDevice hid(std::uint16_t vendor, std::uint16_t product, const std::string& serial, const std::string& name) {
  HidDevice device;
  device.path = "/dev/hidraw3";
  device.vendor = vendor;
  device.product = product;
  device.identity = {haptics::hidDeviceId(vendor, product, serial), name, serial};
  device.kind = HidDeviceKind::kPid;
  return device;
}

HidDevice touch() {
  HidDevice device = hid(0x2988, 0x0304, "", "Touch");
  device.kind = HidDeviceKind::kKnown;
  device.problem = "3D Systems Touch (HID): no force feedback by HID PID";
  device.advice = "install OpenHaptics";
  return device;
}

OpenHapticsLook absent() {
  OpenHapticsLook look;
  look.reason = "no library";
  look.advice = "it needs the library";
  return look;
}

HaplyLook noService() { return base::fail(base::ErrorCode::kIo, "localhost:10001", "nothing", "the service"); }

OpenHapticsLook present() {
  OpenHapticsLook look;
  look.info = haptics::DeviceInfo{};
  look.info->id = "openhaptics";
  look.info->name = "Touch";
  look.info->backend = "openhaptics";
  look.calibrated = true;
  return look;
}

TEST(DeviceList, TheVirtualDeviceIsAlwaysThereAndSaysThatItIsSimulated) {
  const DeviceList list = listOf({}, absent(), noService(), {});
  ASSERT_EQ(list.devices.size(), 1u);
  EXPECT_EQ(list.devices[0].id, "virtual");
  EXPECT_TRUE(list.devices[0].simulated);
  EXPECT_TRUE(list.devices[0].usable);
  EXPECT_EQ(list.devices[0].calibrated, true);
  EXPECT_EQ(list.notes,
            (std::vector<std::string>{"OpenHaptics is not in use: no library; it needs the library",
                                      "Haply is not in use: localhost:10001: found nothing, wanted the service"}));
}

TEST(DeviceList, APidDeviceIsCalibratedByItsOwnSerialNumber) {
  haptics::DeviceCalibration calibration;
  calibration.device = "hid:1209:ffb0:A1";
  calibration.serial = "A1";
  const DeviceList list = listOf({hid(0x1209, 0xFFB0, "A1", "Board"), hid(0x1209, 0xFFB0, "B2", "Board")}, absent(),
                                 noService(), {calibration});
  ASSERT_EQ(list.devices.size(), 3u);
  EXPECT_EQ(list.devices[0].id, "hid:1209:ffb0:A1");
  EXPECT_EQ(list.devices[0].backend, "hid-pid");
  EXPECT_TRUE(list.devices[0].usable);
  EXPECT_EQ(list.devices[0].calibrated, true);
  EXPECT_EQ(list.devices[0].advice, "");
  EXPECT_EQ(list.devices[1].calibrated, false);
  EXPECT_EQ(list.devices[1].advice, "calibrate it: tactus devices calibrate hid:1209:ffb0:B2");
}

TEST(DeviceList, WithoutPermissionTheReasonAndTheRuleAreGiven) {
  HidDevice device = hid(0x1209, 0xFFB0, "", "Board");
  device.problem = "no permission to open /dev/hidraw3";
  device.advice = "Install the file 60-tactus.rules";
  const DeviceList list = listOf({device}, absent(), noService(), {});
  EXPECT_FALSE(list.devices[0].usable);
  EXPECT_EQ(list.devices[0].reason, "no permission to open /dev/hidraw3");
  EXPECT_EQ(list.devices[0].advice, "Install the file 60-tactus.rules");
}

TEST(DeviceList, ATouchThatOpenHapticsReachesIsOneDevice) {
  const DeviceList list = listOf({touch()}, present(), noService(), {});
  ASSERT_EQ(list.devices.size(), 2u);
  EXPECT_EQ(list.devices[0].id, "openhaptics");
  EXPECT_TRUE(list.devices[0].usable);
  EXPECT_EQ(list.notes.size(), 1u) << "about Haply alone";
}

TEST(DeviceList, ATouchWithoutOpenHapticsSaysWhatIsMissing) {
  const DeviceList list = listOf({touch()}, absent(), noService(), {});
  ASSERT_EQ(list.devices.size(), 2u);
  EXPECT_EQ(list.devices[0].backend, "openhaptics");
  EXPECT_FALSE(list.devices[0].usable);
  EXPECT_EQ(list.devices[0].reason, "no library");
  EXPECT_EQ(list.devices[0].advice, "it needs the library");
  EXPECT_FALSE(list.devices[0].calibrated);
  EXPECT_EQ(list.notes.size(), 1u) << "about Haply alone";
}

TEST(DeviceList, AnUncalibratedDeviceBehindOpenHapticsTellsWhatThePersonDoes) {
  OpenHapticsLook look = present();
  look.calibrated = false;
  look.calibration_advice = "put the stylus into the inkwell";
  const DeviceList list = listOf({}, look, noService(), {});
  EXPECT_TRUE(list.devices[0].usable);
  EXPECT_EQ(list.devices[0].calibrated, false);
  EXPECT_EQ(list.devices[0].advice, "put the stylus into the inkwell");
}

TEST(DeviceList, DevicesWithoutAWayKeepTheirReason) {
  HidDevice falcon = hid(0x0403, 0xCB48, "", "Novint Falcon");
  falcon.kind = HidDeviceKind::kKnown;
  falcon.problem = "Novint Falcon: no force feedback by HID PID";
  falcon.advice = "use another device";
  const DeviceList list = listOf({falcon}, absent(), noService(), {});
  EXPECT_EQ(list.devices[0].backend, "none");
  EXPECT_FALSE(list.devices[0].usable);
  EXPECT_FALSE(list.devices[0].calibrated);
}

haptics::HaplyFound haply(const std::string& serial, bool simulated) {
  haptics::HaplyFound found;
  found.info.id = (simulated ? "simulated-haply:" : "haply:") + serial;
  found.info.name = "Haply Inverse3";
  found.info.serial = serial;
  found.info.backend = "haply";
  found.info.simulated = simulated;
  found.info.buttons = 3;
  found.info.delay_s = 0.0015;
  found.round_trip_s = 0.0004;
  return found;
}

TEST(DeviceList, AHaplyHasItsMeasuredRoundTripAndTheStiffnessThatFollows) {
  const DeviceList list = listOf({}, absent(), std::vector{haply("049D", false)}, {});
  ASSERT_EQ(list.devices.size(), 2u);
  EXPECT_EQ(list.devices[0].id, "haply:049D");
  EXPECT_EQ(list.devices[0].backend, "haply");
  EXPECT_TRUE(list.devices[0].usable);
  EXPECT_FALSE(list.devices[0].simulated);
  EXPECT_EQ(list.devices[0].advice, "");
  EXPECT_EQ(list.devices[0].round_trip_s, 0.0004);
  // Half of 1.7 N s/m / (0.5 ms + 1.5 ms).
  EXPECT_NEAR(list.devices[0].largest_stiffness_n_mm.value_or(0), 0.425, 1e-12);
  EXPECT_EQ(list.notes.size(), 1u) << "about OpenHaptics";
  EXPECT_FALSE(list.devices[1].round_trip_s);
}

TEST(DeviceList, OfSeveralHaplyDevicesTheFirstIsNamed) {
  haptics::HaplyFound late = haply("SIM-2", true);
  late.problem = "it replies in 31 ms, too late for a force";
  late.info.buttons = 0;
  haptics::HaplyFound bare = haply("SIM-1", true);
  bare.info.buttons = 0;
  const DeviceList list = listOf({}, present(), std::vector{bare, late}, {});
  EXPECT_EQ(list.devices[1].id, "simulated-haply:SIM-1");
  EXPECT_TRUE(list.devices[1].simulated);
  EXPECT_EQ(list.devices[1].advice, "switch its grip on, or hold the tube with a key or a pedal");
  EXPECT_FALSE(list.devices[2].usable);
  EXPECT_EQ(list.devices[2].reason, late.problem);
  EXPECT_EQ(list.notes,
            std::vector<std::string>{"Of 2 Haply devices, `haply` alone means the first: simulated-haply:SIM-1"});
}

TEST(DeviceList, AServiceWithoutADeviceIsANote) {
  const DeviceList list = listOf({}, present(), HaplyLook(), {});
  EXPECT_EQ(list.notes,
            std::vector<std::string>{"Haply is not in use: its service has no device; connect the Inverse3"});
}

class OpenHaply : public testing::Test {
 protected:
  void SetUp() override {
    haptics::HaplyEmulatorSettings emulated;
    emulated.port = 0;
    emulated.devices = 2;
    auto started = haptics::HaplyEmulator::start(emulated);
    ASSERT_TRUE(started.has_value());
    service_ = *std::move(started);
    settings_.haply_port = service_->port();
    settings_.hd_library = "/nowhere/libHD.so";
    settings_.calibrations = folder_.file("calibrations.json");
  }

  std::unique_ptr<haptics::HaplyEmulator> service_;
  DeviceSettings settings_;
  support::TempFolder folder_;
};

TEST_F(OpenHaply, ByItsIdOrTheFirst) {
  EXPECT_EQ(open("haply", settings_)->device->info().id, "simulated-haply:SIM-1");
  const auto second = open("simulated-haply:SIM-2", settings_);
  ASSERT_TRUE(second.has_value()) << second.error().message();
  EXPECT_EQ(second->device->info().id, "simulated-haply:SIM-2");
  // The middle of the workspace is 0.12 m in front of the base and 0.15 m up.
  EXPECT_EQ(second->axis.originMm(), (haptics::Vector3{0, 150, 120}));
  EXPECT_EQ(second->axis.inwards(), (haptics::Vector3{0, 0, -1}));
  EXPECT_FALSE(open("haply:SIM-1", settings_).has_value());
  settings_.haply_port = 0;
  EXPECT_FALSE(open("haply", settings_).has_value());
}

TEST_F(OpenHaply, AlongAStoredAxis) {
  ASSERT_TRUE(haptics::storeAxis(settings_.calibrations, {"simulated-haply:SIM-1", "SIM-1", {0, -1, 0}}));
  const auto device = open("haply", settings_);
  ASSERT_TRUE(device.has_value()) << device.error().message();
  EXPECT_EQ(device->axis.inwards(), (haptics::Vector3{0, -1, 0}));
  EXPECT_EQ(device->axis.originMm(), (haptics::Vector3{0, 150, 120}));
  EXPECT_EQ(device->axis_advice,
            "turn its insertion axis around: tactus devices calibrate simulated-haply:SIM-1 --inwards=0,1,0");
}

TEST_F(OpenHaply, IsListedWithTheOthers) {
  const DeviceList list = listDevices(settings_);
  const auto found = std::find_if(list.devices.begin(), list.devices.end(),
                                  [](const ListedDevice& d) { return d.id == "simulated-haply:SIM-2"; });
  ASSERT_NE(found, list.devices.end());
  EXPECT_TRUE(found->usable && found->simulated);
  EXPECT_GT(found->round_trip_s.value_or(0), 0);
}

TEST_F(LookAtOpenHaptics, WithoutTheLibraryItSaysWhatIsMissing) {
  const OpenHapticsLook look = lookAtOpenHaptics("/nowhere/libHD.so");
  EXPECT_FALSE(look.info);
  EXPECT_TRUE(look.reason.starts_with("OpenHaptics library: none that loads, tried /nowhere/libHD.so")) << look.reason;
  EXPECT_TRUE(look.advice.starts_with("it needs the OpenHaptics 3.4 runtime")) << look.advice;
}

TEST_F(LookAtOpenHaptics, OpensTheDeviceAndGivesItBack) {
  for (int again = 0; again < 2; ++again) {
    const OpenHapticsLook look = lookAtOpenHaptics(TACTUS_STAND_IN);
    ASSERT_TRUE(look.info) << look.reason;
    EXPECT_EQ(look.info->serial, "S-0042");
    EXPECT_TRUE(look.calibrated);
  }
}

TEST(SettingsOfProcess, TheEnvironmentSaysWhereTheLibraryAndTheCalibrationsAre) {
  setenv("TACTUS_LIBHD", "/opt/libHD.so", 1);
  setenv("TACTUS_CALIBRATIONS", "/data/c.json", 1);
  EXPECT_EQ(settingsOfProcess().hd_library, "/opt/libHD.so");
  EXPECT_EQ(settingsOfProcess().calibrations, "/data/c.json");
  unsetenv("TACTUS_LIBHD");
  unsetenv("TACTUS_CALIBRATIONS");
  setenv("XDG_CONFIG_HOME", "/home/n/.conf", 1);
  EXPECT_EQ(settingsOfProcess().hd_library, "");
  EXPECT_EQ(settingsOfProcess().calibrations, "/home/n/.conf/tactus/calibrations.json");
  unsetenv("XDG_CONFIG_HOME");
  setenv("HOME", "/home/n", 1);
  EXPECT_EQ(settingsOfProcess().calibrations, "/home/n/.config/tactus/calibrations.json");
}

TEST_F(OpenDevice, OpensTheVirtualOne) {
  const auto opened = devices::open("virtual", {});
  ASSERT_TRUE(opened);
  EXPECT_TRUE(opened->device->info().simulated);
}

TEST_F(OpenDevice, OpensTheOneBehindOpenHaptics) {
  const auto opened = devices::open("openhaptics", {TACTUS_STAND_IN, "/nowhere/c.json"});
  ASSERT_TRUE(opened) << opened.error().message();
  EXPECT_EQ(opened->device->info().name, "Stand-in (simulated)");
  EXPECT_FALSE(opened->calibration_advice.empty());
  EXPECT_EQ(opened->axis.inwards(), (haptics::Vector3{0, 0, -1}));
  EXPECT_EQ(opened->axis_advice,
            "turn its insertion axis around: tactus devices calibrate openhaptics --inwards=0,0,1");
}

TEST_F(OpenDevice, RefusesWhatIsNotThere) {
  EXPECT_EQ(devices::open("joystick", {}).error().message(),
            "device: found 'joystick', wanted an id that `tactus devices` lists: virtual, hid:…, openhaptics, haply:…");
  EXPECT_EQ(devices::open("hid:ffff:ffff:none", {"", "/nowhere/c.json"}).error().message(),
            "hid:ffff:ffff:none: found no such device, wanted one that `tactus devices` lists");
  EXPECT_FALSE(devices::open("openhaptics:left", {TACTUS_STAND_IN, "/nowhere/c.json"}));
  EXPECT_FALSE(openRaw("hid:ffff:ffff"));
}

}  // namespace
}  // namespace tactus::devices
