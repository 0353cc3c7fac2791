// Constant forces on a PID device: start, update and end, report by report.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/hid/hidapi_transport.h"
#include "core/haptics/hid/pid_layout.h"

namespace tactus::haptics {

/// One effect per force axis. Each has a duration of 90 ms and is restarted every 40 ms, so no force remains if the
/// host dies. The caller passes the time. Thread: writer. Real-time safe: no (a write may block for seconds).
class PidSession {
 public:
  static constexpr double kQuietAfterS = 0.1;  ///< if the host dies, the force ends after this time …
  static constexpr double kDurationS = 0.09;   ///< … which leaves 10 ms for the last start on its way to the device
  /// The time that a command lasts without the host: the duration minus the time since the last start. That start may
  /// be kRestartNs and one round of the writer old.
  static constexpr double kHoldS = 0.04;
  static constexpr std::int64_t kRestartNs = 40'000'000;    ///< below half of the duration: one start may be missed
  static constexpr std::int64_t kRefreshNs = 10'000'000;    ///< an unchanged value is sent again after this time
  static constexpr int kLoadPolls = 60;                     ///< 1 ms apart, like the Linux kernel
  static constexpr std::int64_t kSilentNs = 1'000'000'000;  ///< a device refuses within milliseconds; Linux waits 5 s

  /// `transport`: must outlive the session. `pause(ms)`: waits. `now_ns`: a monotonic clock.
  PidSession(HidTransport& transport, PidLayout layout, std::function<void(int)> pause,
             std::function<std::int64_t()> now_ns);

  /// Resets the device, switches the actuators on, sets full gain, and creates and starts the effects with force 0. On
  /// an error it undoes the steps done. It gives up if the device does not answer the first question.
  base::Result<void> begin(std::int64_t now_ns);

  /// Sends the force as shares of full scale, [-1, 1], for x and y. Larger shares are clamped; NaN counts as 0. Sends
  /// changed or old values and restarts effects that are due. Returns an error if a write fails; the next call sends
  /// all values again.
  base::Result<void> send(const std::array<double, 2>& shares, std::int64_t now_ns);

  /// Sets the force to 0, stops and frees the effects, switches the actuators off. Continues after a failed write,
  /// stops after two in a row. Returns whether all writes succeeded.
  bool leave() noexcept;

  const PidLayout& layout() const { return layout_; }
  /// The blocks of our effects in the device, one per force axis.
  std::vector<std::int64_t> blocks() const;
  /// The start time of the effect started longest ago; 0 without effects.
  std::int64_t startedNs() const;

 private:
  using Done = base::Result<void>;

  struct Effect {
    std::int64_t block = 0;
    std::optional<std::int64_t> sent;  ///< raw magnitude in the device; empty if unknown
    bool turned = false;               ///< direction + 180 degrees
    std::int64_t sent_ns = 0;
    std::int64_t started_ns = 0;
  };

  Done askPool();
  Done control(const std::optional<PidChoice> PidLayout::Control::*what);
  Done createEffect(std::size_t axis, std::int64_t now_ns);
  base::Result<std::int64_t> loadedBlock();
  Done setEffect(std::size_t axis, bool turned);
  Done setMagnitude(Effect& effect, std::int64_t raw, std::int64_t now_ns);
  Done operate(const Effect& effect, const PidChoice& what);
  Done sendAxis(std::size_t axis, double share, std::int64_t now_ns);

  HidTransport& transport_;
  PidLayout layout_;
  std::function<void(int)> pause_;
  std::function<std::int64_t()> now_ns_;
  std::vector<Effect> effects_;
};

}  // namespace tactus::haptics
