// What a simulated hand wants at each moment: strokes, pushes, tremor, and how they are put together.
#pragma once

#include <functional>
#include <limits>

namespace tactus::haptics {

/// What the hand wants at a time.
struct HandWish {
  double position_mm = 0;  ///< along the insertion axis, inwards positive
  double speed_mm_s = 0;
  bool holds = true;    ///< false: the hand has let go of the device
  bool button = false;  ///< the first button of the device is down

  bool operator==(const HandWish&) const = default;
};

/// The wish at a time >= 0 since the simulation began. Asked once per simulated millisecond, never twice for the same.
/// Calling the plans of this header allocates nothing and cannot throw; building them allocates.
using HandPlan = std::function<HandWish(double time_s)>;

/// A minimum-jerk stroke (Flash and Hogan 1985) from 0, then rest. `duration_s` > 0.
HandPlan stroke(double length_mm, double duration_s);

/// Strokes as a nurse makes them: press, push, hold, let the tube go, come back.
struct StrokeSeries {
  int count = 1;
  double length_mm = 60;
  double settle_s = 0.1;  ///< the button is down and the hand rests
  double forward_s = 0.8;
  double hold_s = 0.3;   ///< at the end of the stroke; then the button goes up
  double back_s = 0.6;   ///< minimum jerk, button up
  double pause_s = 0.2;  ///< at 0, button up

  double periodS() const noexcept { return settle_s + forward_s + hold_s + back_s + pause_s; }
};
HandPlan strokes(const StrokeSeries& series);

/// Away from 0 at one speed. 5 mm/s is the slow push of the tests.
HandPlan push(double speed_mm_s);

/// A sine around 0: 0.3 mm at 10 Hz is a tremor, 15 mm at 0.8 Hz are reversals.
HandPlan swing(double amplitude_mm, double frequency_hz);

/// The sum of two wishes. It holds while both hold; the button is down while one of them presses.
HandPlan both(HandPlan one, HandPlan other);

/// `plan` from `start_s` on. Until then the hand rests where `plan` begins, button up.
HandPlan after(double start_s, HandPlan plan);

/// `plan` with the button down from `from_s` until `to_s`, and as in `plan` elsewhere.
HandPlan pressing(HandPlan plan, double from_s = 0, double to_s = std::numeric_limits<double>::infinity());

/// `plan` until the hand lets go of the device at `at_s`; the button goes up with it.
HandPlan lettingGo(HandPlan plan, double at_s);

}  // namespace tactus::haptics
