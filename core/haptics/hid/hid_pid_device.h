// A force-feedback joystick, board or wheel (HID PID) as a haptic device.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/haptics/device/device.h"
#include "core/haptics/device/device_calibration.h"
#include "core/haptics/hid/hid_transport.h"
#include "core/haptics/hid/newest_value.h"
#include "core/haptics/hid/pid_input.h"
#include "core/haptics/hid/pid_layout.h"
#include "core/haptics/hid/pid_session.h"
#include "core/haptics/hid/pid_writer.h"

namespace tactus::haptics {

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

}  // namespace tactus::haptics
