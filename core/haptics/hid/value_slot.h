// One number in a HID report: its bits and its range.
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
  std::int64_t physical_min = 0;  ///< both 0: same as the logical range
  std::int64_t physical_max = 0;

  bool operator==(const ValueSlot&) const = default;
};

/// Writes the lowest bits of `value` to `report` (byte 0 is its id). Ignores bits outside the report. Real-time safe:
/// yes.
void putValue(std::span<std::uint8_t> report, const ValueSlot& slot, std::int64_t value) noexcept;

/// The value in `report`, signed if the range is. Bits outside the report count as 0. Real-time safe: yes.
std::int64_t takeValue(std::span<const std::uint8_t> report, const ValueSlot& slot) noexcept;

/// All bits set: `none` or `forever` in PID.
std::int64_t allOnes(const ValueSlot& slot) noexcept;

/// Whether the bits can hold the whole logical range. Real-time safe: yes.
bool rangeFits(const ValueSlot& slot) noexcept;

/// Converts `share` of the range to a raw value, rounded and clamped. A positive share scales the maximum, a negative
/// one the minimum. If the range has no negative part, a negative share gives 0. NaN gives the value nearest to 0.
std::int64_t rawOfShare(const ValueSlot& slot, double share) noexcept;

/// A time as a raw value of a duration field, clamped. A field in seconds uses its exponent; other fields count
/// milliseconds.
std::int64_t rawOfTime(const ValueSlot& slot, double time_s) noexcept;

/// One step of a duration field, s. It follows from the unit, and from the physical range if that differs from the
/// logical one. Without a unit a step is 1 ms. Nothing if the unit is not a time.
std::optional<double> stepOfTime(const ValueSlot& slot) noexcept;

/// An angle, [0, 360), as a raw value of a direction field whose range is one turn.
std::int64_t rawOfAngle(const ValueSlot& slot, double angle_deg) noexcept;

}  // namespace tactus::haptics
