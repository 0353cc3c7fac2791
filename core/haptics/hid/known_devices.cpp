#include "core/haptics/hid/known_devices.h"

#include <array>

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

}  // namespace tactus::haptics
