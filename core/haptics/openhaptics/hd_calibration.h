// Whether the positions of an OpenHaptics device mean something, and what a person has to do until they do.
#pragma once

#include <atomic>
#include <string>

#include "core/haptics/openhaptics/hd_api.h"

namespace tactus::haptics {

/// What a person has to do to calibrate a device with these styles (a mask of hd::CalibrationStyle): one sentence.
std::string calibrationAdvice(int styles);

/// Follows the calibration of one device. `look` belongs to the driver's loop, or to the owner while no loop runs.
class HdCalibration {
 public:
  HdCalibration(const HdApi& api, int styles) noexcept : api_(&api), styles_(styles) {}

  /// Asks the driver and changes nothing.
  void see() noexcept { calibrated_.store(api_->check_calibration() == hd::kCalibrated, std::memory_order_relaxed); }

  /// Asks the driver; takes over a calibration that it offers where this cannot be wrong: in the inkwell, or by the
  /// device itself. An encoder reset takes the present posture for the reference, so it waits for `request`.
  /// Once calibrated, a further offer is not taken: positions would jump in the middle of a session.
  /// Real-time safe: as far as the driver is.
  void look() noexcept;

  /// A person says that the device is in its reference posture: the next `look` calibrates. Thread: any.
  void request() noexcept { requested_.store(true, std::memory_order_relaxed); }
  /// What was said before the device was started holds no more.
  void forgetRequest() noexcept { requested_.store(false, std::memory_order_relaxed); }
  /// Thread: any. Real-time safe: yes.
  bool calibrated() const noexcept { return calibrated_.load(std::memory_order_relaxed); }
  bool requested() const noexcept { return requested_.load(std::memory_order_relaxed); }

  int styles() const noexcept { return styles_; }

 private:
  const HdApi* api_;
  int styles_;
  std::atomic<bool> calibrated_{false};
  std::atomic<bool> requested_{false};
};

}  // namespace tactus::haptics
