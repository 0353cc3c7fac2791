// The device check before the first insertion: hold the handle, keep still, push gently, let go. No force is given.
#pragma once

#include <cstdint>
#include <span>

#include "app/workbench/participant/participant_state.h"
#include "core/haptics/servo/sample.h"

namespace tactus::workbench {

/// The handle must be let go before it counts as held, so a stuck button is found. Plain state. Thread: gui.
class DeviceCheck {
 public:
  static constexpr double kStillS = 1;   ///< long enough to see drift, short enough not to tire her
  static constexpr double kStillMm = 3;  ///< more than tremor and the play of the handle
  static constexpr double kPushMm = 20;  ///< as in the self-test: a movement that no drift reaches

  void begin() { *this = {}; }
  /// All samples, oldest first. Returns whether the step changed.
  bool add(std::span<const haptics::Sample> samples);

  /// What to do now: kHold, kStill, kPush, kRelease or kReady.
  DeviceStep step() const { return step_; }

 private:
  void take(const haptics::Sample& sample);
  void rest(const haptics::Sample& sample);

  DeviceStep step_ = DeviceStep::kHold;
  bool seen_open_ = false;
  std::int64_t still_since_ns_ = 0;
  double at_mm_ = 0;  ///< where the hand began to be still, or the push began
};

}  // namespace tactus::workbench
