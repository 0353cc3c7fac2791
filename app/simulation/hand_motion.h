// What the hand of a scenario does: steps, one after the other.
#pragma once

#include <string_view>
#include <vector>

#include "core/haptics/simulated/hand_plan.h"

namespace tactus::simulation {

/// One step; it begins where the one before ended. The members that a kind reads are named beside it.
struct MotionStep {
  enum class Kind {
    kRest,     ///< duration_s
    kStroke,   ///< minimum jerk by length_mm (negative: back) within duration_s
    kGoTo,     ///< minimum jerk to position_mm within duration_s
    kPush,     ///< at speed_mm_s for duration_s
    kSwing,    ///< a sine of amplitude_mm and frequency_hz around where it is, for duration_s
    kPress,    ///< the button goes down; takes no time
    kRelease,  ///< the button goes up; takes no time
    kLetGo,    ///< the hand leaves the device, and the button stays as it is; takes no time
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

/// Strokes as a nurse makes them, spelled out in steps: press, settle, push, hold, release, back, pause.
std::vector<MotionStep> spelledOut(const haptics::StrokeSeries& series);

/// All durations together, s.
double durationS(const std::vector<MotionStep>& steps) noexcept;

/// The steps as a plan, from position 0 with the button up; after the last one the hand rests.
haptics::HandPlan planOf(const std::vector<MotionStep>& steps);

}  // namespace tactus::simulation
