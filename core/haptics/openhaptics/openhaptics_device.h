// A haptic device behind OpenHaptics (3D Systems Touch and its relatives). The driver's own scheduler is the servo.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/device/device.h"
#include "core/haptics/openhaptics/hd_api.h"

namespace tactus::haptics {

// The errors of the HD library, sorted by their effect on the force.

/// The fault for one error code. Warm motors and refused forces keep the loop running without force. A lost connection,
/// a dead timer and broken frames end it. Real-time safe: yes.
DeviceFault faultOf(std::uint32_t code) noexcept;
/// Whether the driver's loop cannot continue after this error. Real-time safe: yes.
bool endsLoop(std::uint32_t code) noexcept;

/// All errors that were on the stack.
struct HdErrors {
  int count = 0;
  HdErrorRecord newest;                    ///< the library returns the newest first
  HdErrorRecord gravest;                   ///< the error that determines `fault`
  DeviceFault fault = DeviceFault::kNone;  ///< kLost if one of the errors ends the loop

  bool endsLoop() const noexcept { return fault == DeviceFault::kLost; }
};

/// Empties the error stack. Stops after 64 errors, in case the library never reports "no error". Real-time safe: yes.
HdErrors drainErrors(const HdApi& api) noexcept;

/// A phrase about `error` with the library's own words, e.g. `the motors are too warm (0x0200, internal 7, "...")`.
std::string describe(const HdApi& api, const HdErrorRecord& error);

// The OpenHaptics HD library, loaded at run time: Tactus is built without it and works without it.

/// A loaded library. It stays in the process forever, because libHD cannot be loaded again after closing. Thread: any.
class HdLibrary {
 public:
  /// Loads `path`, or, if it is empty, the first of `defaultNames` that the system's loader finds. Returns an error if
  /// the library, one of its own libraries, or a function is missing. The error names the attempts and the remedy.
  static base::Result<std::shared_ptr<const HdLibrary>> load(const std::string& path = {});

  /// The names to try, in this order.
  static const std::vector<std::string>& defaultNames();

  const HdApi& api() const noexcept { return api_; }
  /// The name or path from which it was loaded.
  const std::string& path() const noexcept { return path_; }

 private:
  HdLibrary() = default;

  HdApi api_;
  std::string path_;
};

/// Describes missing parts of the driver's environment, as far as visible from outside. The sentence names GTDD_HOME,
/// the folder of the device's configuration. Empty if the folder named by GTDD_HOME exists.
std::string hdEnvironmentAdvice();

// Whether the positions of an OpenHaptics device are valid, and how the user calibrates it.

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

struct OpenHapticsSettings {
  std::string name;              ///< name of the device's configuration in Touch Setup; empty: the default device
  unsigned long rate_hz = 1000;  ///< 500, 1000 and 1600 are known to work
  /// The monotonic clock of the ticks, ns; empty: the system's. Must not throw or allocate.
  std::function<std::int64_t()> clock_ns;
  /// Waits about 1 ms while the driver's loop is ending; empty: sleeps.
  std::function<void()> pause;
};

/// Each callback of the driver begins the frame, takes a sample, calls the program's tick, writes the force, ends the
/// frame, and empties the error stack.
/// The force is zero without a tick, during a fault, and for 30 ms before a stop.
/// If the motors are warm, or a force was refused or limited, the program has 30 ms to fade its force, which may only
/// fall in that time. The fault lasts until the program has asked for no force for 0.5 s; then the actuators are
/// switched on again.
/// After a lost connection or a dead timer, one last tick reports it, then the loop ends.
/// Only one process can open the device, and only once.
class OpenHapticsDevice final : public HapticDevice, private DeviceLoop {
 public:
  /// Opens the device and reads its properties; nothing moves. Without a name it tries the default device, then
  /// `Default Device` and `Default PHANToM`, because some installations need these. Returns an error with the driver's
  /// reason and the remedy if there is no device, it is open elsewhere, or its limits are invalid.
  static base::Result<std::unique_ptr<OpenHapticsDevice>> open(std::shared_ptr<const HdLibrary> library,
                                                               OpenHapticsSettings settings = {});
  ~OpenHapticsDevice() override;
  OpenHapticsDevice(const OpenHapticsDevice&) = delete;
  OpenHapticsDevice& operator=(const OpenHapticsDevice&) = delete;

  const DeviceInfo& info() const noexcept override { return info_; }

  /// Calibrates if the device needs no user for it, switches the actuators on and starts the driver's loop. A device
  /// that needs the user for its calibration also starts; it reports DeviceFault::kNotCalibrated and gives no force
  /// until then. Returns the driver's error on failure.
  base::Result<void> start() override;
  /// Takes at most 0.1 s: zero force for 30 ms, loop ended, actuators off. The device can be started again.
  void stop() noexcept override;

  /// For the tick of the loop only.
  DeviceState read(std::int64_t now_ns) noexcept override;
  /// Takes effect only in the tick of the loop; elsewhere the force is zero. A force that is not finite counts as 0. A
  /// force above the device's maximum is shortened to it.
  void write(const Vector3& force_n, std::int64_t now_ns) noexcept override;

  DeviceLoop* ownLoop() noexcept override { return this; }

  /// Thread: any.
  bool calibrated() const noexcept { return calibration_.calibrated(); }
  /// The instruction to the user for the calibration.
  std::string calibrationAdvice() const { return haptics::calibrationAdvice(calibration_.styles()); }
  /// Call when the user holds the device in its reference posture: calibrates in the next frame. Thread: any.
  void requestCalibration() noexcept { calibration_.request(); }
  /// The last error of the driver, as a phrase; empty if there was none. Thread: owner.
  std::optional<std::string> lastError() const;

 private:
  /// The owner of the tick: the program announces itself with kTicking, the driver's thread takes its turn with
  /// kInTick.
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

  // Touched by the driver's thread alone.
  DeviceState state_;
  Vector3 command_;
  double given_n_ = 0;  // length of the force in the last frame
  DeviceFault fault_ = DeviceFault::kNone;
  std::int64_t faulted_ns_ = 0;  // start of the fault
  double fading_n_ = 0;          // the force at that time
  std::int64_t unforced_since_ns_ = 0;
};

}  // namespace tactus::haptics
