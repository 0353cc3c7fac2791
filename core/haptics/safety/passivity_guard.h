// The last guard against a control loop that drives a vibration. It watches the energy between force and hand.
#pragma once

#include <array>
#include <cstdint>

namespace tactus::haptics {

/// Time-domain passivity observer and controller (Hannaford and Ryu, IEEE Trans. Robotics and Automation 18(1), 2002).
/// Observer: W is the sum of (force that acted since the last tick) x (displacement of the hand since then). Positive W
/// is energy taken from the hand. The force acts `delay_s` after the command. Without this delay, a spring that is too
/// stiff for its delay would look passive while it shakes the hand.
/// Controller: below -1 mJ it adds damping, at most 0.002 N s/mm and 0.5 N. From -2 mJ to -4 mJ it reduces the source's
/// force to zero. So no source gives more than a few mJ at once, and little more per 1.5 s.
///
/// A negative W is not always a fault. Three rules allow for this:
/// - The displacement follows the counts with a backlash of 0.06 mm, so that a flickering count moves nothing.
/// - W leaks to 0 with a time constant of 1.5 s. A positive W leaks only down to the energy that a spring of 0.1 N/mm
///   stores at the present force, because a hand resting on a stretched spring gets that energy back later.
/// - A positive W above this energy is capped at 2 mJ. More would hide later activity.
/// Plain state. Thread: servo. Real-time safe: yes.
class PassivityGuard {
 public:
  /// Sets W to 0.
  void reset(std::int64_t now_ns, double position_mm) noexcept;
  /// `held_n`: the resistance commanded since the last call. `delay_s`: [0, 0.03], as DeviceInfo::delay_s.
  void observe(std::int64_t now_ns, double position_mm, double held_n, double delay_s) noexcept;
  /// The resistance to render if the source asks for `asked_n`. Equal to `asked_n` while W >= -1 mJ.
  double control(double asked_n) const noexcept;

  /// W, mJ; positive: taken from the hand.
  double energyMj() const noexcept { return energy_mj_; }

  /// Longer delays are not looked back at.
  static constexpr double kLongestDelayS = 0.03;

 private:
  /// A commanded force, and the time of its command.
  struct Held {
    std::int64_t since_ns = 0;
    double force_n = 0;
  };
  static constexpr int kRoom = 64;

  double acted(std::int64_t from_ns, std::int64_t until_ns) const noexcept;

  std::array<Held, kRoom> held_{};
  int newest_ = -1;
  int count_ = 0;
  std::int64_t now_ns_ = 0;
  double reference_mm_ = 0;  ///< the position after the backlash
  double energy_mj_ = 0;
  double speed_mm_s_ = 0;  ///< of the reference, low-passed for the damping
};

}  // namespace tactus::haptics
