// The plan of a simulated hand: its wish at each moment. Strokes, pushes and tremor can be combined.
//
// Wish: the position that the hand pulls toward. Example: wish 10 mm, device held at 8 mm by a force: the hand's
// spring is stretched by 2 mm.
#pragma once

#include <functional>
#include <limits>

namespace tactus::haptics {

/// The wish of the hand at one time.
struct HandTarget {
  double position_mm = 0;  ///< along the insertion axis, inwards positive
  double speed_mm_s = 0;
  bool holds = true;    ///< false: the hand has let go of the device
  bool button = false;  ///< the first button of the device is down

  bool operator==(const HandTarget&) const = default;
};

/// The wish at a time >= 0 since the start of the simulation. The simulation asks once per simulated millisecond, never
/// twice for the same one. Calling a plan of this header does not allocate or throw; building it allocates.
using HandPlan = std::function<HandTarget(double time_s)>;

/// A minimum-jerk stroke (Flash and Hogan 1985) from 0, then rest. `duration_s` > 0.
HandPlan stroke(double length_mm, double duration_s);

/// Strokes as a nurse makes them: press the button, push, hold, release the tube, come back.
struct StrokeSeries {
  int count = 1;
  double length_mm = 60;
  double settle_s = 0.1;  ///< the button is down and the hand rests
  double forward_s = 0.8;
  double hold_s = 0.3;   ///< at the end of the stroke; then the hand releases the button
  double back_s = 0.6;   ///< minimum jerk, button up
  double pause_s = 0.2;  ///< at 0, button up

  double periodS() const noexcept { return settle_s + forward_s + hold_s + back_s + pause_s; }
};
HandPlan strokes(const StrokeSeries& series);

/// Motion away from 0 at constant speed. The tests use 5 mm/s as a slow push.
HandPlan push(double speed_mm_s);

/// A sine around 0. Examples: 0.3 mm at 10 Hz for a tremor, 15 mm at 0.8 Hz for reversals.
HandPlan swing(double amplitude_mm, double frequency_hz);

/// The sum of two wishes. The hand holds if both hold. The button is down if at least one presses it.
HandPlan both(HandPlan one, HandPlan other);

/// `plan`, delayed by `start_s`. Before that the hand rests at the start of `plan`, button up.
HandPlan after(double start_s, HandPlan plan);

/// `plan`, with the button down from `from_s` to `to_s`. At other times the button follows `plan`.
HandPlan pressing(HandPlan plan, double from_s = 0, double to_s = std::numeric_limits<double>::infinity());

/// `plan`, until the hand lets go of device and button at `at_s`.
HandPlan lettingGo(HandPlan plan, double at_s);

}  // namespace tactus::haptics
