// The position of a device along the usual axis of insertion, for the tests.
#pragma once

#include "core/haptics/device/device.h"

namespace tactus::haptics {

inline double axisMm(const DeviceState& state) { return AxisMapping().positionMm(state.position_mm); }

}  // namespace tactus::haptics
