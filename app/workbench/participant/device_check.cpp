#include "app/workbench/participant/device_check.h"

#include <cmath>

namespace tactus::workbench {

bool DeviceCheck::add(std::span<const haptics::Sample> samples) {
  const DeviceStep before = step_;
  for (const haptics::Sample& sample : samples) take(sample);
  return step_ != before;
}

void DeviceCheck::take(const haptics::Sample& sample) {
  const bool holds = sample.enabled;
  seen_open_ = seen_open_ || !holds;
  switch (step_) {
    case DeviceStep::kHold:
      if (holds && seen_open_) {
        step_ = DeviceStep::kStill;
        rest(sample);
      }
      break;
    case DeviceStep::kStill:
      if (!holds) {
        step_ = DeviceStep::kHold;
      } else if (std::abs(sample.position_mm - at_mm_) > kStillMm) {
        rest(sample);
      } else if (static_cast<double>(sample.time_ns - still_since_ns_) * 1e-9 >= kStillS) {
        step_ = DeviceStep::kPush;
        at_mm_ = sample.position_mm;
      }
      break;
    case DeviceStep::kPush:
      if (!holds) {
        step_ = DeviceStep::kHold;
      } else if (sample.position_mm - at_mm_ >= kPushMm) {
        step_ = DeviceStep::kRelease;
      }
      break;
    case DeviceStep::kRelease:
      if (!holds) step_ = DeviceStep::kReady;
      break;
    default:
      break;
  }
}

// The hand is still from here on, as far as is known.
void DeviceCheck::rest(const haptics::Sample& sample) {
  still_since_ns_ = sample.time_ns;
  at_mm_ = sample.position_mm;
}

}  // namespace tactus::workbench
