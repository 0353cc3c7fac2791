// What the input reports of a PID device say: where the handle is, which buttons are down, whether forces can act.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/haptics/hid/pid_layout.h"

namespace tactus::haptics {

/// One sample in the device's own units.
struct PidSample {
  std::uint64_t number = 0;        ///< counts the reports with a position
  std::int64_t time_ns = 0;        ///< when the last of them arrived
  std::array<double, 3> counts{};  ///< x, y, z; 0 in the middle of the range
  std::uint32_t buttons = 0;       ///< bit 0 is button 1
  bool forces_held_back = false;   ///< actuators off, paused, a switch open, or an effect stopped by somebody else
};

/// Keeps the newest sample. Thread: reader. Real-time safe: yes.
class PidInput {
 public:
  /// An effect that was started plays so soon, and the device has said it. Longer leaves more time without a force that
  /// nobody notices; shorter blames a device that is slow to tell.
  static constexpr std::int64_t kSettleNs = 20'000'000;

  /// `layout` must outlive the object. `blocks`: those of our effects, at most two; empty: nobody watches them.
  explicit PidInput(const PidLayout& layout, std::span<const std::int64_t> blocks = {});

  /// Takes one input report. True: it changed the sample or renewed it.
  bool take(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept;
  /// Our effects were last started at `started_ns` and play for `duration_ns`. One that the device does not call
  /// playing meanwhile was stopped by another program or by the device: the forces are held back until it plays again.
  /// Firmwares that never call an effect playing are believed to play it. True: it changed the sample.
  bool watchEffects(std::int64_t now_ns, std::int64_t started_ns, std::int64_t duration_ns) noexcept;
  /// The device keeps silent while nothing changes, and it is known to be there: the sample holds still.
  void renew(std::int64_t now_ns) noexcept { sample_.time_ns = now_ns; }

  const PidSample& sample() const noexcept { return sample_; }

 private:
  /// What the device says of one of our effects.
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
  bool switched_off_ = false;    ///< as the state report says
  bool effect_stopped_ = false;  ///< an effect of ours does not play though it should
  // Firmwares without these switches leave the bits at 0 for ever, so a 0 counts only after a 1.
  bool had_switch_ = false;
  bool had_power_ = false;
};

}  // namespace tactus::haptics
