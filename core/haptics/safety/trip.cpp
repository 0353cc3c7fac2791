#include "core/haptics/safety/trip.h"

#include "core/base/text.h"
#include "core/haptics/device/device.h"
#include "core/render/renderer_state.h"

namespace tactus::haptics {
namespace {

std::string_view describe(render::Fault fault) noexcept {
  switch (fault) {
    case render::Fault::kPosition: return "a position was not a number, or beyond 1 km";
    case render::Fault::kForce: return "the model's force was not a number";
    case render::Fault::kTime: return "a tick was shorter than a microsecond or longer than a second";
    default: return "for a reason that it does not tell";
  }
}

}  // namespace

std::string_view describe(TripCause cause) noexcept {
  switch (cause) {
    case TripCause::kNone: return "no trip";
    case TripCause::kForceNotFinite: return "the force was not a finite number";
    case TripCause::kPositionNotFinite: return "the position was not a finite number";
    case TripCause::kTooFastInwards: return "the hand moved inwards too fast";
    case TripCause::kTooFastOutwards: return "the hand moved outwards too fast";
    case TripCause::kDeviceSilent: return "the device sent no sample for too long";
    case TripCause::kWriteStuck: return "no force reached the device for too long";
    case TripCause::kServoLate: return "the servo missed ticks for too long";
    case TripCause::kDeviceLost: return "the device is gone";
    case TripCause::kDeviceFault: return "the device reports a fault";
    case TripCause::kRenderer: return "the renderer let go";
    case TripCause::kStopped: return "Stop was pressed";
  }
  return "unknown trip";
}

std::string_view unitOf(TripCause cause) noexcept {
  switch (cause) {
    case TripCause::kTooFastInwards:
    case TripCause::kTooFastOutwards: return "mm/s";
    case TripCause::kDeviceSilent:
    case TripCause::kWriteStuck:
    case TripCause::kServoLate: return "s";
    default: return "";
  }
}

std::string sentence(const Trip& trip) {
  std::string text(describe(trip.cause));
  if (trip.cause == TripCause::kDeviceFault)
    return std::string(describe(static_cast<DeviceFault>(static_cast<int>(trip.value))));
  if (trip.cause == TripCause::kRenderer)
    return text + ": " + std::string(describe(static_cast<render::Fault>(static_cast<int>(trip.value))));
  const std::string_view unit = unitOf(trip.cause);
  if (unit.empty()) return text;
  const int decimals = unit == "s" ? 3 : 0;
  text += ": " + base::formatFixed(trip.value, decimals) + ' ' + std::string(unit);
  return text + ", allowed " + base::formatFixed(trip.limit, decimals) + ' ' + std::string(unit);
}

}  // namespace tactus::haptics
