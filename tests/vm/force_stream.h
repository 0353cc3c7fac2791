// A different force each millisecond: which of them the device felt, and when.
#pragma once

#include <vector>

#include "core/haptics/device/device.h"

#include "tests/vm/device_process.h"

namespace tactus::vm {

struct ForceStream {
  int written = 0;
  int lost = 0;                    ///< overtaken by a newer one, never felt
  double largest_error = 0;        ///< |felt - asked|, share of full scale
  std::vector<double> latency_us;  ///< from `write` until the device had the report
};

/// From -0.9 to 0.9 of full scale in equal steps, along y of a device with two axes and x of one with one, so that each
/// force is one report.
ForceStream streamForces(haptics::HapticDevice& device, DeviceProcess& hand, int ticks);

}  // namespace tactus::vm
