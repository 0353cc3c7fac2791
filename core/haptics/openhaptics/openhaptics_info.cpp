#include "core/haptics/openhaptics/openhaptics_info.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace tactus::haptics {
namespace {

/// Stronger than any device that a hand should hold with this program; a larger number is a wrong unit.
constexpr double kLargestForceN = 50;
constexpr double kSoftestNMm = 0.05;
constexpr double kStiffestNMm = 5;

std::string readString(const HdApi& api, std::uint32_t name) {
  const char* const text = api.get_string(name);
  return text == nullptr ? std::string() : std::string(base::trimmed(text));
}

double readDouble(const HdApi& api, std::uint32_t name) {
  double value = 0;
  api.get_doublev(name, &value);
  return value;
}

int readInteger(const HdApi& api, std::uint32_t name) {
  int value = 0;
  api.get_integerv(name, &value);
  return value;
}

}  // namespace

std::string openHapticsId(const std::string& config_name) {
  return config_name.empty() ? "openhaptics" : "openhaptics:" + config_name;
}

base::Result<DeviceInfo> readInfo(const HdApi& api, const std::string& config_name) {
  DeviceInfo info;
  info.id = openHapticsId(config_name);
  info.name = readString(api, hd::kDeviceModelType);
  if (info.name.empty()) info.name = "OpenHaptics device";
  info.serial = readString(api, hd::kDeviceSerialNumber);
  info.backend = "openhaptics";
  info.position_axes = 3;
  const int output_axes = readInteger(api, hd::kOutputDof);
  info.force_axes = output_axes > 0 ? std::min(output_axes, 3) : 3;
  info.buttons = 4;  // as many as the driver reports; which of them exist it does not tell

  info.max_force_n = readDouble(api, hd::kNominalMaxForce);
  if (!(info.max_force_n > 0 && info.max_force_n <= kLargestForceN))
    return base::fail(base::ErrorCode::kValue, info.id + ": largest force", base::formatNumber(info.max_force_n) + " N",
                      "more than 0 and at most 50 N");
  const double continuous = readDouble(api, hd::kNominalMaxContinuousForce);
  if (continuous > 0 && continuous <= info.max_force_n) info.continuous_force_n = continuous;
  const double stiffness = readDouble(api, hd::kNominalMaxStiffness);
  if (stiffness >= kSoftestNMm && stiffness <= kStiffestNMm) info.max_stiffness_n_mm = stiffness;
  return info;
}

}  // namespace tactus::haptics
