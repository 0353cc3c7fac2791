// The places of the report values that constant forces need on a force-feedback device (HID PID), found by their
// usages.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/hid/report_descriptor.h"

namespace tactus::haptics {

/// One number in a HID report: its bits and its range.
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

/// A report in its transmitted form.
struct PidReport {
  std::uint8_t id = 0;
  std::size_t bytes = 0;  ///< including the id

  /// All bytes zero except the id.
  std::vector<std::uint8_t> blank() const;
  bool operator==(const PidReport&) const = default;
};

/// One of several named options. An array field takes the number of the option; a bit field takes a 1 in its place.
struct PidChoice {
  ValueSlot slot;
  std::int64_t value = 0;

  bool operator==(const PidChoice&) const = default;
};

/// An input value and its report.
struct InputSlot {
  std::uint8_t report_id = 0;
  ValueSlot slot;
};

/// The values of the reports. A value is optional if some firmwares lack it.
struct PidLayout {
  struct SetEffect {
    PidReport report;
    ValueSlot block;
    PidChoice constant_force;
    ValueSlot duration;
    std::optional<ValueSlot> gain;
    std::optional<ValueSlot> trigger_button;
    std::optional<ValueSlot> direction_enable;
    std::vector<ValueSlot> axes_enable;  ///< x, y
    std::vector<ValueSlot> directions;   ///< the first is the angle
  };
  struct ConstantForce {
    PidReport report;
    ValueSlot block;
    ValueSlot magnitude;
  };
  struct Operation {
    PidReport report;
    ValueSlot block;
    PidChoice start;
    PidChoice stop;
    std::optional<ValueSlot> loop_count;
  };
  struct BlockFree {
    PidReport report;
    ValueSlot block;
  };
  struct Control {
    PidReport report;
    std::optional<PidChoice> enable, disable, stop_all, reset;
  };
  struct Gain {
    PidReport report;
    ValueSlot gain;
  };
  struct Create {
    PidReport report;
    PidChoice constant_force;
  };
  struct BlockLoad {
    PidReport report;
    ValueSlot block;
    std::optional<PidChoice> success, full, error;
  };
  struct State {
    std::uint8_t report_id = 0;
    std::optional<ValueSlot> paused, actuators_on, safety_switch, power;
    std::optional<ValueSlot> playing;  ///< an effect is playing …
    std::optional<ValueSlot> block;    ///< … the effect of this block; without this value, any effect
  };

  SetEffect set_effect;
  ConstantForce constant_force;
  Operation operation;
  Create create;
  BlockLoad block_load;
  std::optional<BlockFree> block_free;
  std::optional<Control> control;
  std::optional<Gain> gain;
  std::optional<PidReport> pool;  ///< fetched once at the start, as the protocol requires
  std::optional<State> state;
  int force_axes = 1;                                ///< 1: x; 2: x and y
  std::array<std::optional<InputSlot>, 3> axes;      ///< x, y, z
  std::array<std::optional<InputSlot>, 32> buttons;  ///< button 1 first

  /// Whether magnitudes are never negative, so that the direction carries the sign.
  bool signByDirection() const { return constant_force.magnitude.logical_min >= 0; }

  /// Finds the layout. Returns an error with one sentence: the missing force-feedback reports, or the first invalid
  /// value (checkLayout).
  static base::Result<PidLayout> find(const ReportDescriptor& descriptor);
};

/// Whether the device has the report that sets effects. A device with it claims to be a PID device.
bool claimsPid(const ReportDescriptor& descriptor);

// Consistency check of a force-feedback device's report descriptor.

/// Checks everything that is written or read, because a wrong descriptor makes the device act differently from its
/// command: 5000 in 8 bits is -120, and a duration of 0 means forever. Returns an error with one sentence and the place
/// for: an invalid range, or one that its bits cannot hold; an option that its bits cannot hold; two reports with one
/// id; a duration field that cannot express PidSession::kDurationS to 5 ms.
base::Result<void> checkLayout(const PidLayout& layout);

}  // namespace tactus::haptics
