// The last guard against a loop that feeds a vibration: it watches the energy between force and hand.
#pragma once

#include <array>
#include <cstdint>

namespace tactus::haptics {

/// Passivity observer and controller in the time domain (Hannaford and Ryu, IEEE Trans. Robotics and Automation 18(1),
/// 2002). Observer: W is the sum of (force that acted since the last tick) x (way of the hand since then); positive is
/// taken from the hand. The force acts `delay_s` after it is asked for: without this a spring that is too stiff for
/// its delay looks passive while it shakes the hand. Controller: below -1 mJ damping comes in, at most 0.002 N s/mm and
/// 0.5 N; below -2 mJ the source's force goes, and is gone at -4 mJ. So no source gives more than a few mJ and a
/// trickle of that per 1.5 s.
///
/// Not every negative W is a fault, so three things are added. The way follows the counts with a play of 0.06 mm,
/// so that a count that flickers moves nothing. W leaks to 0 with 1.5 s, but credit only down to what a spring of 0.1
/// N/mm could hold at the present force: a hand that rests on a stretched spring gets that back later. Credit above
/// this is capped at 2 mJ, or it would hide later activity.
/// Plain state. Thread: servo. Real-time safe: yes.
class PassivityGuard {
 public:
  /// From here nothing was exchanged yet.
  void reset(std::int64_t now_ns, double position_mm) noexcept;
  /// `held_n`: the resistance that was asked for since the last call. `delay_s` in [0, 0.03]: as DeviceInfo has it.
  void observe(std::int64_t now_ns, double position_mm, double held_n, double delay_s) noexcept;
  /// The resistance to render where the source asks for `asked_n`; equal to it while W >= -1 mJ.
  double control(double asked_n) const noexcept;

  /// W, mJ; positive: taken from the hand.
  double energyMj() const noexcept { return energy_mj_; }

 private:
  /// A force, and since when it was asked for.
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
  double reference_mm_ = 0;  ///< the position behind the play
  double energy_mj_ = 0;
  double speed_mm_s_ = 0;  ///< of the reference, low-passed for the damping
};

}  // namespace tactus::haptics
