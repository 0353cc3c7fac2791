// A haptic device behind OpenHaptics (3D Systems Touch and its relatives). The driver's own scheduler is the servo.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/haptics/device/device.h"
#include "core/haptics/openhaptics/hd_calibration.h"
#include "core/haptics/openhaptics/hd_error.h"
#include "core/haptics/openhaptics/hd_library.h"

namespace tactus::haptics {

struct OpenHapticsSettings {
  std::string name;              ///< configuration of the device as in Touch Setup; empty: the default device
  unsigned long rate_hz = 1000;  ///< 500, 1000 and 1600 are known to work
  /// The monotonic clock of the ticks, ns; empty: the system's. Must not throw or allocate.
  std::function<std::int64_t()> clock_ns;
  /// Lets about 1 ms pass while the driver's loop is waited for; empty: sleeps.
  std::function<void()> pause;
};

/// In each callback of the driver: begin the frame, take a sample, tick the program, write the force, end the frame,
/// empty the error stack. Force is zero while nobody ticks, while the device has a fault, and for 30 ms before it is
/// stopped. Where motors are warm, or a force was refused or limited, the program has 30 ms to fade its force, which
/// meanwhile may only fall; the fault stays until the program has asked for no force for 0.5 s, then the actuators are
/// switched on again. A lost connection or a dead timer: one last tick says so, then the loop
/// ends.
/// Only one process can have the device open, and this process only once.
class OpenHapticsDevice final : public HapticDevice, private DeviceLoop {
 public:
  /// Opens the device and reads what it is; nothing moves. Without a name the default device and, because some
  /// installations need them, the names `Default Device` and `Default PHANToM` are tried. Refused, with the driver's
  /// reason and what to do: no device, it is open elsewhere, limits that make no sense.
  static base::Result<std::unique_ptr<OpenHapticsDevice>> open(std::shared_ptr<const HdLibrary> library,
                                                               OpenHapticsSettings settings = {});
  ~OpenHapticsDevice() override;
  OpenHapticsDevice(const OpenHapticsDevice&) = delete;
  OpenHapticsDevice& operator=(const OpenHapticsDevice&) = delete;

  const DeviceInfo& info() const noexcept override { return info_; }

  /// Calibrates where the device can do so alone, switches the actuators on and starts the driver's loop. A device that
  /// waits for a person to calibrate it starts too: it reports DeviceFault::kNotCalibrated and gives no force until
  /// then. Refused: what the driver says.
  base::Result<void> start() override;
  /// At most 0.1 s: zero force for 30 ms, loop ended, actuators off. It can be started again.
  void stop() noexcept override;

  /// For the loop's tick only.
  DeviceState read(std::int64_t now_ns) noexcept override;
  /// In the loop's tick; elsewhere it does nothing, because the force is zero there. Not finite is no force; longer
  /// than the device's largest force is shortened to it.
  void write(const Vector3& force_n, std::int64_t now_ns) noexcept override;

  DeviceLoop* ownLoop() noexcept override { return this; }

  /// Thread: any.
  bool calibrated() const noexcept { return calibration_.calibrated(); }
  /// What a person has to do to calibrate it.
  std::string calibrationAdvice() const { return haptics::calibrationAdvice(calibration_.styles()); }
  /// A person holds the device in its reference posture: calibrates in the next frame. Thread: any.
  void requestCalibration() noexcept { calibration_.request(); }
  /// The last error of the driver, as a sentence part; nothing: there was none. Thread: owner.
  std::optional<std::string> lastError() const;

 private:
  /// Who may be in a tick: a program announces itself with kTicking, the driver's thread takes the turn with kInTick.
  enum class Turn : std::uint8_t { kIdle, kTicking, kInTick };

  OpenHapticsDevice(std::shared_ptr<const HdLibrary> library, HdHandle handle, DeviceInfo info, int styles,
                    OpenHapticsSettings settings);

  base::Result<void> run(Ticked& ticked) override;
  void end() noexcept override;

  static std::uint32_t onFrame(void* self) noexcept { return static_cast<OpenHapticsDevice*>(self)->frame(); }
  std::uint32_t frame() noexcept;
  void sample(std::int64_t now_ns) noexcept;
  bool tickProgram(std::int64_t now_ns) noexcept;
  Vector3 allowedForce(bool ticked, std::int64_t now_ns) const noexcept;
  void heed(const HdErrors& errors, std::int64_t now_ns) noexcept;
  void recover(std::int64_t now_ns) noexcept;
  void waitForQuiet() noexcept;
  HdErrors startDriver();
  void haltDriver() noexcept;

  std::shared_ptr<const HdLibrary> library_;
  const HdApi& api_;
  HdHandle handle_;
  DeviceInfo info_;
  OpenHapticsSettings settings_;
  HdCalibration calibration_;
  HdSchedule schedule_ = 0;
  bool scheduled_ = false;
  bool started_ = false;
  Ticked* ticked_ = nullptr;  // changed only while the turn is kIdle

  std::atomic<Turn> turn_{Turn::kIdle};
  std::atomic<bool> stopping_{false};
  std::atomic<int> quiet_frames_{0};  // frames with zero force since stopping_ was set
  std::atomic<bool> loop_over_{false};
  std::atomic<std::uint32_t> last_error_{0};
  std::atomic<std::int32_t> last_internal_{0};

  // The driver's thread alone.
  DeviceState state_;
  Vector3 command_;
  double given_n_ = 0;  // length of the force in the last frame
  DeviceFault fault_ = DeviceFault::kNone;
  std::int64_t faulted_ns_ = 0;  // since when it has one
  double fading_n_ = 0;          // the force at that time
  std::int64_t unforced_since_ns_ = 0;
};

}  // namespace tactus::haptics
