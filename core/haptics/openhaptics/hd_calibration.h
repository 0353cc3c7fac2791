// Whether the positions of an OpenHaptics device are valid, and how the user calibrates it.
#pragma once

#include <atomic>
#include <string>

#include "core/haptics/openhaptics/hd_api.h"

namespace tactus::haptics {

/// The instruction for calibrating a device with these styles (a mask of hd::CalibrationStyle), in one sentence.
std::string calibrationAdvice(int styles);

/// Tracks the calibration of one device. The driver's loop calls `look`; the owner calls it while no loop runs.
class HdCalibration {
 public:
  HdCalibration(const HdApi& api, int styles) noexcept : api_(&api), styles_(styles) {}

  /// Reads the state from the driver. Changes nothing.
  void see() noexcept { calibrated_.store(api_->check_calibration() == hd::kCalibrated, std::memory_order_relaxed); }

  /// Reads the state from the driver. Accepts an offered calibration if it cannot be wrong: in the inkwell, or by the
  /// device itself. An encoder reset takes the present posture as reference, so it waits for `request`.
  /// Once calibrated, it accepts no further offer, because positions would jump during a session.
  /// Real-time safe: as far as the driver is.
  void look() noexcept;

  /// Call when the user confirms that the device is in its reference posture. The next `look` calibrates. Thread: any.
  void request() noexcept { requested_.store(true, std::memory_order_relaxed); }
  /// Cancels a request from before the start of the device.
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
