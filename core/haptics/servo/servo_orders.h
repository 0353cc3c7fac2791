// What the program tells the servo. A new set of orders is handed over whole; the next tick uses it.
#pragma once

#include <cstdint>
#include <memory>

#include "core/haptics/device/axis_mapping.h"
#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/sources/force_source.h"
#include "core/haptics/sources/servo_scene.h"

namespace tactus::haptics {

/// Immutable once posted. Only what differs from the orders before has an effect: posting the same again changes
/// nothing.
struct ServoOrders {
  ForceSource source = ForceSource::kOff;
  /// Forces are possible. From false to true: fade-in, and a latched trip is cleared; the hand has to let go first.
  bool armed = false;
  std::shared_ptr<const ServoScene> scene;  ///< kInsertion without a scene gives no force
  Stimulus stimulus;
  std::uint64_t placement = 0;  ///< another number begins another placement: the tube is out, at `start_depth_mm`
  double start_depth_mm = 0;
  AxisMapping axis;  ///< another one: the force lets go along the old axis, and begins along this at the next press
  EnableSettings enable;
  LimitSettings limits;
};

}  // namespace tactus::haptics
