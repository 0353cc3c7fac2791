// The properties of a device as reported by the OpenHaptics driver, with implausible values left out.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/haptics/device/device.h"
#include "core/haptics/openhaptics/hd_api.h"

namespace tactus::haptics {

/// Reads name, serial number and limits of the current device. `config_name`: the name used to open it, empty for the
/// default device. Returns an error if the largest force is not a positive number, because no force could be limited by
/// it. Leaves out a continuous force above the largest one, and a stiffness outside 0.05 to 5 N/mm (some drivers report
/// a share instead).
base::Result<DeviceInfo> readInfo(const HdApi& api, const std::string& config_name);

/// `openhaptics`, or `openhaptics:NAME` for a named configuration.
std::string openHapticsId(const std::string& config_name);

}  // namespace tactus::haptics
