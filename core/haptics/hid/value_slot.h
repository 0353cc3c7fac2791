// One number inside a HID report: where its bits lie and what range it has.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace tactus::haptics {

struct ValueSlot {
  std::uint32_t bit_offset = 0;  ///< bit 0 is the lowest bit of the byte after the report id
  std::uint32_t bit_size = 0;    ///< 1 to 32
  std::int64_t logical_min = 0;
  std::int64_t logical_max = 0;
  int unit_exponent = 0;
  std::uint32_t unit = 0;
  std::int64_t physical_min = 0;  ///< both 0: as the logical range
  std::int64_t physical_max = 0;

  bool operator==(const ValueSlot&) const = default;
};

/// Puts the lowest bits of `value` into `report` (byte 0 is its id). Bits outside the report are left out.
/// Real-time safe: yes.
void putValue(std::span<std::uint8_t> report, const ValueSlot& slot, std::int64_t value) noexcept;

/// The value in `report`, with a sign where the range has one; bits outside the report are 0. Real-time safe: yes.
std::int64_t takeValue(std::span<const std::uint8_t> report, const ValueSlot& slot) noexcept;

/// All bits set: for PID `none` or `for ever`.
std::int64_t allOnes(const ValueSlot& slot) noexcept;

/// Whether all of the logical range fits into the bits. Real-time safe: yes.
bool rangeFits(const ValueSlot& slot) noexcept;

/// `share` of the range as a raw value, rounded and clamped: by the maximum for positive shares and by the minimum for
/// negative ones; where the range has no negative part 0 is the minimum. Not a number gives the value nearest to 0.
std::int64_t rawOfShare(const ValueSlot& slot, double share) noexcept;

/// A time as a raw value of a duration field, clamped. Fields in seconds use their exponent, others count milliseconds.
std::int64_t rawOfTime(const ValueSlot& slot, double time_s) noexcept;

/// One step of a duration field, s: by its unit, and by its physical range where that is another one than the logical
/// range. Nothing: its unit is no time. Without a unit a step is a millisecond.
std::optional<double> stepOfTime(const ValueSlot& slot) noexcept;

/// An angle, [0, 360), as a raw value of a direction field whose range is one turn.
std::int64_t rawOfAngle(const ValueSlot& slot, double angle_deg) noexcept;

}  // namespace tactus::haptics
