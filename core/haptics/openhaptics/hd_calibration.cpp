#include "core/haptics/openhaptics/hd_calibration.h"

namespace tactus::haptics {
namespace {

/// The style to update with; 0: none of those known.
std::uint32_t chosenStyle(int styles, bool also_reset) noexcept {
  const auto mask = static_cast<std::uint32_t>(styles);
  if ((mask & hd::kInkwell) != 0) return hd::kInkwell;
  if ((mask & hd::kAutomatic) != 0) return hd::kAutomatic;
  return also_reset && (mask & hd::kEncoderReset) != 0 ? hd::kEncoderReset : 0u;
}

}  // namespace

std::string calibrationAdvice(int styles) {
  switch (chosenStyle(styles, true)) {
    case hd::kInkwell:
      return "put the stylus into the inkwell and leave it there for a second";
    case hd::kAutomatic:
      return "move the stylus slowly through its whole space";
    case hd::kEncoderReset:
      return "hold the stylus in the reference posture of the device's manual and calibrate";
    default:
      return "calibrate it with its maker's program (Touch Setup, Touch Diagnostics)";
  }
}

void HdCalibration::look() noexcept {
  const bool asked = requested_.exchange(false, std::memory_order_relaxed);
  std::uint32_t state = api_->check_calibration();
  const bool offered = state == hd::kNeedsUpdate && !calibrated();
  const std::uint32_t style = asked || offered ? chosenStyle(styles_, asked) : 0u;
  if (style != 0) {
    api_->update_calibration(style);
    state = api_->check_calibration();
  }
  const bool still = calibrated() && state == hd::kNeedsUpdate;
  calibrated_.store(state == hd::kCalibrated || still, std::memory_order_relaxed);
}

}  // namespace tactus::haptics
