// The source of the force: none, a stimulus, or the insertion with a model.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace tactus::haptics {

enum class ForceSource : std::uint8_t {
  kOff,        ///< no force
  kFree,       ///< no force; the hand is recorded
  kStimulus,   ///< a constant resistance for force judgements
  kInsertion,  ///< core/render with a model
};

/// `off`, `free`, `stimulus`, `insertion`.
constexpr std::string_view name(ForceSource source) noexcept {
  constexpr std::string_view kNames[] = {"off", "free", "stimulus", "insertion"};
  return kNames[static_cast<int>(source)];
}

/// The phase of a stimulus.
enum class StimulusPhase : std::uint8_t {
  kWaiting,  ///< until the hand holds the device inside the start zone
  kRising,
  kFull,
  kFalling,  ///< its time is over
  kEnded,    ///< it does not start again
};

/// One constant force against the hand. It starts when the hand is enabled, and inside the start zone if there is one.
/// After the start, only a new number changes it.
struct Stimulus {
  std::uint64_t number = 0;             ///< a new number is a new stimulus and starts again
  double force_n = 0;                   ///< >= 0, against insertion
  double ramp_s = 0.15;                 ///< from zero to the full force, and back
  std::optional<double> hold_limit_s;   ///< time at the full force before it ramps down; empty: no limit
  std::optional<double> start_zone_mm;  ///< it starts only within this distance of axis position 0
};

}  // namespace tactus::haptics
