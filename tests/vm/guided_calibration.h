// Plays the person in the guided calibration: puts the handle where it is asked for, reads ruler and spring scale.
#pragma once

#include "core/haptics/device/calibration_procedure.h"
#include "core/haptics/device/device.h"

#include "tests/vm/device_process.h"
#include "tests/vm/true_handle.h"

namespace tactus::vm {

/// `device` is started and has no calibration. The error of a procedure that fails is its last instruction.
base::Result<haptics::DeviceCalibration> calibrate(haptics::HapticDevice& device, DeviceProcess& hand,
                                                   const TrueHandle& truth);

}  // namespace tactus::vm
