#include "core/haptics/hid/value_slot.h"

#include <algorithm>
#include <cmath>

namespace tactus::haptics {
namespace {

/// The exponents of a unit (USB HID 1.11, 6.2.2.7): time to the power of 1, and nothing else.
constexpr std::uint32_t kTime = 0x1000;

/// Seconds in any of the four systems of units.
bool isSeconds(std::uint32_t unit) noexcept {
  return (unit & ~0xFU) == kTime && (unit & 0xFU) >= 1 && (unit & 0xFU) <= 4;
}

std::int64_t rounded(double value, const ValueSlot& slot) noexcept {
  const auto low = static_cast<double>(slot.logical_min);
  const auto high = static_cast<double>(slot.logical_max);
  return static_cast<std::int64_t>(std::clamp(std::round(value), low, high));
}

}  // namespace

void putValue(std::span<std::uint8_t> report, const ValueSlot& slot, std::int64_t value) noexcept {
  const auto bits = static_cast<std::uint64_t>(value);
  for (std::uint32_t i = 0; i < slot.bit_size; ++i) {
    const std::size_t byte = 1 + (slot.bit_offset + i) / 8;
    if (byte >= report.size()) return;
    const auto mask = static_cast<std::uint8_t>(1U << ((slot.bit_offset + i) % 8));
    const bool set = (bits >> i & 1U) != 0;
    report[byte] = static_cast<std::uint8_t>(set ? report[byte] | mask : report[byte] & ~mask);
  }
}

std::int64_t takeValue(std::span<const std::uint8_t> report, const ValueSlot& slot) noexcept {
  std::uint64_t bits = 0;
  for (std::uint32_t i = 0; i < slot.bit_size; ++i) {
    const std::size_t byte = 1 + (slot.bit_offset + i) / 8;
    if (byte >= report.size()) break;
    if ((report[byte] >> ((slot.bit_offset + i) % 8) & 1U) != 0) bits |= std::uint64_t{1} << i;
  }
  if (slot.bit_size == 0 || slot.logical_min >= 0) return static_cast<std::int64_t>(bits);
  const std::uint64_t sign = std::uint64_t{1} << (slot.bit_size - 1);
  return static_cast<std::int64_t>(bits) - static_cast<std::int64_t>(2 * (bits & sign));
}

std::int64_t allOnes(const ValueSlot& slot) noexcept { return (std::int64_t{1} << slot.bit_size) - 1; }

std::int64_t rawOfShare(const ValueSlot& slot, double share) noexcept {
  if (std::isnan(share)) share = 0;
  share = std::clamp(share, -1.0, 1.0);
  const auto low = static_cast<double>(slot.logical_min);
  const auto high = static_cast<double>(slot.logical_max);
  if (slot.logical_min >= 0) return rounded(low + std::max(share, 0.0) * (high - low), slot);
  return rounded(share >= 0 ? share * high : -share * low, slot);
}

bool rangeFits(const ValueSlot& slot) noexcept {
  const bool with_sign = slot.logical_min < 0;
  const std::int64_t values = std::int64_t{1} << (with_sign ? slot.bit_size - 1 : slot.bit_size);
  return slot.logical_max < values && slot.logical_min >= -values;
}

std::int64_t rawOfTime(const ValueSlot& slot, double time_s) noexcept {
  const double tick_s = isSeconds(slot.unit) ? std::pow(10.0, slot.unit_exponent) : 1e-3;
  return rounded(time_s / tick_s, slot);
}

std::optional<double> stepOfTime(const ValueSlot& slot) noexcept {
  if (slot.unit != 0 && !isSeconds(slot.unit)) return std::nullopt;
  const double unit_s = slot.unit != 0 ? std::pow(10.0, slot.unit_exponent) : 1e-3;
  const auto logical = static_cast<double>(slot.logical_max - slot.logical_min);
  const auto physical = static_cast<double>(slot.physical_max - slot.physical_min);
  return physical == 0 || logical == 0 ? unit_s : unit_s * physical / logical;
}

std::int64_t rawOfAngle(const ValueSlot& slot, double angle_deg) noexcept {
  const auto low = static_cast<double>(slot.logical_min);
  const std::int64_t steps = slot.logical_max - slot.logical_min;
  // A range like 0..35999 leaves out the end of the turn, one like 0..36000 or 0..255 has it.
  const auto turn = static_cast<double>((steps + 1) % 360 == 0 ? steps + 1 : steps);
  return rounded(low + angle_deg / 360 * turn, slot);
}

}  // namespace tactus::haptics
