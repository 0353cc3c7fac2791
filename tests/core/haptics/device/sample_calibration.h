// A calibration with every member set, for the tests of calibrations and of their file.
#pragma once

#include "core/haptics/device/calibration_file.h"

namespace tactus::haptics {

inline DeviceCalibration sample() {
  DeviceCalibration c;
  c.device = "hid:1209:ffb0:7";
  c.serial = "7";
  c.full_scale_n = 12.5;
  c.force_sign = {1, 1, -1};
  c.mm_per_count = 0.0125;
  c.inwards = {0.6, 0, -0.8};
  c.origin_mm = {1, 2, 3.25};
  c.friction_in_n = 0.31;
  c.silent_when_still = true;
  c.measured_at = "2026-11-21T08:00:00Z";
  c.procedure = "guided 1, spring scale";
  return c;
}

}  // namespace tactus::haptics
