// A hand on a device under the servo, everything drawn from one number: what must hold whatever the hand does.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace tactus::stress {

/// What one run did. Limits: the design's, and those of docs/servo.md.
struct FeelRun {
  std::optional<std::string> violation;  ///< the first thing that must not happen, with its time
  std::string what;                      ///< hand, motion, device, disturbances; for people
  int most_transitions = 0;              ///< that the run may have; 0: no limit for this run
  double most_ripple_n = 0;              ///< the same; 0: no limit
  int transitions = 0;                   ///< between stuck and sliding
  double ripple_n = 0;                   ///< rms of the resistance above 30 Hz while the hand holds the device
  double largest_step_n = 0;             ///< of the resistance in one tick of 1 ms
  double lowest_certificate_mj = 0;      ///< stored energy that no hand put in; 0 up to rounding
  double largest_depth_error_mm = 0;     ///< |Δdepth - (Δx - Δz)| within a stroke
  bool tripped = false;
};

/// Run `number`: hands none, pinch, arm, five-parameter; stiffness, delay, counts; dropped ticks, stalls of 2 to 50 ms
/// of servo or device; tremor, reversals, slow push, strokes, press at speed, letting go of button or device while
/// sliding; live swaps of the model. Deterministic.
FeelRun feelRun(std::uint64_t number);

}  // namespace tactus::stress
