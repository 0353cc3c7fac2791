// A force-feedback joystick, board or wheel (HID PID) as a haptic device.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/device/calibration_file.h"
#include "core/haptics/device/device.h"
#include "core/haptics/device/device_threads.h"
#include "core/haptics/hid/hidapi_transport.h"
#include "core/haptics/hid/pid_layout.h"
#include "core/haptics/hid/pid_session.h"

namespace tactus::haptics {

// Decodes the input reports of a PID device: position of the handle, pressed buttons, and whether forces can act.

/// One sample in the device's own units.
struct PidSample {
  std::uint64_t number = 0;        ///< number of reports with a position so far
  std::int64_t time_ns = 0;        ///< arrival time of the last of them
  std::array<double, 3> counts{};  ///< x, y, z; 0 in the middle of the range
  std::uint32_t buttons = 0;       ///< bit 0 is button 1
  bool forces_held_back = false;   ///< actuators off, paused, a switch open, or an effect stopped by another program
};

/// Keeps the newest sample. Thread: reader. Real-time safe: yes.
class PidInput {
 public:
  /// Longest time from the start of an effect until the device reports it as playing. A longer limit leaves more time
  /// without a force before it is detected; a shorter one blames a device that reports late.
  static constexpr std::int64_t kSettleNs = 20'000'000;

  /// `layout`: must outlive the object. `blocks`: the blocks of our effects, at most two; empty: they are not
  /// monitored.
  explicit PidInput(const PidLayout& layout, std::span<const std::int64_t> blocks = {});

  /// Decodes one input report. Returns true if it changed or renewed the sample.
  bool take(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept;
  /// Call after a start of our effects. They started at `started_ns` and play for `duration_ns`. If the device does not
  /// report one as playing in that time, another program or the device has stopped it; forces are then held back until
  /// it plays again. A firmware that never reports an effect as playing is assumed to play it. Returns true if the
  /// sample changed.
  bool watchEffects(std::int64_t now_ns, std::int64_t started_ns, std::int64_t duration_ns) noexcept;
  /// Call if the device is connected but silent because nothing changes: renews the sample.
  void renew(std::int64_t now_ns) noexcept { sample_.time_ns = now_ns; }

  const PidSample& sample() const noexcept { return sample_; }

 private:
  /// The reported state of one of our effects.
  struct Effect {
    std::int64_t block = 0;
    bool had_played = false;
    bool plays = false;
  };

  void takeState(std::span<const std::uint8_t> report) noexcept;
  void takePlaying(std::span<const std::uint8_t> report) noexcept;

  const PidLayout& layout_;
  PidSample sample_;
  std::array<Effect, 2> effects_{};
  std::size_t effect_count_ = 0;
  bool switched_off_ = false;    ///< from the state report
  bool effect_stopped_ = false;  ///< one of our effects does not play although it should
  // A firmware without these switches leaves the bits at 0 forever. So a 0 counts only after a 1.
  bool had_switch_ = false;
  bool had_power_ = false;
};

// The writer thread of a PID device: converts the newest command in N to reports.

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

/// Identity of a device, from the list of HID devices.
struct HidIdentity {
  std::string id;  ///< `hid:1209:ffb0`, followed by `:serial` if there is a serial number
  std::string name;
  std::string serial;
};

/// Time functions of the device, replaced in tests.
struct HidPidTiming {
  std::function<std::int64_t()> now_ns;        ///< the clock that the loop passes to `read`; default: monotonic
  std::function<void(std::int64_t ns)> pause;  ///< default: sleeps
};

/// Counts of the traffic so far.
struct HidPidCounters {
  std::uint64_t reports = 0;        ///< input reports
  std::uint64_t rounds = 0;         ///< successful rounds of the writer
  std::uint64_t failed_rounds = 0;  ///< rounds in which a report failed
  std::int64_t longest_round_ns = 0;
};

/// The servo thread touches atomics only. A reader thread keeps the newest sample, and a writer thread sends the newest
/// force. The servo and these threads never wait for each other.
/// Without a calibration, positions are counts, 1 N is full scale, and the state is kNotCalibrated. With one, a force
/// along the insertion axis acts along it, even if the axis is inclined to the motors by some degrees.
class HidPidDevice final : public HapticDevice {
 public:
  /// Reads the descriptor. Returns an error if the device is not a PID device or lacks a required report, or if the
  /// insertion axis of the calibration has less than kLeastDrivenShare along the motors.
  static base::Result<std::unique_ptr<HidPidDevice>> open(std::unique_ptr<HidTransport> transport,
                                                          const HidIdentity& identity,
                                                          const std::optional<DeviceCalibration>& calibration = {},
                                                          HidPidTiming timing = {});
  ~HidPidDevice() override;

  const DeviceInfo& info() const noexcept override { return info_; }
  const PidLayout& layout() const noexcept { return layout_; }

  base::Result<void> start() override;
  /// Blocks while a write to the device blocks. The effects end long before that.
  void stop() noexcept override;

  DeviceState read(std::int64_t now_ns) noexcept override;
  void write(const Vector3& force_n, std::int64_t now_ns) noexcept override;

  /// Thread: any.
  HidPidCounters counters() const noexcept;

 private:
  HidPidDevice(std::unique_ptr<HidTransport> transport, PidLayout layout, HidPidTiming timing);
  void describe(const HidIdentity& identity, const std::optional<DeviceCalibration>& calibration);
  void dropWaitingReports();
  void readerLoop(const std::vector<std::int64_t>& blocks);
  void writerLoop();
  bool drain(PidInput& input, std::span<std::uint8_t> room);
  bool writerRound();

  std::unique_ptr<HidTransport> transport_;
  const PidLayout layout_;
  HidPidTiming timing_;
  DeviceInfo info_;
  DeviceCalibration calibration_;
  bool calibrated_ = false;
  double driven_share_ = 1;  ///< of the insertion axis

  std::optional<PidSession> session_;  ///< touched by the owner; by the writer between start and stop
  std::optional<PidWriter> writer_;    ///< as `session_`, except for its command box
  NewestValue<PidSample> samples_;     ///< from the reader to the servo
  std::atomic<bool> lost_{false};
  std::atomic<bool> reader_ends_{false};
  std::atomic<bool> writer_ends_{false};
  std::atomic<std::int64_t> written_ns_{0};
  std::atomic<std::int64_t> started_ns_{0};  ///< start of the effects, as last confirmed by the writer
  std::atomic<std::uint64_t> reports_{0};
  std::atomic<std::uint64_t> rounds_{0};
  std::atomic<std::uint64_t> failed_rounds_{0};
  std::atomic<std::int64_t> longest_round_ns_{0};
  std::thread reader_;
  std::thread writer_thread_;
};

// The HID devices of this computer with force feedback, and the reason if one cannot be used.

/// Haptic devices without HID force feedback, listed by USB ids, with advice for each.
struct KnownDevice {
  std::string_view name;
  std::string_view advice;         ///< the reason why it is not a PID device, and the remedy; one or two sentences
  bool game_devices_only = false;  ///< the manufacturer also sells mice etc.: match joysticks and wheels only
};

/// The entry of a device that HID PID cannot reach, or nothing. Some of these are not HID devices at all.
std::optional<KnownDevice> knownDevice(std::uint16_t vendor, std::uint16_t product) noexcept;

enum class HidDeviceKind : std::uint8_t {
  kPid,    ///< force feedback by HID PID
  kKnown,  ///< a haptic device that needs another driver
  kOther,  ///< a mouse, a keyboard, …
};

struct HidDevice {
  std::string path;  ///< the argument of HidapiTransport::open; empty if the device is not a HID device
  HidIdentity identity;
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  HidDeviceKind kind = HidDeviceKind::kOther;
  std::string problem;  ///< the reason why it cannot be used now; empty if it can
  std::string advice;   ///< the remedy
  std::string used_by;  ///< another program that has it open, e.g. `tactus (process 4711)`; empty if none is known
};

/// The id of a device: `hid:1209:ffb0`, followed by `:serial` if there is a serial number.
std::string hidDeviceId(std::uint16_t vendor, std::uint16_t product, const std::string& serial);

/// Fills in `kind`, `problem` and `advice`. The descriptor identifies a PID device, regardless of its ids. The ids
/// identify other devices.
void judge(HidDevice& device, const base::Result<std::vector<std::uint8_t>>& descriptor, bool may_open);

/// The product name, in UTF-8, that the kernel stores for the node `path` (`/dev/hidraw3`), in any locale. It is the
/// name of the USB device, or else of the HID device. Empty if there is none.
std::string nameOfNode(const std::string& path, const std::string& system_folder = "/sys/class/hidraw");
/// The serial number of the node, in the same way.
std::string serialOfNode(const std::string& path, const std::string& system_folder = "/sys/class/hidraw");

/// Marks a usable device as in use by `holder`. No effect if this program is the holder.
void noteHolder(HidDevice& device, const std::optional<NodeHolder>& holder);

/// Lists each node once, although hidapi lists one entry per collection. Leaves out kOther unless `all`. The last
/// entries are known haptic devices on USB that are not HID devices. Thread: one at a time (hidapi).
std::vector<HidDevice> listHidDevices(bool all = false);

/// The known haptic devices among the USB devices under `folder` (/sys/bus/usb/devices). Empty if the folder cannot be
/// read.
std::vector<HidDevice> knownUsbDevices(const std::string& folder);

}  // namespace tactus::haptics
