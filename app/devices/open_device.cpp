#include "app/devices/open_device.h"

#include <cmath>
#include <string_view>

#include "core/base/text.h"
#include "core/haptics/hid/hidapi_transport.h"
#include "core/haptics/openhaptics/openhaptics_device.h"
#include "core/haptics/simulated/virtual_device.h"

namespace tactus::devices {
namespace {

using base::Result;

constexpr std::string_view kOpenHaptics = "openhaptics";

std::string calibrateAdvice(const std::string& id) { return "calibrate it: tactus devices calibrate " + id; }

Result<OpenedDevice> openVirtual() {
  auto device = haptics::VirtualDevice::make();
  if (!device) return tl::unexpected(device.error());
  return OpenedDevice{std::move(*device), {}, {}, {}};
}

Result<OpenedDevice> openOpenHaptics(const std::string& id, const DeviceSettings& settings,
                                     const std::vector<haptics::DeviceAxis>& axes) {
  const auto library = haptics::HdLibrary::load(settings.hd_library);
  if (!library) return tl::unexpected(library.error());
  haptics::OpenHapticsSettings chosen;
  if (id.size() > kOpenHaptics.size()) chosen.name = id.substr(kOpenHaptics.size() + 1);
  auto device = haptics::OpenHapticsDevice::open(*library, std::move(chosen));
  if (!device) return tl::unexpected(device.error());
  OpenedDevice opened;
  opened.calibration_advice = (*device)->calibrationAdvice();
  opened.device = std::move(*device);
  const haptics::DeviceInfo& info = opened.device->info();
  if (const auto* const stored = findAxis(axes, info.id, info.serial); stored != nullptr) {
    const auto axis = haptics::AxisMapping::make(stored->inwards);
    if (!axis) return tl::unexpected(axis.error());
    opened.axis = *axis;
  }
  opened.axis_advice = turnAxisAdvice(info.id, opened.axis.inwards());
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
  auto transport = haptics::HidapiTransport::open(found.path);
  if (!transport) return tl::unexpected(transport.error());
  auto device = haptics::HidPidDevice::open(std::move(*transport), found.identity,
                                            calibration == nullptr ? std::nullopt : std::optional(*calibration));
  if (!device) return tl::unexpected(device.error());
  OpenedDevice opened;
  opened.device = std::move(*device);
  if (calibration != nullptr) opened.axis = axisOf(*calibration);
  opened.calibration_advice = calibrateAdvice(id);
  opened.axis_advice = "calibrate it again: tactus devices calibrate " + id;
  return opened;
}

}  // namespace

Result<OpenedDevice> open(const std::string& id, const DeviceSettings& settings) {
  if (id == "virtual") return openVirtual();
  const bool openhaptics = id == kOpenHaptics || id.starts_with(std::string(kOpenHaptics) + ':');
  if (!openhaptics && !id.starts_with("hid:"))
    return base::fail(base::ErrorCode::kReference, "device", base::quoted(id),
                      "an id that `tactus devices` lists: virtual, hid:…, openhaptics");
  const auto file = haptics::readCalibrationFile(settings.calibrations);
  if (!file) return tl::unexpected(file.error());
  if (openhaptics) return openOpenHaptics(id, settings, file->axes);
  const auto found = findHid(id);
  if (!found) return tl::unexpected(found.error());
  return openHid(id, findCalibration(file->calibrations, id, found->identity.serial), *found);
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
  const auto found = findHid(id);
  if (!found) return tl::unexpected(found.error());
  return openHid(id, nullptr, *found);
}

}  // namespace tactus::devices
