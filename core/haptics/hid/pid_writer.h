// The writer thread of a PID device: converts the newest command in N to reports.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "core/haptics/device/device_calibration.h"
#include "core/haptics/device/vector3.h"
#include "core/haptics/hid/newest_value.h"
#include "core/haptics/hid/pid_session.h"

namespace tactus::haptics {

/// A force as commanded by the servo.
struct PidCommand {
  Vector3 force_n;
  std::int64_t time_ns = 0;
  bool valid = false;  ///< false: no command yet
};

/// Converts the HID axes to the device's frame: X points right, Y toward the user, Z down (HID 1.11, 5.9).
constexpr std::array<double, 3> hidAxesOf(const Vector3& v) noexcept { return {v.x, v.z, -v.y}; }
constexpr Vector3 fromHidAxes(const std::array<double, 3>& axes) noexcept { return {axes[0], -axes[2], axes[1]}; }

/// Sends the newest command only. If it is older than PidSession::kHoldS, the servo is gone: the force falls linearly
/// to zero within kLetGoS, because a cut is felt as a kick. Thread: writer, except for the command box.
class PidWriter {
 public:
  static constexpr double kLetGoS = 0.005;

  /// `driven_share`: (0, 1], cosine of the angle between insertion axis and motors. A force along the axis loses this
  /// factor on the way to the motors and again on the way back, so it is divided by its square.
  PidWriter(PidSession& session, const DeviceCalibration& calibration, double driven_share = 1)
      : session_(session),
        full_scale_n_(driven_share * driven_share * calibration.full_scale_n),
        sign_(calibration.force_sign) {}

  /// The command box: the servo stores its commands here.
  NewestValue<PidCommand>& commands() { return commands_; }

  /// One round. Returns an error if a report failed; the next round sends all values again.
  base::Result<void> step(std::int64_t now_ns);

  /// Whether the newest command must be sent again, because the device is about to drop its force. Real-time safe: yes.
  bool letsGo(std::int64_t now_ns) const noexcept;

  /// The force of the command as shares of full scale, clamped. A force that is not finite counts as 0.
  std::array<double, 2> sharesOf(const Vector3& force_n) const;

 private:
  NewestValue<PidCommand> commands_;
  PidSession& session_;
  double full_scale_n_;  ///< the commanded force whose driven part is the device's largest value
  Vector3 sign_;
  std::int64_t command_ns_ = 0;  ///< time of the newest command taken
  bool let_go_ = true;           ///< the command no longer has a force
};

}  // namespace tactus::haptics
