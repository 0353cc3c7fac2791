// What the hand feels when no command reaches the device for longer than the device holds one: the force begins anew
// from nothing, whatever the safety layer last asked for.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/haptics/servo/servo_core.h"
#include "core/haptics/simulated/virtual_device.h"

#include "tests/core/haptics/loop_numbers.h"
#include "tests/core/haptics/safety/safety_loop.h"

namespace tactus::haptics {
namespace {

constexpr double kAskedN = 1.7;

/// A held device that asks for 1.7 N, in simulated time; the servo may stand still while the device runs.
class HeldDevice {
 public:
  explicit HeldDevice(double hold_s, VirtualDeviceSettings settings = {}) {
    settings.quiet_after_s = hold_s;
    settings.plan = pressing([](double) { return HandTarget{}; }, 0.02);
    device_ = std::move(*VirtualDevice::make(settings));
    EXPECT_TRUE(device_->start().has_value());
    core_.emplace(device_->info());
    orders_.source = ForceSource::kStimulus;
    orders_.armed = true;
    orders_.stimulus.number = 1;
    orders_.stimulus.force_n = kAskedN;
    orders_.limits = LimitSettings::forDevice(device_->info());
    orders_.limits.stimulus_hold_s = 1e6;
    orders_.limits.continuous_force_n = 3;  // the budget is not what is looked at
  }

  /// A millisecond of the device; the servo ticks in it or stands still.
  void pass(bool servo_ticks) {
    now_ns_ += kTickNs;
    const DeviceState state = device_->read(now_ns_);
    before_n = at_hand_n;
    at_hand_n = device_->trueForceN();
    if (!servo_ticks) return;
    sample = core_->tick({now_ns_, state, &orders_, 1, false, false, now_ns_});
    device_->write(core_->axis().forceOnHand(sample.force_n), now_ns_);
  }
  void pass(int milliseconds, bool servo_ticks) {
    for (int i = 0; i < milliseconds; ++i) pass(servo_ticks);
  }
  void toFullForce() {
    pass(1500, true);
    ASSERT_NEAR(at_hand_n, kAskedN, 1e-9);
  }
  const LimitSettings& limits() const { return orders_.limits; }

  double at_hand_n = 0;
  double before_n = 0;  ///< at the hand, a millisecond ago
  Sample sample;

 private:
  std::unique_ptr<VirtualDevice> device_;
  std::optional<ServoCore> core_;
  ServoOrders orders_;
  std::int64_t now_ns_ = 0;
};

/// By hand: 1.7 N come back within 1 s, 0.0017 N in each tick.
TEST(CommandGap, LongerThanTheDeviceHoldsBeginsANewFadeIn) {
  HeldDevice held(0.05);
  held.toFullForce();
  held.pass(70, false);
  EXPECT_EQ(held.at_hand_n, 0);  // the device let go by itself
  held.pass(3, true);
  EXPECT_LT(held.at_hand_n, 0.02);
  EXPECT_TRUE(held.sample.limited & kLimitedByGap);
  EXPECT_TRUE(held.sample.enabled);
  EXPECT_EQ(held.sample.trip, TripCause::kNone);
  held.pass(500, true);
  EXPECT_NEAR(held.at_hand_n, kAskedN / 2, 0.02);
  EXPECT_TRUE(held.sample.limited & kLimitedByGap);
  held.pass(510, true);
  EXPECT_NEAR(held.at_hand_n, kAskedN, 1e-9);
  EXPECT_FALSE(held.sample.limited & kLimitedByGap);
}

TEST(CommandGap, ADelayIsNoGap) {
  VirtualDeviceSettings settings;
  settings.delay_s = 0.03;
  HeldDevice held(0.02, settings);
  held.toFullForce();
  EXPECT_FALSE(held.sample.limited & kLimitedByGap);
}

TEST(CommandGap, ShorterThanTheDeviceHoldsChangesNothing) {
  HeldDevice held(0.05);
  held.toFullForce();
  held.pass(48, false);
  EXPECT_NEAR(held.at_hand_n, kAskedN, 1e-9);
  held.pass(3, true);
  EXPECT_NEAR(held.at_hand_n, kAskedN, 1e-9);
  EXPECT_FALSE(held.sample.limited & (kLimitedByGap | kLimitedByFadeIn));
}

/// Stalls of servo and device of 1 to 200 ms, anywhere, on devices that hold a command for 8 ms to 0.3 s.
TEST(CommandGap, NoStallMakesTheForceAtTheHandJump) {
  constexpr double kHoldsS[] = {0.008, 0.02, 0.035, 0.05, 0.075, 0.1, 0.3};
  int zeroed = 0;
  int back = 0;
  for (std::uint64_t seed = 1; seed <= 70; ++seed) {
    base::Random random(seed);
    VirtualDeviceSettings settings;
    settings.delay_s = 0.001 * random.below(4);
    settings.seed = seed;
    if (random.below(2) == 0) {
      settings.stalls_per_s = random.uniform(0.2, 2);
      settings.longest_stall_ms = 1 + random.below(200);
      settings.shortest_stall_ms = 1;
    }
    const double hold_s = kHoldsS[random.below(std::size(kHoldsS))];
    HeldDevice held(hold_s, settings);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", hold " + std::to_string(hold_s));
    int stall = 0;
    int ticked_ago = 0;
    for (int i = 0; i < 6000; ++i) {
      if (stall == 0 && random.below(400) == 0) stall = 1 + random.below(200);
      const bool ticks = stall == 0;
      if (stall > 0) --stall;
      held.pass(ticks);
      // The longest step of a tick is that of 2 ms; a force may arrive up to its delay later.
      const double most_n = held.limits().slew_n_s * 0.002;
      ASSERT_LE(std::abs(held.at_hand_n) - std::abs(held.before_n), most_n + 1e-9) << "at " << i << " ms";
      zeroed += held.before_n > 1 && held.at_hand_n == 0 && ticked_ago > 0 ? 1 : 0;
      back += held.at_hand_n > 1 ? 1 : 0;
      ticked_ago = ticks ? 0 : ticked_ago + 1;
      if (held.sample.trip != TripCause::kNone) break;
    }
  }
  EXPECT_GT(zeroed, 30);   // devices did let go
  EXPECT_GT(back, 20000);  // and forces came back
}

TEST(CommandGap, TheEnergyBeforeItIsForgotten) {
  SafetyLoop loop;
  loop.toFullForce();
  loop.input.follows_motion = true;
  // A hand that is pushed back by 1 N over 0.3 mm, again and again, gets 0.3 mJ each time.
  for (int i = 0; i < 8; ++i) {
    loop.input.position_mm -= 0.1;
    loop.tick();
  }
  EXPECT_LT(loop.safety.energyMj(), -0.4);
  loop.tick(60);
  EXPECT_EQ(loop.safety.energyMj(), 0);
}

TEST(CommandGap, IsCountedOnlyWhereAForceWasOn) {
  SafetyLoop loop;
  loop.input.armed = true;
  loop.ticks(5);
  loop.tick(60);
  EXPECT_EQ(loop.safety.restarts(), 0u);
  loop.toFullForce();
  loop.tick(60);
  EXPECT_EQ(loop.safety.restarts(), 1u);
  EXPECT_LE(loop.out.force_n, 0.002 + 1e-12);
  EXPECT_FALSE(loop.safety.tripped());
}

/// A device that takes no force lets go as well, though the servo runs.
TEST(CommandGap, ForcesThatDoNotArriveAreAGapToo) {
  SafetyLoop loop;
  loop.safety = Safety(0.02);
  loop.toFullForce();
  loop.writing = false;
  loop.ticks(15);
  EXPECT_EQ(loop.out.force_n, 1);
  loop.ticks(15);
  EXPECT_LE(loop.out.force_n, 0.002);
  loop.writing = true;
  const double before_n = loop.out.force_n;
  loop.tick();
  EXPECT_LE(loop.out.force_n, before_n + 0.002);
  EXPECT_FALSE(loop.safety.tripped());
}

}  // namespace
}  // namespace tactus::haptics
