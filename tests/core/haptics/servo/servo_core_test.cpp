#include "core/haptics/servo/servo_core.h"

#include <cfenv>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "core/base/random.h"

#include "tests/core/haptics/loop_numbers.h"
#include "tests/core/haptics/scenes.h"
#include "tests/core/haptics/servo/servo_hand.h"
#include "tests/support/real_time_trap.h"

namespace tactus::haptics {
namespace {

// Forces up to 1.3 N that go within 30 ms, beside a spring of 0.25 N/mm at 100 mm/s.
constexpr double kCalmStepN = 1.3 / 30 + 0.025;

TEST(ServoCore, AnEditIsInForceAtTheNextTick) {
  ServoHand hand(ForceSource::kInsertion);
  hand.post(constantScene(0.4));
  hand.step(400, 10);
  EXPECT_NEAR(hand.sample.model_force_n, 0.4, 1e-15);
  const auto asked = hand.core.counters().asked;
  hand.post(constantScene(0.8));
  hand.step();
  EXPECT_EQ(hand.sample.orders, hand.tick.orders_number);
  EXPECT_EQ(hand.core.counters().asked, asked + 1);
  // From the second tick on it is felt: a fiftieth of the difference each.
  hand.step();
  EXPECT_NEAR(hand.sample.model_force_n, 0.4 + 0.4 / 50, kRounding);
  hand.largest_step_n = 0;
  hand.step(500, 10);
  EXPECT_NEAR(hand.sample.model_force_n, 0.8, 1e-15);
  EXPECT_NEAR(hand.sample.force_n, 0.8, 1e-6);
  EXPECT_EQ(hand.sample.phase, render::Phase::kSlidingIn);
  EXPECT_LE(hand.largest_step_n, kCalmStepN);
}

TEST(ServoCore, OnlyWhatTheSceneNeedsIsComputed) {
  ServoHand hand(ForceSource::kInsertion);
  hand.post(ngtScene());
  hand.step(1);
  hand.step(300, 0.5);
  EXPECT_EQ(hand.core.counters().asked, 1U);  // stuck: once
  hand.tick.device.buttons = 0;
  const auto before = hand.core.counters();
  hand.step(100, -30);
  hand.post(ngtScene(0.1));
  hand.step(100, 30);
  EXPECT_EQ(hand.core.counters().asked, before.asked);
  EXPECT_EQ(hand.core.counters().released, before.released + 200);
  const auto& counters = hand.core.counters();
  EXPECT_EQ(counters.ticks, counters.asked + counters.released + counters.unchanged);
  hand.orders.source = ForceSource::kFree;
  hand.step(50);
  EXPECT_EQ(hand.core.counters().ticks, counters.ticks);
}

TEST(ServoCore, AReleaseMeansNoForceWithin30Ms) {
  ServoHand hand(ForceSource::kInsertion);
  hand.post(constantScene(1.2));
  hand.step(500, 25);
  ASSERT_GT(hand.sample.force_n, 1.15);
  hand.post(constantScene(0.5, {}, 1));
  hand.step(20, 1);
  hand.tick.device.buttons = 0;
  hand.largest_step_n = 0;
  hand.step(30, -1);
  EXPECT_NEAR(hand.sample.force_n, 0, kRounding);
  EXPECT_LE(hand.largest_step_n, kCalmStepN);
  hand.step(200);
  EXPECT_EQ(hand.sample.force_n, 0);
  EXPECT_EQ(hand.sample.source_force_n, 0);
}

TEST(ServoCore, SourcesFollowEachOtherWithoutAKick) {
  ServoHand hand(ForceSource::kInsertion);
  hand.post(constantScene(1.2));
  hand.orders.stimulus.force_n = 0.8;
  hand.step(500, 25);
  const double depth_mm = hand.sample.depth_mm;
  const auto change = [&](ForceSource source) {
    hand.orders.source = source;
    ++hand.orders.stimulus.number;
    ++hand.tick.orders_number;
    hand.largest_step_n = 0;
    hand.step(200);
    EXPECT_EQ(hand.sample.source, source);
    EXPECT_LE(hand.largest_step_n, kCalmStepN);
  };
  change(ForceSource::kStimulus);
  EXPECT_EQ(hand.sample.force_n, 0.8);
  EXPECT_EQ(hand.sample.stimulus, StimulusPhase::kFull);
  change(ForceSource::kFree);
  EXPECT_EQ(hand.sample.force_n, 0);
  change(ForceSource::kStimulus);
  change(ForceSource::kInsertion);
  EXPECT_EQ(hand.sample.phase, render::Phase::kStuck);
  EXPECT_EQ(hand.sample.depth_mm, depth_mm);  // the tube stayed where it was
  EXPECT_NEAR(hand.sample.force_n, 0, kRounding);
  hand.step(500, 25);
  EXPECT_GT(hand.sample.force_n, 1);
  change(ForceSource::kOff);
  EXPECT_EQ(hand.sample.force_n, 0);
}

TEST(ServoCore, FreeRecordsTheHandWithoutForce) {
  ServoHand hand(ForceSource::kFree);
  hand.post(constantScene(1.2));
  hand.orders.limits.guard_velocity = false;
  hand.step(400, 80);
  EXPECT_EQ(hand.largest_step_n, 0);
  EXPECT_NEAR(hand.sample.position_mm, 80, kRounding);
  EXPECT_NEAR(hand.sample.speed_mm_s, 200, 1e-6);  // 400 ms are 60 time constants of the filter
  EXPECT_EQ(hand.core.counters(), render::SceneCounters{});
}

TEST(ServoCore, AStimulusIsFeltAfterItsRamp) {
  ServoHand hand(ForceSource::kStimulus);
  hand.tick.device.buttons = 0;
  hand.step(50);
  hand.orders.stimulus.number = 7;
  hand.orders.stimulus.force_n = 0.5;
  hand.step(50);
  EXPECT_EQ(hand.sample.stimulus, StimulusPhase::kWaiting);
  EXPECT_EQ(hand.sample.force_n, 0);
  hand.tick.device.buttons = 1;
  while (!hand.sample.enabled) hand.step();
  hand.step(148);
  EXPECT_NEAR(hand.sample.force_n, 0.5 * 149 / 150, kRounding);
  hand.step();
  EXPECT_EQ(hand.sample.force_n, 0.5);
  EXPECT_EQ(hand.sample.since_full_s, 0);
  hand.step(1200);
  EXPECT_NEAR(hand.sample.since_full_s, 1.2, kRounding);
  EXPECT_EQ(hand.sample.limited, 0U);
}

TEST(ServoCore, AnotherPlacementBeginsAtItsDepth) {
  ServoHand hand(ForceSource::kInsertion);
  hand.orders.placement = 1;
  hand.post(constantScene(0.4));
  hand.step(500, 30);
  EXPECT_GT(hand.sample.depth_mm, 25);
  EXPECT_EQ(hand.sample.stroke, 1U);
  hand.orders.placement = 2;
  hand.orders.start_depth_mm = 170;
  hand.largest_step_n = 0;
  hand.step();
  EXPECT_EQ(hand.sample.depth_mm, 170);
  EXPECT_EQ(hand.sample.stretch_mm, 0);
  EXPECT_EQ(hand.sample.stroke, 1U);
  hand.step(100);
  EXPECT_NEAR(hand.sample.force_n, 0, 1e-6);  // of the filter's memory of the speed, through the damping
  EXPECT_LE(hand.largest_step_n, kCalmStepN);
  // The same orders once more begin nothing.
  ++hand.tick.orders_number;
  hand.step(500, 30);
  EXPECT_GT(hand.sample.depth_mm, 190);
}

TEST(ServoCore, FaultsOfPositionAndModelTrip) {
  ServoHand nowhere(ForceSource::kInsertion);
  nowhere.post(constantScene(0.4));
  nowhere.step(100, 1);
  nowhere.position_mm = std::numeric_limits<double>::quiet_NaN();
  nowhere.step();
  EXPECT_EQ(nowhere.sample.trip, TripCause::kPositionNotFinite);
  EXPECT_EQ(nowhere.sample.force_n, 0);
  nowhere.position_mm = 1;
  nowhere.step(100);
  EXPECT_EQ(nowhere.sample.force_n, 0);
  EXPECT_FALSE(nowhere.sample.enabled);

  ServoHand lost(ForceSource::kInsertion);
  lost.post(constantScene(0.4));
  lost.step(100, 1);
  lost.orders.placement = 1;
  lost.orders.start_depth_mm = std::numeric_limits<double>::quiet_NaN();
  lost.step();
  EXPECT_EQ(lost.core.tripped().cause, TripCause::kRenderer);
  EXPECT_EQ(lost.core.tripped().value, static_cast<double>(render::Fault::kForce));
  EXPECT_EQ(lost.core.tripped().time_ns, lost.tick.now_ns);
  lost.step(30);
  EXPECT_EQ(lost.sample.force_n, 0);
}

// 20 minutes of a hand that holds the device and does nothing, after motion: what decays ends at 0. A subnormal number
// that decays further raises the flag.
TEST(ServoCore, NothingDecaysIntoSubnormalNumbers) {
  for (const ForceSource source : {ForceSource::kInsertion, ForceSource::kStimulus, ForceSource::kFree}) {
    ServoHand hand(source);
    hand.orders.stimulus.number = 1;
    hand.orders.stimulus.force_n = 0.3;
    hand.orders.stimulus.hold_limit_s = 0.5;
    hand.post(constantScene(0.4));
    hand.step(500, 20);
    hand.step(200, -1.3);
    std::feclearexcept(FE_ALL_EXCEPT);
    hand.step(source == ForceSource::kInsertion ? 1'200'000 : 10'000);
    EXPECT_TRUE(hand.sample.enabled);
    hand.tick.device.buttons = 0;
    hand.step(5'000);
    EXPECT_EQ(std::fetestexcept(FE_UNDERFLOW), 0) << name(source);
  }
}

TEST(ServoCore, TheFirstSampleOfADeviceIsNoMotion) {
  ServoCore core{DeviceInfo{}};
  ServoOrders orders;
  ServoTick tick;
  tick.orders = &orders;
  for (int i = 1; i <= 5; ++i) {
    tick.now_ns = i * 1'000'000;
    core.tick(tick);
  }
  tick.device.number = 1;
  tick.device.position_mm = {0, 0, -70};
  tick.now_ns = tick.device.time_ns = 6'000'000;
  const Sample sample = core.tick(tick);
  EXPECT_EQ(sample.position_mm, 70);
  EXPECT_EQ(sample.speed_mm_s, 0);
}

TEST(ServoCore, SamplesSayWhatIsRendered) {
  DeviceInfo info;
  info.delay_s = 0.003;
  ServoHand hand(ForceSource::kInsertion, info);
  hand.post(constantScene(0.8, [] {
    fuzzy::RendererParameters renderer;
    renderer.stiffness_n_mm = 0.4;
    return renderer;
  }()));
  hand.step(1);
  hand.step(100, 1);
  // Half of 1.7 N s/m over 0.5 ms + 3 ms.
  EXPECT_NEAR(hand.sample.stiffness_n_mm, 0.5 * 0.0017 / 0.0035, 1e-15);
  EXPECT_TRUE(hand.sample.limited & kLimitedByStiffness);
  EXPECT_NEAR(hand.sample.stretch_mm, 1, kRounding);
  EXPECT_EQ(hand.sample.read_age_ns, 0);
}

TEST(ServoCore, TheStiffestSpringFollowsFromDampingAndDelay) {
  DeviceInfo touch;
  touch.damping_n_s_mm = 0.0002;
  EXPECT_NEAR(largestStiffnessNMm(touch), 0.5 * 0.0019 / 0.0015, 1e-15);
  touch.max_stiffness_n_mm = 0.4;
  EXPECT_EQ(largestStiffnessNMm(touch), 0.4);
  touch.delay_s = 0.0095;
  EXPECT_NEAR(largestStiffnessNMm(touch), 0.095, 1e-15);
}

double deviceForceN(const ServoHand& hand) {
  return -dot(hand.core.deviceForce(hand.sample), hand.orders.axis.inwards());
}

TEST(ServoCore, AScaleGivesAShareOfAStimulusAndTheLimitsStayThoseOfTheDevice) {
  ServoHand scaled(ForceSource::kStimulus);
  ServoHand plain(ForceSource::kStimulus);
  for (ServoHand* const hand : {&scaled, &plain}) {
    hand->tick.device.buttons = 0;
    hand->step(50);
    hand->orders.scale = hand == &scaled ? 4 : 1;
    hand->orders.stimulus = {1, hand == &scaled ? 6.0 : 1.5, 0.15, std::nullopt, std::nullopt};
    hand->tick.device.buttons = 1;
  }
  for (int i = 0; i < 6000; ++i) {
    scaled.step(1, 0.01);
    plain.step(1, 0.01);
    ASSERT_NEAR(deviceForceN(scaled), plain.sample.force_n, 1e-12) << i;
    ASSERT_NEAR(scaled.sample.force_n, 4 * plain.sample.force_n, 1e-11) << i;
    ASSERT_EQ(scaled.sample.limited, plain.sample.limited) << i;
    ASSERT_EQ(scaled.sample.stimulus, plain.sample.stimulus) << i;
  }
  EXPECT_EQ(scaled.sample.source_force_n, 4 * plain.sample.source_force_n);
}

TEST(ServoCore, AScaledForceIsNeverAboveTheCapOfTheDevice) {
  ServoHand hand(ForceSource::kInsertion);
  hand.orders.scale = 3;
  hand.post(constantScene(5));
  hand.step(800, 60);
  EXPECT_NEAR(hand.sample.force_n, 5, 1e-6);
  EXPECT_NEAR(deviceForceN(hand), 5.0 / 3, 1e-6);
  EXPECT_EQ(hand.sample.phase, render::Phase::kSlidingIn);
  hand.post(constantScene(20));
  hand.step(1500, 90);
  EXPECT_NEAR(deviceForceN(hand), hand.orders.limits.force_cap_n, 1e-6);
  // Another scale in the hand: no step beyond the slew of the device.
  hand.largest_step_n = 0;
  double before_n = deviceForceN(hand);
  hand.orders.scale = 1;
  for (int i = 0; i < 300; ++i) {
    hand.step(1, 0.05);
    ASSERT_LE(std::abs(deviceForceN(hand) - before_n), hand.orders.limits.release_slew_n_s * 1e-3 + kRounding) << i;
    before_n = deviceForceN(hand);
  }
}

TEST(ServoCore, TheSameInputsGiveTheSameBitsAndACopyGoesOn) {
  const auto scripted = [](ServoHand& hand, base::Random& random, int ticks) {
    std::vector<double> seen;
    for (int i = 0; i < ticks; ++i) {
      if (random.below(50) == 0) hand.post(ngtScene(random.uniform(), random.uniform(0, 90)));
      if (random.below(300) == 0) hand.tick.device.buttons ^= 1U;
      hand.step(1, random.uniform(-0.05, 0.1));
      seen.insert(seen.end(), {hand.sample.force_n, hand.sample.depth_mm, hand.sample.speed_mm_s});
    }
    return seen;
  };
  ServoHand one(ForceSource::kInsertion);
  ServoHand two(ForceSource::kInsertion);
  base::Random first(9);
  base::Random second(9);
  EXPECT_EQ(scripted(one, first, 1000), scripted(two, second, 1000));
  ServoHand copy = one;
  base::Random third = first;
  EXPECT_EQ(scripted(one, first, 500), scripted(copy, third, 500));
}

TEST(ServoCore, ATickAllocatesNothing) {
  ServoHand hand(ForceSource::kInsertion);
  hand.post(ngtScene());
  const auto next = ngtScene(0.2, 80);
  const long before = support::allocations();
  hand.step(300, 15);
  EXPECT_EQ(support::allocations(), before);
  hand.post(next);
  const long posted = support::allocations();
  hand.step(300, 15);
  hand.orders.source = ForceSource::kStimulus;
  hand.step(300, 15);
  hand.tick.device.buttons = 0;
  hand.step(100, -15);
  EXPECT_EQ(support::allocations(), posted);
}

}  // namespace
}  // namespace tactus::haptics
