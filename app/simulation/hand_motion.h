// The movement of a scenario's hand: steps in sequence.
#pragma once

#include <string_view>
#include <vector>

#include "core/haptics/simulated/hand_plan.h"

namespace tactus::simulation {

/// One step; it begins at the end of the previous one. Each kind lists the members that it uses.
struct MotionStep {
  enum class Kind {
    kRest,     ///< duration_s
    kStroke,   ///< minimum jerk by length_mm (negative: outward) within duration_s
    kGoTo,     ///< minimum jerk to position_mm within duration_s
    kPush,     ///< at speed_mm_s for duration_s
    kSwing,    ///< a sine of amplitude_mm and frequency_hz around the current place, for duration_s
    kPress,    ///< the button goes down; takes no time
    kRelease,  ///< the button goes up; takes no time
    kLetGo,    ///< the hand leaves the device; the button keeps its state; takes no time
    kHold,     ///< the hand holds the device again; takes no time
  };

  Kind kind = Kind::kRest;
  double duration_s = 0;
  double length_mm = 0;
  double position_mm = 0;
  double speed_mm_s = 0;
  double amplitude_mm = 0;
  double frequency_hz = 0;
};

/// The strokes of a nurse as steps: press, settle, push, hold, release, back, pause.
std::vector<MotionStep> spelledOut(const haptics::StrokeSeries& series);

/// The sum of all durations, s.
double durationS(const std::vector<MotionStep>& steps) noexcept;

/// The steps as a plan. It starts at position 0 with the button up; after the last step the hand rests.
haptics::HandPlan planOf(const std::vector<MotionStep>& steps);

}  // namespace tactus::simulation
