// A hand that pushes a tube in strokes. It is simulated: no person feels the force.
#pragma once

#include <algorithm>

// Per stroke: it grips, pushes along a minimum-jerk path, holds still, lets go and moves back for the next one. A hand
// that meets a force is slower, so the time of a stroke depends on the model.
class SimulatedHand {
 public:
  SimulatedHand(int strokes, double length_mm) : strokes_(strokes), length_mm_(length_mm) {}

  struct Pose {
    double position_mm = 0;  // along the axis of insertion, inwards positive
    bool held = false;       // the hand holds the tube
    int stroke = 0;          // from 1
  };

  bool isDone() const { return stroke_ > strokes_; }

  // Moves on by `dt_s` against `force_n`.
  Pose step(double force_n, double dt_s) {
    if (isDone()) return {0, false, strokes_};
    const double slower = 0.7 * std::clamp(force_n / kStrongN, 0.0, 1.0);
    const bool pushes = time_s_ >= kGripS && time_s_ < kGripS + pushS();
    time_s_ += pushes ? dt_s * (1 - slower) : dt_s;
    const double let_go_s = kGripS + pushS() + kStillS;
    const double way = path((time_s_ - kGripS) / pushS()) - path((time_s_ - let_go_s) / kBackS);
    const Pose pose{length_mm_ * way, time_s_ < let_go_s, stroke_};
    if (time_s_ >= let_go_s + kBackS) {
      time_s_ = 0;
      ++stroke_;
    }
    return pose;
  }

 private:
  static constexpr double kStrongN = 1.5;  // a force that makes the hand slow
  static constexpr double kGripS = 0.1;
  static constexpr double kStillS = 0.15;
  static constexpr double kBackS = 0.25;

  // The share of a minimum-jerk path (Flash and Hogan 1985) at the share `u` of its time.
  static double path(double u) {
    u = std::clamp(u, 0.0, 1.0);
    return u * u * u * (10 - 15 * u + 6 * u * u);
  }

  // Slow, medium, fast, and again.
  double pushS() const { return stroke_ % 3 == 1 ? 1.2 : stroke_ % 3 == 2 ? 0.8 : 0.5; }

  int strokes_;
  double length_mm_;
  int stroke_ = 1;
  double time_s_ = 0;  // since the stroke began
};
