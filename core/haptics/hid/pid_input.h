// Decodes the input reports of a PID device: position of the handle, pressed buttons, and whether forces can act.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/haptics/hid/pid_layout.h"

namespace tactus::haptics {

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

}  // namespace tactus::haptics
