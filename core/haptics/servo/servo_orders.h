// The orders of the program to the servo. The program posts a complete set; the next tick uses it.
#pragma once

#include <cstdint>
#include <memory>

#include "core/haptics/device/axis_mapping.h"
#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/sources/force_source.h"
#include "core/haptics/sources/servo_scene.h"

namespace tactus::haptics {

/// Immutable after posting. Only a difference from the previous orders has an effect; posting the same orders again
/// changes nothing.
struct ServoOrders {
  ForceSource source = ForceSource::kOff;
  /// Forces are possible. A change from false to true starts the fade-in and clears a latched trip; the hand has to let
  /// go first.
  bool armed = false;
  std::shared_ptr<const ServoScene> scene;  ///< kInsertion without a scene gives no force
  Stimulus stimulus;
  std::uint64_t placement = 0;  ///< a new number starts a new placement: the tube is out, at `start_depth_mm`
  double start_depth_mm = 0;
  AxisMapping axis;  ///< a new axis: the force fades along the old axis and starts along the new one at the next press
  EnableSettings enable;
  LimitSettings limits;
};

}  // namespace tactus::haptics
