// Constant forces on a PID device: how they begin, run and end, report by report.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/hid/hid_transport.h"
#include "core/haptics/hid/pid_layout.h"

namespace tactus::haptics {

/// One effect per axis of force. Each has a duration of 90 ms and is started again every 40 ms, so a host that dies
/// leaves no force behind. Time is passed in. Thread: writer. Real-time safe: no (a write may block for seconds).
class PidSession {
 public:
  static constexpr double kQuietAfterS = 0.1;  ///< a dead host means no force after this time …
  static constexpr double kDurationS = 0.09;   ///< … with 10 ms for the last start on its way to the device
  /// A command lasts for so long, whatever the host does: the duration less the time since the last start, which may be
  /// kRestartNs and a round of the writer ago.
  static constexpr double kHoldS = 0.04;
  static constexpr std::int64_t kRestartNs = 40'000'000;    ///< longer than half of the duration would forgive no miss
  static constexpr std::int64_t kRefreshNs = 10'000'000;    ///< a value that did not change is sent again after this
  static constexpr int kLoadPolls = 60;                     ///< 1 ms apart, as the Linux kernel does
  static constexpr std::int64_t kSilentNs = 1'000'000'000;  ///< a device refuses in milliseconds; Linux waits 5 s

  /// `transport` must outlive the session. `pause(ms)` waits; `now_ns` is a monotonic clock.
  PidSession(HidTransport& transport, PidLayout layout, std::function<void(int)> pause,
             std::function<std::int64_t()> now_ns);

  /// Reset, actuators on, full gain, effects created and started with force 0. On an error what was begun is ended. A
  /// device that lets the first question go unanswered is given up.
  base::Result<void> begin(std::int64_t now_ns);

  /// The force as shares of full scale, -1..1, x and y; beyond is clamped, not a number is 0. Sends what changed or is
  /// old, and restarts effects that are due. An error: one of the writes failed; the next call sends anew.
  base::Result<void> send(const std::array<double, 2>& shares, std::int64_t now_ns);

  /// Force 0, effects stopped and freed, actuators off. Goes on after a failed write, gives up after two in a row.
  /// Returns whether everything was written.
  bool leave() noexcept;

  const PidLayout& layout() const { return layout_; }
  /// Blocks of our effects in the device, one per axis of force.
  std::vector<std::int64_t> blocks() const;
  /// When the effect that was started longest ago was started; 0 without effects.
  std::int64_t startedNs() const;

 private:
  using Done = base::Result<void>;

  struct Effect {
    std::int64_t block = 0;
    std::optional<std::int64_t> sent;  ///< raw magnitude in the device; nothing: not known
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
