#include "core/haptics/safety/watchdog.h"

#include "core/render/low_pass.h"

namespace tactus::haptics {
namespace {

constexpr double kStaleConstantS = 0.010;

}  // namespace

Trip overdue(const Ages& ages, const LimitSettings& limits) noexcept {
  // A servo that did not run saw no sample and wrote no force: the other two follow from it.
  if (ages.gap_s > limits.servo_trip_s) return {TripCause::kServoLate, ages.gap_s, limits.servo_trip_s, 0};
  if (ages.sample_s > limits.stale_trip_s) return {TripCause::kDeviceSilent, ages.sample_s, limits.stale_trip_s, 0};
  if (ages.write_s > limits.write_trip_s) return {TripCause::kWriteStuck, ages.write_s, limits.write_trip_s, 0};
  return {};
}

double staleShare(double age_s, const LimitSettings& limits) noexcept {
  if (age_s <= limits.stale_decay_s) return 1;
  if (age_s >= limits.stale_zero_s) return 0;
  const double last = render::decay(limits.stale_zero_s - limits.stale_decay_s, kStaleConstantS);
  return (render::decay(age_s - limits.stale_decay_s, kStaleConstantS) - last) / (1 - last);
}

}  // namespace tactus::haptics
