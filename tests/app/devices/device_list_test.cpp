#include "app/devices/device_list.h"

#include <cstdlib>
#include <gtest/gtest.h>

#include "tests/core/haptics/openhaptics/loaded_stand_in.h"

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
  const DeviceList list = listOf({}, absent(), {});
  ASSERT_EQ(list.devices.size(), 1u);
  EXPECT_EQ(list.devices[0].id, "virtual");
  EXPECT_TRUE(list.devices[0].simulated);
  EXPECT_TRUE(list.devices[0].usable);
  EXPECT_EQ(list.devices[0].calibrated, true);
  EXPECT_EQ(list.notes, std::vector<std::string>{"OpenHaptics is not in use: no library; it needs the library"});
}

TEST(DeviceList, APidDeviceIsCalibratedByItsOwnSerialNumber) {
  haptics::DeviceCalibration calibration;
  calibration.device = "hid:1209:ffb0:A1";
  calibration.serial = "A1";
  const DeviceList list =
      listOf({hid(0x1209, 0xFFB0, "A1", "Board"), hid(0x1209, 0xFFB0, "B2", "Board")}, absent(), {calibration});
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
  const DeviceList list = listOf({device}, absent(), {});
  EXPECT_FALSE(list.devices[0].usable);
  EXPECT_EQ(list.devices[0].reason, "no permission to open /dev/hidraw3");
  EXPECT_EQ(list.devices[0].advice, "Install the file 60-tactus.rules");
}

TEST(DeviceList, ATouchThatOpenHapticsReachesIsOneDevice) {
  const DeviceList list = listOf({touch()}, present(), {});
  ASSERT_EQ(list.devices.size(), 2u);
  EXPECT_EQ(list.devices[0].id, "openhaptics");
  EXPECT_TRUE(list.devices[0].usable);
  EXPECT_TRUE(list.notes.empty());
}

TEST(DeviceList, ATouchWithoutOpenHapticsSaysWhatIsMissing) {
  const DeviceList list = listOf({touch()}, absent(), {});
  ASSERT_EQ(list.devices.size(), 2u);
  EXPECT_EQ(list.devices[0].backend, "openhaptics");
  EXPECT_FALSE(list.devices[0].usable);
  EXPECT_EQ(list.devices[0].reason, "no library");
  EXPECT_EQ(list.devices[0].advice, "it needs the library");
  EXPECT_FALSE(list.devices[0].calibrated);
  EXPECT_TRUE(list.notes.empty());
}

TEST(DeviceList, AnUncalibratedDeviceBehindOpenHapticsTellsWhatThePersonDoes) {
  OpenHapticsLook look = present();
  look.calibrated = false;
  look.calibration_advice = "put the stylus into the inkwell";
  const DeviceList list = listOf({}, look, {});
  EXPECT_TRUE(list.devices[0].usable);
  EXPECT_EQ(list.devices[0].calibrated, false);
  EXPECT_EQ(list.devices[0].advice, "put the stylus into the inkwell");
}

TEST(DeviceList, DevicesWithoutAWayKeepTheirReason) {
  HidDevice falcon = hid(0x0403, 0xCB48, "", "Novint Falcon");
  falcon.kind = HidDeviceKind::kKnown;
  falcon.problem = "Novint Falcon: no force feedback by HID PID";
  falcon.advice = "use another device";
  const DeviceList list = listOf({falcon}, absent(), {});
  EXPECT_EQ(list.devices[0].backend, "none");
  EXPECT_FALSE(list.devices[0].usable);
  EXPECT_FALSE(list.devices[0].calibrated);
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
            "device: found 'joystick', wanted an id that `tactus devices` lists: virtual, hid:…, openhaptics");
  EXPECT_EQ(devices::open("hid:ffff:ffff:none", {"", "/nowhere/c.json"}).error().message(),
            "hid:ffff:ffff:none: found no such device, wanted one that `tactus devices` lists");
  EXPECT_FALSE(devices::open("openhaptics:left", {TACTUS_STAND_IN, "/nowhere/c.json"}));
  EXPECT_FALSE(openRaw("hid:ffff:ffff"));
}

}  // namespace
}  // namespace tactus::devices
