// Another insertion axis while the servo runs: the tube does not move, and no force acts along the new axis too early.
#include <cmath>
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/haptics/servo/servo_core.h"

#include "tests/core/haptics/loop_numbers.h"
#include "tests/core/haptics/scenes.h"
#include "tests/core/haptics/servo/servo_hand.h"

namespace tactus::haptics {
namespace {

TEST(ServoCore, AnotherAxisIsNoMotion) {
  ServoHand hand(ForceSource::kInsertion);
  hand.post(constantScene(0.6));
  hand.step(300, 10);
  const Sample before = hand.sample;
  hand.at_mm = hand.tick.device.position_mm;
  hand.orders.axis = *AxisMapping::make({1, 0, 0}, {40, 0, 0});
  hand.step(50);
  EXPECT_EQ(hand.sample.position_mm, -40);
  hand.tick.device.buttons = 0;
  hand.step(5);
  hand.tick.device.buttons = 1;
  hand.step(30);
  EXPECT_TRUE(hand.sample.enabled);
  EXPECT_EQ(hand.sample.trip, TripCause::kNone);
  EXPECT_EQ(hand.sample.depth_mm, before.depth_mm);
  EXPECT_EQ(hand.sample.stretch_mm, 0);
  hand.at_mm.reset();
  hand.position_mm = -40;
  hand.step(300, 10);
  EXPECT_NEAR(hand.sample.depth_mm + hand.sample.stretch_mm, before.depth_mm + 10, kRounding);
}

TEST(ServoCore, AnotherAxisLetsTheForceGoAlongTheOldOne) {
  const Vector3 old_inwards = AxisMapping().inwards();
  ServoHand hand(ForceSource::kStimulus);
  hand.orders.stimulus.number = 1;
  hand.orders.stimulus.force_n = 0.8;
  hand.step(200);
  ASSERT_EQ(hand.sample.force_n, 0.8);
  hand.orders.axis = *AxisMapping::make(-1 * old_inwards);
  for (int i = 1; i < 30; ++i) {
    hand.step();
    ASSERT_NEAR(hand.sample.force_n, 0.8 * (1 - i / 30.0), 1e-9);
    ASSERT_EQ(hand.core.axis().inwards(), old_inwards);
    ASSERT_FALSE(hand.sample.enabled);
  }
  hand.step(2);
  EXPECT_EQ(hand.core.axis().inwards(), hand.orders.axis.inwards());
  // Nothing along the new one before the next press, whatever is ordered.
  hand.orders.stimulus.number = 2;
  hand.largest_step_n = 0;
  hand.step(500);
  EXPECT_EQ(hand.sample.force_n, 0);
  EXPECT_EQ(hand.largest_step_n, 0);
  hand.tick.device.buttons = 0;
  hand.step(5);
  hand.tick.device.buttons = 1;
  hand.step(200);
  EXPECT_EQ(hand.sample.force_n, 0.8);
}

TEST(ServoCore, AnAxisThatComesBackDuringTheFadeBringsNoForceBack) {
  ServoHand hand(ForceSource::kStimulus);
  hand.orders.stimulus.number = 1;
  hand.orders.stimulus.force_n = 0.8;
  hand.step(200);
  hand.orders.axis = *AxisMapping::make({1, 0, 0});
  hand.step(10);
  hand.orders.axis = AxisMapping();
  hand.step();
  EXPECT_NEAR(hand.sample.force_n, 0.8 * 19 / 30, 1e-9);
  hand.step(19);
  EXPECT_EQ(hand.sample.force_n, 0);
  hand.step(200);
  EXPECT_FALSE(hand.sample.enabled);
}

double length(const Vector3& v) { return std::sqrt(dot(v, v)); }

TEST(ServoCore, TheForceOnTheHandKeepsTheSlewLimitsAsAVector) {
  constexpr double kRoundingN = 1e-9;
  base::Random random(21);
  const auto direction = [&] { return Vector3{random.normal(), random.normal(), random.normal()}; };
  ServoHand hand(ForceSource::kInsertion);
  hand.orders.limits.guard_velocity = false;
  hand.orders.stimulus.force_n = 1.3;
  hand.orders.stimulus.ramp_s = 0;
  hand.post(constantScene(1.2));
  hand.at_mm = Vector3{};
  Vector3 velocity_mm_s;
  Vector3 before_n;
  int turned_under_force = 0;
  for (int i = 0; i < 60'000; ++i) {
    if (random.below(400) == 0) {
      hand.orders.axis = *AxisMapping::make(direction(), 20 * direction());
      turned_under_force += length(before_n) > 0.5 ? 1 : 0;
    }
    if (random.below(400) == 0) {
      const bool insertion = hand.orders.source == ForceSource::kInsertion;
      hand.orders.source = insertion ? ForceSource::kStimulus : ForceSource::kInsertion;
      ++hand.orders.stimulus.number;
    }
    if (random.below(hand.tick.device.buttons == 1 ? 300 : 20) == 0) hand.tick.device.buttons ^= 1U;
    velocity_mm_s = 0.99 * velocity_mm_s + 20 * direction();
    hand.at_mm = *hand.at_mm + 0.001 * velocity_mm_s;
    hand.step();
    const Vector3 force_n = hand.core.axis().forceOnHand(hand.sample.force_n);
    ASSERT_LE(length(force_n - before_n), 0.5 + kRoundingN) << i;           // 500 N/s toward zero
    ASSERT_LE(length(force_n) - length(before_n), 0.25 + kRoundingN) << i;  // 250 N/s away from it
    before_n = force_n;
  }
  EXPECT_GT(turned_under_force, 20);
}

}  // namespace
}  // namespace tactus::haptics
