#include "core/haptics/openhaptics/hd_error.h"

#include <array>

#include "core/base/error.h"

namespace tactus::haptics {
namespace {

constexpr int kLongestStack = 64;

const char* meaning(std::uint32_t code) noexcept {
  switch (code) {
    case hd::kWarmMotors:
      return "the motors are too warm";
    case hd::kExceededMaxForce:
      return "a force above the maximum was refused";
    case hd::kExceededMaxForceImpulse:
      return "a force that rose too fast was refused";
    case hd::kExceededMaxVelocity:
      return "the stylus moved too fast for forces";
    case hd::kForceError:
      return "the device could not give the force";
    case hd::kDeviceFault:
      return "the device reports a fault";
    case hd::kDeviceAlreadyInitiated:
      return "the device is open already";
    case hd::kCommError:
      return "the device does not answer";
    case hd::kCommConfigError:
      return "the connection is not set up";
    case hd::kTimerError:
      return "the driver's timer failed";
    case hd::kIllegalBegin:
    case hd::kIllegalEnd:
    case hd::kFrameError:
      return "the driver's frame was broken";
    case hd::kSchedulerFull:
      return "the driver takes no further callback";
    case hd::kInvalidLicence:
      return "the driver's license is not valid";
    default:
      return "the driver reports an error";
  }
}

std::string hexadecimal(std::uint32_t code) {
  std::array<char, 8> digits{};
  int used = 0;
  do {
    digits[static_cast<std::size_t>(used++)] = "0123456789abcdef"[code & 15u];
    code >>= 4;
  } while (code != 0 || used < 4);
  return "0x" + std::string(digits.rend() - used, digits.rend());
}

/// Larger counts more.
int gravity(DeviceFault fault) noexcept {
  switch (fault) {
    case DeviceFault::kNone:
      return 0;
    case DeviceFault::kForceLimited:
      return 1;
    case DeviceFault::kWarmMotors:
      return 2;
    case DeviceFault::kLost:
      return 4;
    default:
      return 3;
  }
}

}  // namespace

DeviceFault faultOf(std::uint32_t code) noexcept {
  if (code == hd::kSuccess) return DeviceFault::kNone;
  if (endsLoop(code)) return DeviceFault::kLost;
  if (code == hd::kWarmMotors) return DeviceFault::kWarmMotors;
  return code > hd::kWarmMotors && code <= hd::kForceError ? DeviceFault::kForceLimited : DeviceFault::kFailed;
}

bool endsLoop(std::uint32_t code) noexcept {
  return code == hd::kCommError || code == hd::kTimerError || code == hd::kIllegalBegin || code == hd::kIllegalEnd;
}

HdErrors drainErrors(const HdApi& api) noexcept {
  HdErrors errors;
  while (errors.count < kLongestStack) {
    const HdErrorRecord error = api.get_error();
    if (error.code == hd::kSuccess) break;
    if (errors.count++ == 0) errors.newest = error;
    const DeviceFault fault = faultOf(error.code);
    if (gravity(fault) <= gravity(errors.fault)) continue;
    errors.fault = fault;
    errors.gravest = error;
  }
  return errors;
}

std::string describe(const HdApi& api, const HdErrorRecord& error) {
  std::string text = std::string(meaning(error.code)) + " (" + hexadecimal(error.code);
  if (error.internal_code != 0) text += ", internal " + std::to_string(error.internal_code);
  const char* const words = api.get_error_string(error.code);
  if (words != nullptr && *words != '\0') text += ", " + base::quoted(words);
  return text + ")";
}

}  // namespace tactus::haptics
