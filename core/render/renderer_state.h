// The renderer's state between two ticks, its input at a tick, and its settings.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>

#include "core/fuzzy/renderer_parameters.h"
#include "core/render/low_pass.h"

namespace tactus::render {

enum class Phase : std::uint8_t {
  kReleased,    ///< the hand does not hold the tube: no force, no motion counts
  kStuck,       ///< static friction: the tube yields like a spring and does not advance
  kSlidingIn,   ///< dynamic friction against insertion; the depth grows
  kSlidingOut,  ///< dynamic friction against withdrawal; the depth falls
};

/// The reason why the renderer released the force by itself. It engages again after `enabled` has been false.
enum class Fault : std::uint8_t { kNone, kPosition, kForce, kTime };  ///< the quantity out of range

/// The inputs of the model that the renderer moves. The caller sets the other inputs (lubrication, neck flexion).
struct ForcePoint {
  double depth_mm = 0;    ///< depth of the model, including the offset
  double speed_mm_s = 0;  ///< >= 0: filtered speed of the slip inwards; 0 in every other phase

  bool operator==(const ForcePoint&) const = default;
};

/// The model's answer at a ForcePoint. A force below 0 counts as 0; a force that is not finite is a fault.
struct ModelForce {
  double force_n = 0;
  bool fired = false;  ///< false: no rule fired, and `force_n` is the model's default
};

/// One stroke: from a press to the release.
struct StrokeSpan {
  std::uint32_t number = 0;  ///< from 1; 0: no stroke yet
  double start_s = 0;        ///< times as RendererState::time_s
  double end_s = 0;          ///< end, or the last tick while the stroke lasts
  double start_depth_mm = 0;
  double end_depth_mm = 0;

  bool operator==(const StrokeSpan&) const = default;
};

/// Plain data: copy it, compare it, start with a default one. To start at another depth than the entry, set
/// `depth_mm`.
struct RendererState {
  Phase phase = Phase::kReleased;
  Fault fault = Fault::kNone;
  double time_s = 0;    ///< sum of the ticks so far
  double depth_mm = 0;  ///< depth of the tube: the sum of all slip
  double force_n = 0;   ///< resistance along the axis; the force on the hand is its negative
  StrokeSpan stroke;

  std::optional<double> position_mm;  ///< of the last tick
  double stretch_mm = 0;              ///< z: lead of the hand over the tube
  double stiffness_n_mm = 0;          ///< of the last tick, to detect a change
  double clip_n = 0;                  ///< sliding: force above which the spring slips; relaxes to dynamic friction
  double stiction = 0;                ///< stuck: share of the break-away surplus built up at rest, [0, 1]
  double slow_s = 0;                  ///< time for which a sliding tube has been slower than stick_speed_mm_s
  double damping_share = 0;           ///< 1 after a long stuck phase, 0 while sliding
  LowPass speed_mm_s;                 ///< of the hand
  LowPass slip_speed_mm_s;            ///< of the tube
  double fading_n = 0;                ///< remaining force of the last stroke, on its way to 0
  double fading_rate_n_s = 0;

  double dynamic_n = 0;             ///< F_d as rendered: follows `model_n` at slew_n_s or slower
  double model_n = 0;               ///< the last F_d that fired; before that, the model's default
  bool any_fired = false;           ///< a rule has fired since the start
  bool held = false;                ///< no rule fires at the present point, so `model_n` is held
  std::optional<ForcePoint> asked;  ///< the point at which the model gave `model_n`
  std::uint64_t conditions = 0;     ///< RendererInput::conditions at that time

  bool operator==(const RendererState&) const = default;
};

/// The input of one tick.
struct RendererInput {
  double position_mm = 0;           ///< of the hand along the axis, inwards positive
  bool enabled = false;             ///< button, pedal or key, debounced; false releases at once
  std::uint64_t conditions = 0;     ///< changes if the model, lubrication or neck flexion changes
  std::optional<ModelForce> force;  ///< the model's force if `forceNeeded` gave a point; otherwise ignored
};

/// The settings for all ticks until the caller changes them.
struct RendererSettings {
  fuzzy::RendererParameters friction;  ///< inside the ranges of fuzzy::kRendererFields; validated with the model
  double force_cap_n = 2.0;            ///< >= 0, largest force. If it is below the friction, the tube slips at the cap
  /// End of the model's depth, including the offset: the tube goes no deeper. Default: no end.
  double depth_end_mm = std::numeric_limits<double>::infinity();
};

// The state of an insertion as bytes: one function names the members, the writer or the reader goes through them.
// Example of such a function: take.number(state.depth_mm, -1e9, 1e9); take.whole(state.phase, 3);

/// Writes each member as 8 bytes of this machine. Members beyond the end of the bytes are counted and not written, so a
/// writer without bytes counts. Real-time safe: yes.
class StateWriter {
 public:
  explicit StateWriter(std::span<std::byte> bytes = {}) noexcept : bytes_(bytes) {}

  void number(double value, double /*min*/, double /*max*/) noexcept { put(std::bit_cast<std::uint64_t>(value)); }
  template <typename Whole>
  void whole(Whole value, std::uint64_t /*most*/ = ~std::uint64_t{0}) noexcept {
    put(static_cast<std::uint64_t>(value));
  }
  /// Of all members so far.
  std::size_t size() const noexcept { return size_; }

 private:
  void put(std::uint64_t bits) noexcept {
    if (size_ + sizeof bits <= bytes_.size()) std::memcpy(bytes_.data() + size_, &bits, sizeof bits);
    size_ += sizeof bits;
  }

  std::span<std::byte> bytes_;
  std::size_t size_ = 0;
};

/// Reads what a StateWriter wrote. A value out of its range, NaN, or an end too early makes `fits` false; what was read
/// is then not to be used. Real-time safe: yes.
class StateReader {
 public:
  explicit StateReader(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {}

  void number(double& value, double min, double max) noexcept {
    value = std::bit_cast<double>(get());
    fits_ = fits_ && value >= min && value <= max;
  }
  template <typename Whole>
  void whole(Whole& value, std::uint64_t most = ~std::uint64_t{0}) noexcept {
    const std::uint64_t bits = get();
    fits_ = fits_ && bits <= most;
    value = static_cast<Whole>(fits_ ? bits : 0);
  }
  bool fits() const noexcept { return fits_; }
  /// The bytes that were not read yet.
  std::span<const std::byte> rest() const noexcept { return bytes_; }

 private:
  std::uint64_t get() noexcept {
    std::uint64_t bits = 0;
    fits_ = fits_ && bytes_.size() >= sizeof bits;
    if (!fits_) return 0;
    std::memcpy(&bits, bytes_.data(), sizeof bits);
    bytes_ = bytes_.subspan(sizeof bits);
    return bits;
  }

  std::span<const std::byte> bytes_;
  bool fits_ = true;
};

/// Whether `value` is there, and what `members` names of it (of a default one where it is not).
template <typename Optional, typename Take, typename Members>
void takeOptional(Optional& value, Take& take, Members&& members) noexcept {
  bool there = value.has_value();
  take.whole(there, 1);
  auto inside = value.value_or(typename std::remove_const_t<Optional>::value_type{});
  members(inside);
  if constexpr (!std::is_const_v<Optional>) {
    value.reset();
    if (there) value = inside;
  }
}

}  // namespace tactus::render
