// Opening: which name the driver takes, and what to do when it takes none.
#include <vector>

#include "core/haptics/openhaptics/openhaptics_device.h"
#include "core/haptics/openhaptics/openhaptics_info.h"

namespace tactus::haptics {
namespace {

/// Names to try when none was chosen; null is the driver's own default.
constexpr const char* kDefaultNames[] = {nullptr, "Default Device", "Default PHANToM"};

struct Opened {
  HdHandle handle = hd::kInvalidHandle;
  HdErrorRecord error;  ///< why not
};

Opened tryName(const HdApi& api, const char* name) {
  drainErrors(api);
  Opened opened;
  opened.handle = api.init_device(name);
  const HdErrors errors = drainErrors(api);
  // Warm motors pass; a handle beside any other error is not one to work with.
  const bool usable = errors.fault == DeviceFault::kNone || errors.fault == DeviceFault::kWarmMotors;
  if (opened.handle == hd::kInvalidHandle || usable) {
    opened.error = errors.gravest;
    return opened;
  }
  api.disable_device(opened.handle);
  drainErrors(api);
  return {hd::kInvalidHandle, errors.gravest};
}

std::string whatToDo(std::uint32_t code) {
  switch (code) {
    case hd::kDeviceAlreadyInitiated:
      return "a device that no other program has open (Touch Setup, Touch Diagnostics, a simulator: only one can)";
    case hd::kInvalidLicence: return "a valid OpenHaptics license";
    default: break;
  }
  std::string text =
      "a device that is plugged in, has its supply, is set up in Touch Setup under this name and is open in no other "
      "program";
  const std::string advice = hdEnvironmentAdvice();
  return advice.empty() ? text : text + "; " + advice;
}

}  // namespace

base::Result<std::unique_ptr<OpenHapticsDevice>> OpenHapticsDevice::open(std::shared_ptr<const HdLibrary> library,
                                                                         OpenHapticsSettings settings) {
  const HdApi& api = library->api();
  std::vector<const char*> names(std::begin(kDefaultNames), std::end(kDefaultNames));
  if (!settings.name.empty()) names = {settings.name.c_str()};

  Opened opened;
  HdErrorRecord reason;
  for (const char* const name : names) {
    opened = tryName(api, name);
    if (opened.handle != hd::kInvalidHandle) break;
    // It was found; another name would only hide why it does not open.
    const bool taken = opened.error.code == hd::kDeviceAlreadyInitiated;
    if (taken || reason.code == hd::kSuccess) reason = opened.error;
    if (taken) break;
  }
  if (opened.handle == hd::kInvalidHandle) {
    std::string found = reason.code == hd::kSuccess ? "no device, and no reason" : describe(api, reason);
    if (names.size() > 1 && reason.code != hd::kDeviceAlreadyInitiated)
      found += ", also by the names Default Device and Default PHANToM";
    return base::fail(base::ErrorCode::kIo, openHapticsId(settings.name), found, whatToDo(reason.code));
  }

  api.make_current_device(opened.handle);
  const auto info = readInfo(api, settings.name);
  int styles = 0;
  api.get_integerv(hd::kCalibrationStyle, &styles);
  drainErrors(api);
  if (!info) {
    api.disable_device(opened.handle);
    return tl::unexpected(info.error());
  }
  std::unique_ptr<OpenHapticsDevice> device(
      new OpenHapticsDevice(std::move(library), opened.handle, *info, styles, std::move(settings)));
  drainErrors(api);
  return device;
}

}  // namespace tactus::haptics
