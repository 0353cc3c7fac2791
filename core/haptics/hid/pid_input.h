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
  bool forces_held_back = false;   ///< actuators off, paused, or a switch open
};

/// Keeps the newest sample. Thread: reader. Real-time safe: yes.
class PidInput {
 public:
  /// `layout` must outlive the object.
  explicit PidInput(const PidLayout& layout) : layout_(layout) {}

  /// Takes one input report. True: it changed the sample or renewed it.
  bool take(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept;
  /// The device keeps silent while nothing changes, and it is known to be there: the sample holds still.
  void renew(std::int64_t now_ns) noexcept { sample_.time_ns = now_ns; }

  const PidSample& sample() const noexcept { return sample_; }

 private:
  void takeState(std::span<const std::uint8_t> report) noexcept;

  const PidLayout& layout_;
  PidSample sample_;
  // Firmwares without these switches leave the bits at 0 for ever, so a 0 counts only after a 1.
  bool had_switch_ = false;
  bool had_power_ = false;
};

}  // namespace tactus::haptics
