#include "app/devices/device_list.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/haptics/hid/hidapi_transport.h"
#include "core/haptics/openhaptics/openhaptics_device.h"
#include "core/haptics/servo/servo_core.h"
#include "core/haptics/simulated/virtual_device.h"

namespace tactus::devices {
namespace {

using base::Result;

constexpr std::string_view kOpenHaptics = "openhaptics";
constexpr std::string_view kHaply = "haply";
constexpr std::string_view kSimulatedHaply = "simulated-haply";

/// `backend` alone, or with a name behind a colon.
bool isOf(std::string_view backend, const std::string& id) {
  return id == backend || id.starts_with(std::string(backend) + ':');
}

std::string calibrateAdvice(const std::string& id) { return "calibrate it: tactus devices calibrate " + id; }

Result<OpenedDevice> openVirtual() {
  TACTUS_TRY(auto device, haptics::VirtualDevice::make());
  return OpenedDevice{std::move(device), {}, {}, {}};
}

Result<OpenedDevice> openOpenHaptics(const std::string& id, const DeviceSettings& settings,
                                     const std::vector<haptics::DeviceAxis>& axes) {
  TACTUS_TRY(const auto library, haptics::HdLibrary::load(settings.hd_library));
  haptics::OpenHapticsSettings chosen;
  if (id.size() > kOpenHaptics.size()) chosen.name = id.substr(kOpenHaptics.size() + 1);
  TACTUS_TRY(auto device, haptics::OpenHapticsDevice::open(library, std::move(chosen)));
  OpenedDevice opened;
  opened.calibration_advice = (device)->calibrationAdvice();
  opened.device = std::move(device);
  const haptics::DeviceInfo& info = opened.device->info();
  if (const auto* const stored = findAxis(axes, info.id, info.serial); stored != nullptr) {
    TACTUS_TRY(const auto axis, haptics::AxisMapping::make(stored->inwards));
    opened.axis = axis;
  }
  opened.axis_advice = turnAxisAdvice(info.id, opened.axis.inwards());
  return opened;
}

Result<OpenedDevice> openHaply(const std::string& id, const DeviceSettings& settings,
                               const std::vector<haptics::DeviceAxis>& axes) {
  TACTUS_TRY(auto device, haptics::HaplyDevice::open(settings.haply_port, id == kHaply ? std::string() : id));
  OpenedDevice opened;
  const haptics::HaplyFound& found = device->found();
  const auto* const stored = findAxis(axes, found.info.id, found.info.serial);
  TACTUS_TRY(opened.axis,
             haptics::AxisMapping::make(stored != nullptr ? stored->inwards : opened.axis.inwards(), found.middle_mm));
  opened.calibration_advice = found.advice;
  opened.axis_advice = turnAxisAdvice(found.info.id, opened.axis.inwards());
  opened.device = std::move(device);
  return opened;
}

Result<haptics::HidDevice> findHid(const std::string& id) {
  const auto devices = haptics::listHidDevices();
  for (const auto& device : devices) {
    if (device.identity.id != id) continue;
    if (device.problem.empty()) return device;
    return base::fail(base::ErrorCode::kIo, id, device.problem, device.advice);
  }
  return base::fail(base::ErrorCode::kReference, id, "no such device", "one that `tactus devices` lists");
}

Result<OpenedDevice> openHid(const std::string& id, const haptics::DeviceCalibration* calibration,
                             const haptics::HidDevice& found) {
  TACTUS_TRY(auto transport, haptics::HidapiTransport::open(found.path));
  TACTUS_TRY(auto device,
             haptics::HidPidDevice::open(std::move(transport), found.identity,
                                         calibration == nullptr ? std::nullopt : std::optional(*calibration)));
  OpenedDevice opened;
  opened.device = std::move(device);
  if (calibration != nullptr) opened.axis = axisOf(*calibration);
  opened.calibration_advice = calibrateAdvice(id);
  opened.axis_advice = "calibrate it again: tactus devices calibrate " + id;
  return opened;
}

}  // namespace

Result<OpenedDevice> open(const std::string& id, const DeviceSettings& settings) {
  if (id == "virtual") return openVirtual();
  const bool own = hasOwnCalibration(id);
  if (!own && !id.starts_with("hid:"))
    return base::fail(base::ErrorCode::kReference, "device", base::quoted(id),
                      "an id that `tactus devices` lists: virtual, hid:…, openhaptics, haply:…");
  TACTUS_TRY(const auto file, haptics::readCalibrationFile(settings.calibrations));
  if (isOf(kOpenHaptics, id)) return openOpenHaptics(id, settings, file.axes);
  if (own) return openHaply(id, settings, file.axes);
  TACTUS_TRY(const auto found, findHid(id));
  return openHid(id, findCalibration(file.calibrations, id, found.identity.serial), found);
}

bool hasOwnCalibration(const std::string& id) {
  return isOf(kOpenHaptics, id) || isOf(kHaply, id) || isOf(kSimulatedHaply, id);
}

std::string turnAxisAdvice(const std::string& id, const haptics::Vector3& inwards) {
  return "turn its insertion axis around: tactus devices calibrate " + id + " --inwards=" + directionText(-1 * inwards);
}

std::string directionText(const haptics::Vector3& direction) {
  std::string text;
  for (const double coordinate : {direction.x, direction.y, direction.z}) {
    // Four digits are more than a person can set up; -0 becomes 0.
    text += (text.empty() ? "" : ",") + base::formatNumber(std::round(coordinate * 1e4) / 1e4 + 0.0);
  }
  return text;
}

Result<OpenedDevice> openRaw(const std::string& id) {
  TACTUS_TRY(const auto found, findHid(id));
  return openHid(id, nullptr, found);
}

namespace {

using haptics::HidDevice;
using haptics::HidDeviceKind;

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

std::string defaultCalibrations() {
  std::filesystem::path folder = variable("XDG_CONFIG_HOME");
  if (folder.empty()) folder = std::filesystem::path(variable("HOME")) / ".config";
  return (folder / "tactus" / "calibrations.json").string();
}

/// A Touch has no HID reports that are public; OpenHaptics is the way to it.
bool isTouch(const HidDevice& device) {
  constexpr std::uint16_t kVendor = 0x2988;
  return device.kind == HidDeviceKind::kKnown && (device.vendor == kVendor || device.product == kVendor);
}

ListedDevice listed(const HidDevice& found, const std::vector<haptics::DeviceCalibration>& calibrations) {
  ListedDevice device;
  device.id = found.identity.id;
  device.name = found.identity.name;
  device.serial = found.identity.serial;
  device.backend = found.kind == HidDeviceKind::kPid ? "hid-pid" : "none";
  device.usable = found.problem.empty();
  device.reason = found.problem;
  device.used_by = found.used_by;
  device.advice = found.advice;
  if (found.kind != HidDeviceKind::kPid) return device;
  device.calibrated = findCalibration(calibrations, device.id, device.serial) != nullptr;
  if (device.usable && !*device.calibrated) device.advice = "calibrate it: tactus devices calibrate " + device.id;
  return device;
}

ListedDevice listed(const OpenHapticsLook& look) {
  ListedDevice device;
  device.id = look.info->id;
  device.name = look.info->name;
  device.serial = look.info->serial;
  device.backend = look.info->backend;
  device.usable = true;
  device.calibrated = look.calibrated;
  if (!look.calibrated) device.advice = look.calibration_advice;
  return device;
}

ListedDevice listed(const haptics::HaplyFound& found) {
  ListedDevice device;
  device.id = found.info.id;
  device.name = found.info.name;
  device.serial = found.info.serial;
  device.backend = found.info.backend;
  device.simulated = found.info.simulated;
  device.usable = found.problem.empty();
  device.reason = found.problem;
  device.advice = found.advice;
  if (device.usable && found.calibrated && found.info.buttons == 0)
    device.advice = "switch its grip on, or hold the tube with a key or a pedal";
  device.calibrated = found.calibrated;
  device.round_trip_s = found.round_trip_s;
  device.largest_stiffness_n_mm = haptics::largestStiffnessNMm(found.info);
  return device;
}

void addHaply(const HaplyLook& haply, DeviceList& list) {
  if (!haply) {
    list.notes.push_back("Haply is not in use: " + haply.error().message());
    return;
  }
  for (const haptics::HaplyFound& found : *haply) list.devices.push_back(listed(found));
  if (haply->empty()) list.notes.push_back("Haply is not in use: its service has no device; connect the Inverse3");
  if (haply->size() > 1)
    list.notes.push_back("Of " + std::to_string(haply->size()) +
                         " Haply devices, `haply` alone means the first: " + haply->front().info.id);
}

ListedDevice virtualDevice() {
  ListedDevice device;
  device.id = "virtual";
  device.name = "Virtual device (simulated)";
  device.backend = "virtual";
  device.simulated = true;
  device.usable = true;
  device.calibrated = true;
  return device;
}

}  // namespace

DeviceSettings settingsOfProcess() {
  DeviceSettings settings;
  settings.hd_library = variable("TACTUS_LIBHD");
  if (const std::string port = variable("TACTUS_HAPLY_PORT"); !port.empty()) {
    const auto number = base::parseInteger(port);
    settings.haply_port = number && *number > 0 && *number <= 65535 ? static_cast<std::uint16_t>(*number) : 0;
  }
  settings.calibrations = variable("TACTUS_CALIBRATIONS");
  if (settings.calibrations.empty()) settings.calibrations = defaultCalibrations();
  return settings;
}

OpenHapticsLook lookAtOpenHaptics(const std::string& hd_library) {
  OpenHapticsLook look;
  const auto refused = [&](const base::Error& error) {
    look.reason = error.place + ": " + error.found;
    look.advice = "it needs " + error.wanted;
    return look;
  };
  const auto library = haptics::HdLibrary::load(hd_library);
  if (!library) return refused(library.error());
  const auto device = haptics::OpenHapticsDevice::open(*library);
  if (!device) return refused(device.error());
  look.info = (*device)->info();
  look.calibrated = (*device)->calibrated();
  look.calibration_advice = (*device)->calibrationAdvice();
  return look;
}

DeviceList listOf(const std::vector<HidDevice>& hid, const OpenHapticsLook& openhaptics, const HaplyLook& haply,
                  const std::vector<haptics::DeviceCalibration>& calibrations) {
  DeviceList list;
  if (openhaptics.info) list.devices.push_back(listed(openhaptics));
  bool touch = false;
  for (const HidDevice& found : hid) {
    if (!isTouch(found)) {
      list.devices.push_back(listed(found, calibrations));
      continue;
    }
    touch = true;
    if (openhaptics.info) continue;
    ListedDevice device = listed(found, calibrations);
    device.backend = "openhaptics";
    device.reason = openhaptics.reason;
    device.advice = openhaptics.advice;
    list.devices.push_back(std::move(device));
  }
  if (!openhaptics.info && !touch)
    list.notes.push_back("OpenHaptics is not in use: " + openhaptics.reason + "; " + openhaptics.advice);
  addHaply(haply, list);
  list.devices.push_back(virtualDevice());
  return list;
}

DeviceList listDevices(const DeviceSettings& settings) {
  const auto file = haptics::readCalibrationFile(settings.calibrations);
  DeviceList list =
      listOf(haptics::listHidDevices(), lookAtOpenHaptics(settings.hd_library),
             haptics::lookAtHaply(settings.haply_port), file.value_or(haptics::CalibrationFile()).calibrations);
  if (!file) list.notes.push_back(file.error().message());
  return list;
}

}  // namespace tactus::devices
