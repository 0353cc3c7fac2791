// The source of the force: none, a stimulus, or the insertion with a model.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/haptics/safety/limit_settings.h"

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

// The stimulus as a source of force: one constant resistance for force judgements (paper, Section 3.1.5).

/// One tick of the stimulus.
struct StimulusTick {
  bool active = false;     ///< the stimulus is the source; otherwise it ends
  bool enabled = false;    ///< the hand holds the device
  double position_mm = 0;  ///< along the insertion axis
  double dt_s = 0.001;     ///< since the last tick
  double scale = 1;        ///< the hand gets the force divided by it
};

/// One stimulus after another. Each starts once and rises linearly within its ramp. It ends when its time at the full
/// force is over (LimitSettings::stimulus_hold_s limits it above the continuous rating), when the hand lets go, or when
/// the source or the number changes. To repeat a stimulus, give it a new number. If its time is over, the force falls
/// within the ramp; otherwise it fades within render::kReleaseFadeS.
/// All state is plain, copyable data. Thread: servo. Real-time safe: yes.
class StimulusSource {
 public:
  /// The resistance, N.
  double tick(const StimulusTick& tick, const Stimulus& stimulus, const LimitSettings& limits) noexcept;

  StimulusPhase phase() const noexcept { return phase_; }
  /// Time since the full force was reached, s; 0 before. It runs on after the end of the force until the next stimulus,
  /// and so gives the response time of an answer.
  double sinceFullS() const noexcept { return since_full_s_; }

 private:
  void letGo() noexcept;
  void advance(const StimulusTick& tick, const LimitSettings& limits) noexcept;

  StimulusPhase phase_ = StimulusPhase::kWaiting;
  Stimulus stimulus_;  ///< as it was at its start
  double level_ = 0;   ///< share of the force, [0, 1]
  double force_n_ = 0;
  double since_full_s_ = 0;
  bool full_ = false;    ///< the full force was reached
  double fading_n_ = 0;  ///< remaining force of an ended stimulus, on its way to 0
  double fading_n_s_ = 0;
};

}  // namespace tactus::haptics
