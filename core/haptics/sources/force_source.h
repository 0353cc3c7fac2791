// Where the force comes from: nothing, a stimulus, or the insertion on a model.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace tactus::haptics {

enum class ForceSource : std::uint8_t {
  kOff,        ///< no force
  kFree,       ///< no force, the hand is recorded
  kStimulus,   ///< a constant resistance, for judging forces
  kInsertion,  ///< core/render on a model
};

/// `off`, `free`, `stimulus`, `insertion`.
constexpr std::string_view name(ForceSource source) noexcept {
  constexpr std::string_view kNames[] = {"off", "free", "stimulus", "insertion"};
  return kNames[static_cast<int>(source)];
}

/// How far a stimulus is.
enum class StimulusStage : std::uint8_t {
  kWaiting,  ///< for the hand to hold the device inside the start zone
  kRising,
  kFull,
  kFalling,  ///< its time is over
  kEnded,    ///< it does not begin again
};

/// One constant force against the hand. It begins when the hand is enabled and, where a start zone is set, inside it.
/// Once it has begun, nothing but another number changes it.
struct Stimulus {
  std::uint64_t number = 0;             ///< another number is another stimulus and starts anew
  double force_n = 0;                   ///< >= 0, against insertion
  double ramp_s = 0.15;                 ///< from nothing to the full force, and back
  std::optional<double> hold_limit_s;   ///< after this time at the full force it ramps down; nothing: held
  std::optional<double> start_zone_mm;  ///< it starts only within this distance of axis position 0
};

}  // namespace tactus::haptics
