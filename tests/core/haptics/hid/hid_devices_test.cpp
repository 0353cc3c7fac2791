#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

#include "core/haptics/hid/hid_pid_device.h"
#include "core/haptics/hid/hidapi_transport.h"

#include "tests/support/fake_pid_device.h"
#include "tests/support/hid_descriptor_builder.h"
#include "tests/support/temp_folder.h"

namespace tactus::haptics {
namespace {

using Bytes = std::vector<std::uint8_t>;

HidDevice deviceOf(std::uint16_t vendor, std::uint16_t product) {
  HidDevice device;
  device.path = "/dev/hidraw9";
  device.vendor = vendor;
  device.product = product;
  return device;
}

Bytes plainDevice(std::uint32_t usage) {
  support::HidDescriptorBuilder b;
  b.page(1).usage(usage).application().usages({0x30, 0x31}).logical(-127, 127).size(8).count(2).input(2);
  return b.end().take();
}

TEST(HidDevices, PidIsRecognizedByTheDescriptorWhateverTheIdsAre) {
  for (const auto model : support::kPidModels) {
    HidDevice device = deviceOf(0x1234, 0x5678);
    judge(device, support::reportDescriptor(model), true);
    EXPECT_EQ(device.kind, HidDeviceKind::kPid);
    EXPECT_EQ(device.problem, "");
  }
  HidDevice logitech = deviceOf(0x046D, 0xC24F);
  judge(logitech, support::reportDescriptor(support::PidModel::kBoard), true);
  EXPECT_EQ(logitech.kind, HidDeviceKind::kPid) << "the descriptor decides";
}

TEST(HidDevices, WithoutPermissionTheRuleFileIsNamed) {
  HidDevice device = deviceOf(0x1209, 0xFFB0);
  judge(device, support::reportDescriptor(support::PidModel::kBoard), false);
  EXPECT_EQ(device.kind, HidDeviceKind::kPid);
  EXPECT_EQ(device.problem, "no permission to open /dev/hidraw9");
  EXPECT_NE(device.advice.find("60-tactus.rules"), std::string::npos);
}

TEST(HidDevices, OtherHapticDevicesAreNamedWithWhatToDo) {
  HidDevice touch = deviceOf(0x2988, 0x0304);
  judge(touch, plainDevice(4), true);
  EXPECT_EQ(touch.kind, HidDeviceKind::kKnown);
  EXPECT_EQ(touch.problem, "3D Systems Touch (HID): no force feedback by HID PID");
  EXPECT_NE(touch.advice.find("OpenHaptics"), std::string::npos);
  HidDevice wheel = deviceOf(0x046D, 0xC24F);
  judge(wheel, plainDevice(4), true);
  EXPECT_EQ(wheel.kind, HidDeviceKind::kKnown);
  HidDevice mouse = deviceOf(0x046D, 0xC077);
  judge(mouse, plainDevice(2), true);
  EXPECT_EQ(mouse.kind, HidDeviceKind::kOther) << "of the same maker";
  HidDevice unread = deviceOf(0x1209, 0xFFB0);
  judge(unread, base::fail(base::ErrorCode::kIo, "", "nothing", "something"), true);
  EXPECT_EQ(unread.kind, HidDeviceKind::kOther);
}

TEST(HidDevices, IdsAreWrittenAsOnTheCommandLine) {
  EXPECT_EQ(hidDeviceId(0x1209, 0xFFB0, "1234"), "hid:1209:ffb0:1234");
  EXPECT_EQ(hidDeviceId(0x45E, 0x1B, ""), "hid:045e:001b");
}

TEST(HidDevices, DevicesThatAreNoHidDevicesAreFoundOnUsb) {
  const support::TempFolder folder;
  const auto add = [&](const std::string& name, const std::string& vendor, const std::string& product) {
    std::filesystem::create_directory(folder.file(name));
    std::ofstream(folder.file(name + "/idVendor")) << vendor << "\n";
    std::ofstream(folder.file(name + "/idProduct")) << product << "\n";
  };
  add("1-1", "0403", "cb48");
  add("1-2", "0403", "6001");  // any other serial chip of that maker
  add("1-3", "1451", "0402");
  add("1-4", "046d", "c077");
  std::filesystem::create_directory(folder.file("1-4:1.0"));
  const auto devices = knownUsbDevices(folder.file(""));
  ASSERT_EQ(devices.size(), 2U);
  EXPECT_EQ(devices[0].identity.id, "usb:0403:cb48");
  EXPECT_EQ(devices[0].identity.name, "Novint Falcon");
  EXPECT_EQ(devices[1].identity.name, "Force Dimension device");
  EXPECT_TRUE(knownUsbDevices(folder.file("nothing")).empty());
}

TEST(HidDevices, TheDescriptorOfANodeIsReadWithoutOpeningIt) {
  const support::TempFolder folder;
  std::filesystem::create_directories(folder.file("hidraw3/device"));
  std::ofstream(folder.file("hidraw3/device/report_descriptor"), std::ios::binary) << "\x05\x01";
  EXPECT_EQ(descriptorOfNode("/dev/hidraw3", folder.file("")), (Bytes{5, 1}));
  EXPECT_FALSE(descriptorOfNode("/dev/hidraw4", folder.file("")));
}

TEST(HidDevices, ListingWorksWhereThereIsNoDevice) {
  for (const HidDevice& device : listHidDevices()) {
    EXPECT_NE(device.kind, HidDeviceKind::kOther);
    EXPECT_FALSE(device.identity.id.empty());
  }
}

TEST(HidapiTransport, ANodeThatIsNotThereIsRefused) {
  const auto opened = HidapiTransport::open("/dev/hidraw-none");
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().file, "/dev/hidraw-none");
}

TEST(HidDevices, ANameWithAnUmlautIsReadFromTheKernel) {
  namespace fs = std::filesystem;
  const support::TempFolder folder;
  // As in /sys: the node links to the HID device, which lies two folders below the USB device.
  const fs::path usb = folder.file("devices/usb1/1-1");
  const fs::path hid = usb / "1-1:1.0" / "0003:1209:FFB0.0001";
  fs::create_directories(hid);
  fs::create_directories(folder.file("class/hidraw3"));
  fs::create_directory_symlink(hid, folder.file("class/hidraw3/device"));
  const std::string system = folder.file("class");
  EXPECT_EQ(nameOfNode("/dev/hidraw3", system), "");
  std::ofstream(hid / "uevent")
      << "DRIVER=hid-generic\nHID_ID=0003:00001209:0000FFB0\nHID_NAME=M\xC3\xBCller Kraftger\xC3\xA4t\n"
      << "HID_PHYS=\nHID_UNIQ=N\xC3\xB6-7\n";
  EXPECT_EQ(nameOfNode("/dev/hidraw3", system), "M\xC3\xBCller Kraftger\xC3\xA4t");
  EXPECT_EQ(serialOfNode("/dev/hidraw3", system), "N\xC3\xB6-7");
  std::ofstream(usb / "product") << "Kraftger\xC3\xA4t\n";
  EXPECT_EQ(nameOfNode("/dev/hidraw3", system), "Kraftger\xC3\xA4t");
  std::ofstream(usb / "product") << "Kraftger\xE4t\n";  // Latin-1 is no text of ours
  EXPECT_EQ(nameOfNode("/dev/hidraw3", system), "M\xC3\xBCller Kraftger\xC3\xA4t");
  EXPECT_EQ(nameOfNode("/dev/hidraw4", system), "");
}

}  // namespace
}  // namespace tactus::haptics
