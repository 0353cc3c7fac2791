#include <cmath>
#include <gtest/gtest.h>

#include "core/haptics/simulated/virtual_device.h"

namespace tactus::haptics {
namespace {

constexpr double kStepS = 1e-5;

SimulatedBody run(SimulatedBody body, double duration_s, double resistance_n = 0, const HandTarget& wish = {},
                  double step_s = kStepS) {
  const long steps = std::lround(duration_s / step_s);
  for (long i = 0; i < steps; ++i) body.step(wish, resistance_n, step_s);
  return body;
}

/// A mass of 0.05 kg on a spring of 100 N/m with 0.2 N s/m, let go at 10 mm.
struct Ringing {
  static constexpr double kMass = 0.05, kSpring = 100, kDamping = 0.2, kStartMm = 10;
  SimulatedBody body{SimulatedHand{"spring", 0, 0, kSpring}, DeviceMechanics{kMass, kDamping, 0}, kStartMm};

  static double positionMm(double time_s) {
    const double decay = kDamping / (2 * kMass);
    const double omega = std::sqrt(kSpring / kMass - decay * decay);
    return kStartMm * std::exp(-decay * time_s) * (std::cos(omega * time_s) + decay / omega * std::sin(omega * time_s));
  }
};

TEST(SimulatedBody, FreeMassSlowsDownAsViscousFrictionSays) {
  // x = v0 m/b (1 - exp(-b t/m)), v = v0 exp(-b t/m). A step is off by b dt/(2 m) = 2e-5 of what decays.
  const DeviceMechanics device{0.045, 0.2, 0};
  const double rate = 0.2 / 0.045;
  for (const double time_s : {0.05, 0.2, 1.0}) {
    const SimulatedBody body = run(SimulatedBody(kNobody, device, 3, 100), time_s);
    EXPECT_NEAR(body.speedMmS(), 100 * std::exp(-rate * time_s), 100 * 5e-5);
    EXPECT_NEAR(body.positionMm(), 3 + 100 / rate * (1 - std::exp(-rate * time_s)), 22.5 * 5e-5);
  }
}

TEST(SimulatedBody, ConstantForceGivesTheTerminalSpeed) {
  // v = F/b = 0.1 N / 0.2 N s/m, the remainder exp(-44) after 10 s.
  const SimulatedBody body = run(SimulatedBody(kNobody, {0.045, 0.2, 0}), 10, -0.1);
  EXPECT_NEAR(body.speedMmS(), 500, 1e-6);
}

TEST(SimulatedBody, SpringAndMassRing) {
  // The period is 141 ms; after 0.5 s of it the phase is off by at most omega dt/2 = 2.3e-4, times 10 mm.
  for (const double time_s : {0.02, 0.1, 0.25, 0.5})
    EXPECT_NEAR(run(Ringing().body, time_s).positionMm(), Ringing::positionMm(time_s), 2.5e-3) << time_s;
}

TEST(SimulatedBody, ErrorIsOfFirstOrderInTheStep) {
  double before = 0;
  for (const double step_s : {80e-6, 40e-6, 20e-6, 10e-6, 5e-6}) {
    const double error = std::abs(run(Ringing().body, 0.1, 0, {}, step_s).positionMm() - Ringing::positionMm(0.1));
    if (before > 0) {  // the next order is omega dt = 0.4 %
      EXPECT_NEAR(before / error, 2, 0.02) << step_s;
    }
    before = error;
  }
}

TEST(SimulatedBody, DryFrictionStopsAndHolds) {
  // v0²/(2 f/m) = 10000/2222 mm after m v0/f = 90 ms; the last step adds less than v0 dt.
  const DeviceMechanics device{0.045, 0, 0.05};
  const SimulatedBody moving = run(SimulatedBody(kNobody, device, 0, 100), 0.045);
  EXPECT_NEAR(moving.speedMmS(), 50, 0.02);
  const SimulatedBody stopped = run(SimulatedBody(kNobody, device, 0, 100), 0.1);
  EXPECT_EQ(stopped.speedMmS(), 0);
  EXPECT_NEAR(stopped.positionMm(), 4.5, 1e-3);
  // Less than the friction moves nothing, in either direction; more does.
  for (const double force_n : {0.0499, -0.0499}) EXPECT_EQ(run(stopped, 1, force_n).positionMm(), stopped.positionMm());
  EXPECT_LT(run(stopped, 0.01, 0.06).positionMm(), stopped.positionMm());
}

TEST(SimulatedBody, HandsGiveWayAsTheirSpringsSay) {
  // Without dry friction, at rest: F/k, for the arm behind the grip F/k1 + F/k2. The slowest, the arm of 1.46 kg with
  // 4.5 N s/m, swings out with exp(-1.56 t): 1e-8 after 12 s.
  const DeviceMechanics device{0.045, 0.2, 0};
  EXPECT_NEAR(run(SimulatedBody(kPinch, device), 12, 0.2).positionMm(), -2, 1e-6);
  EXPECT_NEAR(run(SimulatedBody(kArm, device), 12, 0.2).positionMm(), -200 / 135.0, 1e-6);
  EXPECT_NEAR(run(SimulatedBody(kFiveParameters, device), 12, 0.2).positionMm(), -200 / 48.8 - 200 / 375.0, 1e-6);
}

TEST(SimulatedBody, HandThatHasLetGoPullsNoMore) {
  // The goal is 50 mm away; what moves is the device alone, against nothing.
  for (const SimulatedHand& hand : handPresets()) {
    const SimulatedBody body = run(SimulatedBody(hand, {0.045, 0.2, 0}, 0, 10), 0.1, 0, {50, 0, false});
    EXPECT_NEAR(body.speedMmS(), 10 * std::exp(-0.2 / 0.045 * 0.1), 10 * 5e-5) << hand.name;
  }
}

TEST(SimulatedBody, PresetsAreFoundByName) {
  ASSERT_EQ(handPresets().size(), 4U);
  for (const SimulatedHand& hand : handPresets()) EXPECT_EQ(findHand(hand.name), &hand);
  EXPECT_EQ(findHand("pinch")->stiffness_n_m, 100);
  EXPECT_EQ(findHand("elephant"), nullptr);
}

}  // namespace
}  // namespace tactus::haptics
