// The places of the report values that constant forces need on a force-feedback device (HID PID), found by their
// usages.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/hid/report_descriptor.h"
#include "core/haptics/hid/value_slot.h"

namespace tactus::haptics {

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

}  // namespace tactus::haptics
