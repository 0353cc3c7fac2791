#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <hidapi/hidapi.h>
#include <optional>
#include <string_view>
#include <unistd.h>

#include "core/base/files/file.h"
#include "core/base/text.h"
#include "core/haptics/hid/hid_pid_device.h"
#include "core/haptics/hid/hidapi_transport.h"
#include "core/haptics/hid/pid_layout.h"

namespace tactus::haptics {
namespace {

struct Entry {
  std::uint16_t vendor;
  std::optional<std::uint16_t> product;  ///< nothing: all of this maker
  KnownDevice device;
};

constexpr std::string_view kOpenHaptics =
    "It is reached through the maker's library only: install OpenHaptics and its device driver, then choose the "
    "OpenHaptics backend.";
constexpr std::string_view kOwnProtocol =
    "It speaks the maker's own protocol instead of HID PID, and Tactus does not know it. Use a PID device, an "
    "OpenHaptics device or the virtual one.";

constexpr std::array kKnown = {
    Entry{0x2988, 0x0304, {"3D Systems Touch (HID)", kOpenHaptics}},
    Entry{0x2988, 0x0302, {"3D Systems Touch USB", kOpenHaptics}},
    Entry{0x0301, 0x2988, {"3D Systems Touch USB", kOpenHaptics}},
    Entry{0x0403,
          0xCB48,
          {"Novint Falcon",
           "It is no HID device: it needs its firmware loaded over a serial chip, which Tactus does not do. Use a PID "
           "device, an OpenHaptics device or the virtual one."}},
    Entry{0x1451,
          std::nullopt,
          {"Force Dimension device",
           "It is reached through the maker's own library, which Tactus does not use. Use a PID device, an OpenHaptics "
           "device or the virtual one."}},
    Entry{0x046D, std::nullopt, {"Logitech wheel or joystick", kOwnProtocol, true}},
    Entry{0x044F, std::nullopt, {"Thrustmaster wheel or joystick", kOwnProtocol, true}},
    Entry{0x0EB7, std::nullopt, {"Fanatec wheel", kOwnProtocol, true}},
};

}  // namespace

std::optional<KnownDevice> knownDevice(std::uint16_t vendor, std::uint16_t product) noexcept {
  for (const Entry& entry : kKnown) {
    if (entry.vendor == vendor && (!entry.product || *entry.product == product)) return entry.device;
  }
  return std::nullopt;
}

namespace {

namespace fs = std::filesystem;

std::string hex4(std::uint16_t value) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string out(4, '0');
  for (int i = 0; i < 4; ++i) out[static_cast<std::size_t>(i)] = kDigits[value >> (12 - 4 * i) & 0xF];
  return out;
}

/// Strings of a device as UTF-8; characters that cannot be are left out.
std::string utf8(const wchar_t* text) {
  std::string out;
  for (; text != nullptr && *text != 0; ++text) {
    const std::uint32_t c = std::char_traits<wchar_t>::to_int_type(*text);
    if (c < 0x20 || (c >= 0xD800 && c < 0xE000) || c > 0x10FFFF) continue;
    if (c < 0x80) {
      out += static_cast<char>(c);
    } else if (c < 0x800) {
      out += {static_cast<char>(0xC0U | c >> 6U), static_cast<char>(0x80U | (c & 0x3FU))};
    } else if (c < 0x10000) {
      out += {static_cast<char>(0xE0U | c >> 12U), static_cast<char>(0x80U | (c >> 6U & 0x3FU)),
              static_cast<char>(0x80U | (c & 0x3FU))};
    } else {
      out += {static_cast<char>(0xF0U | c >> 18U), static_cast<char>(0x80U | (c >> 12U & 0x3FU)),
              static_cast<char>(0x80U | (c >> 6U & 0x3FU)), static_cast<char>(0x80U | (c & 0x3FU))};
    }
  }
  return std::string(base::trimmed(out));
}

std::optional<std::uint16_t> readHex(const fs::path& file) {
  const auto text = base::readFile(file.string(), 4096);
  if (!text) return std::nullopt;
  std::uint16_t value = 0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value, 16);
  if (error != std::errc()) return std::nullopt;
  return value;
}

/// Where the kernel keeps what it knows of the node `/dev/hidrawN`.
fs::path deviceFolder(const std::string& path, const std::string& system_folder) {
  return fs::path(system_folder) / fs::path(path).filename() / "device";
}

/// The first line of `file`, as far as it is UTF-8 that can be shown; empty where there is none.
std::string firstLine(const fs::path& file) {
  const auto text = base::readFile(file.string(), 4096);
  if (!text) return {};
  const std::string_view line = base::trimmed(std::string_view(*text).substr(0, text->find('\n')));
  return base::isUtf8(line) ? std::string(line) : std::string();
}

/// What the kernel notes under `key` (`HID_NAME=…`) of the node, or an empty text.
std::string noted(const std::string& path, const std::string& system_folder, std::string_view key) {
  const auto text = base::readFile((deviceFolder(path, system_folder) / "uevent").string(), 65536);
  if (!text) return {};
  for (std::string_view rest = *text; !rest.empty();) {
    const auto end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (!line.starts_with(key) || line.substr(key.size(), 1) != "=") continue;
    const std::string_view value = base::trimmed(line.substr(key.size() + 1));
    return base::isUtf8(value) ? std::string(value) : std::string();
  }
  return {};
}

/// A joystick, game pad or simulation control, as the outermost collection says.
bool isGameDevice(const ReportDescriptor& descriptor) {
  constexpr Usage kJoystick{0x01, 0x04};
  constexpr Usage kGamePad{0x01, 0x05};
  constexpr std::uint16_t kSimulationPage = 0x02;
  return std::any_of(descriptor.fields().begin(), descriptor.fields().end(), [&](const HidField& field) {
    if (field.path.empty()) return false;
    const Usage& use = field.path.front();
    return use == kJoystick || use == kGamePad || use.page == kSimulationPage;
  });
}

HidDevice fromEntry(const hid_device_info& entry) {
  HidDevice device;
  device.path = entry.path;
  device.vendor = entry.vendor_id;
  device.product = entry.product_id;
  device.identity.serial = utf8(entry.serial_number);
  device.identity.name = utf8(entry.product_string);
  // hidapi reads names by the program's locale, and in the one of C a name with an umlaut is none.
  if (device.identity.name.empty()) device.identity.name = nameOfNode(device.path);
  if (device.identity.serial.empty()) device.identity.serial = serialOfNode(device.path);
  device.identity.id = hidDeviceId(device.vendor, device.product, device.identity.serial);
  return device;
}

}  // namespace

std::string hidDeviceId(std::uint16_t vendor, std::uint16_t product, const std::string& serial) {
  return "hid:" + hex4(vendor) + ":" + hex4(product) + (serial.empty() ? "" : ":" + serial);
}

void judge(HidDevice& device, const base::Result<std::vector<std::uint8_t>>& descriptor, bool may_open) {
  const auto known = knownDevice(device.vendor, device.product);
  const auto parsed = descriptor.and_then([](const auto& bytes) { return ReportDescriptor::parse(bytes); });
  if (parsed && claimsPid(*parsed)) {
    device.kind = HidDeviceKind::kPid;
    const auto layout = PidLayout::find(*parsed);
    if (!layout) {
      device.problem = layout.error().message();
      device.advice = "Its firmware lacks what Tactus needs. Look for a newer one, or use another device.";
    } else if (!may_open) {
      device.problem = "no permission to open " + device.path;
      device.advice =
          "Install the file 60-tactus.rules (docs/devices.md), then unplug the device and plug it in again.";
    }
    return;
  }
  if (!known || (known->game_devices_only && !(parsed && isGameDevice(*parsed)))) return;
  device.kind = HidDeviceKind::kKnown;
  device.problem = std::string(known->name) + ": no force feedback by HID PID";
  device.advice = known->advice;
}

std::string nameOfNode(const std::string& path, const std::string& system_folder) {
  // A USB device says its product; the folder of the HID device is two below it.
  std::error_code error;
  const fs::path device = fs::canonical(deviceFolder(path, system_folder), error);
  if (!error) {
    std::string product = firstLine(device.parent_path().parent_path() / "product");
    if (!product.empty()) return product;
  }
  return noted(path, system_folder, "HID_NAME");
}

std::string serialOfNode(const std::string& path, const std::string& system_folder) {
  return noted(path, system_folder, "HID_UNIQ");
}

void noteHolder(HidDevice& device, const std::optional<NodeHolder>& holder) {
  if (!holder || holder->isThisProgram()) return;
  device.used_by = holder->text();
  if (!device.problem.empty()) return;
  device.problem = "in use by " + device.used_by;
  device.advice = "Close that program, or stop its device there.";
}

std::vector<HidDevice> listHidDevices(bool all) {
  std::vector<HidDevice> devices;
  hid_device_info* const entries = hid_enumerate(0, 0);
  for (const hid_device_info* entry = entries; entry != nullptr; entry = entry->next) {
    if (entry->path == nullptr) continue;
    const auto same = [&](const HidDevice& device) { return device.path == entry->path; };
    if (std::any_of(devices.begin(), devices.end(), same)) continue;
    devices.push_back(fromEntry(*entry));
    HidDevice& device = devices.back();
    judge(device, descriptorOfNode(device.path), ::access(device.path.c_str(), R_OK | W_OK) == 0);
    if (device.kind == HidDeviceKind::kPid) noteHolder(device, holderOf(device.path));
  }
  hid_free_enumeration(entries);
  if (!all) std::erase_if(devices, [](const HidDevice& device) { return device.kind == HidDeviceKind::kOther; });
  for (HidDevice& device : knownUsbDevices("/sys/bus/usb/devices")) {
    const auto same = [&](const HidDevice& listed) {
      return listed.vendor == device.vendor && listed.product == device.product;
    };
    if (std::none_of(devices.begin(), devices.end(), same)) devices.push_back(std::move(device));
  }
  return devices;
}

std::vector<HidDevice> knownUsbDevices(const std::string& folder) {
  std::vector<HidDevice> devices;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const auto vendor = readHex(entry->path() / "idVendor");
    const auto product = readHex(entry->path() / "idProduct");
    if (!vendor || !product) continue;
    const auto known = knownDevice(*vendor, *product);
    if (!known || known->game_devices_only) continue;
    HidDevice device;
    device.vendor = *vendor;
    device.product = *product;
    device.identity.name = known->name;
    device.identity.id = "usb:" + hex4(*vendor) + ":" + hex4(*product);
    device.kind = HidDeviceKind::kKnown;
    device.problem = std::string(known->name) + ": no force feedback by HID PID";
    device.advice = known->advice;
    devices.push_back(std::move(device));
  }
  std::sort(devices.begin(), devices.end(),
            [](const HidDevice& a, const HidDevice& b) { return a.identity.id < b.identity.id; });
  return devices;
}

}  // namespace tactus::haptics
