// What the writer thread of a PID device does: newtons of the newest command into reports.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "core/haptics/device/device_calibration.h"
#include "core/haptics/device/vector3.h"
#include "core/haptics/hid/newest_value.h"
#include "core/haptics/hid/pid_session.h"

namespace tactus::haptics {

/// A force as the servo asked for it.
struct PidCommand {
  Vector3 force_n;
  std::int64_t time_ns = 0;
  bool valid = false;  ///< false: there was none yet
};

/// The HID axes in the device's frame: X points right, Y towards the person, Z down (HID 1.11, 5.9).
constexpr std::array<double, 3> hidAxesOf(const Vector3& v) noexcept { return {v.x, v.z, -v.y}; }
constexpr Vector3 fromHidAxes(const std::array<double, 3>& axes) noexcept { return {axes[0], -axes[2], axes[1]}; }

/// Sends only the newest command. One older than PidSession::kHoldS means that the servo is gone: its force goes to
/// nothing within kLetGoS, evenly, because a cut is felt as a kick.
/// Thread: writer, but for the command box.
class PidWriter {
 public:
  static constexpr double kLetGoS = 0.005;

  /// `driven_share`, (0, 1]: cosine between the insertion axis and the motors. A force along the axis loses that factor
  /// on the way to the motors and once more on the way back, so it is divided by its square.
  PidWriter(PidSession& session, const DeviceCalibration& calibration, double driven_share = 1)
      : session_(session),
        full_scale_n_(driven_share * driven_share * calibration.full_scale_n),
        sign_(calibration.force_sign) {}

  /// The servo puts its commands here.
  NewestValue<PidCommand>& commands() { return commands_; }

  /// One round. An error: a report did not get through; the next round sends anew.
  base::Result<void> step(std::int64_t now_ns);

  /// The newest command has to be sent again, because it loses its force. Real-time safe: yes.
  bool letsGo(std::int64_t now_ns) const noexcept;

  /// The force of the command as shares of full scale, clamped; not finite means none.
  std::array<double, 2> sharesOf(const Vector3& force_n) const;

 private:
  NewestValue<PidCommand> commands_;
  PidSession& session_;
  double full_scale_n_;  ///< the asked force whose driven part is the device's largest value
  Vector3 sign_;
  std::int64_t command_ns_ = 0;  ///< time of the newest command taken
  bool let_go_ = true;           ///< it has no force any more
};

}  // namespace tactus::haptics
