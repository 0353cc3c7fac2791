// What the OpenHaptics driver tells about a device, as far as it can be believed.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/haptics/device/device.h"
#include "core/haptics/openhaptics/hd_api.h"

namespace tactus::haptics {

/// Reads name, serial number and limits of the current device. `config_name` as it was opened, empty for the default
/// one. Refused: a largest force that is none, because nothing could be limited by it. A continuous force above the
/// largest one and a stiffness outside 0.05 to 5 N/mm (some drivers give a share instead) are left out.
base::Result<DeviceInfo> readInfo(const HdApi& api, const std::string& config_name);

/// `openhaptics`, or `openhaptics:NAME` for a named configuration.
std::string openHapticsId(const std::string& config_name);

}  // namespace tactus::haptics
