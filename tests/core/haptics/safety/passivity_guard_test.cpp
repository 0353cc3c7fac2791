// The passivity guard between sources and simulated hands: active sources are held, passive ones never touched.
#include "core/haptics/safety/passivity_guard.h"

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/haptics/simulated/virtual_device.h"
#include "core/render/insertion_renderer.h"

#include "tests/core/haptics/loop_numbers.h"

namespace tactus::haptics {
namespace {

using Source = std::function<double(double position_mm)>;

struct Loop {
  SimulatedHand hand = kPinch;
  HandPlan plan = push(0);
  double duration_s = 4;
  int delay_ms = 1;
  bool guarded = true;
};

struct Outcome {
  int acted = 0;              ///< ticks in which the guard changed a force
  double lowest_mj = 0;       ///< least W the guard saw
  double given_mj = 0;        ///< most energy that the true motion took out of the device, since the start
  double end_speed_mm_s = 0;  ///< rms over the last 0.5 s
};

/// 1 kHz, counted positions, forces that act `delay_ms` later and are capped at 2 N.
Outcome run(const Loop& loop, Source source) {  // by value: each run starts with a new state
  SimulatedBody body(loop.hand, {});
  PassivityGuard guard;
  guard.reset(0, 0);
  std::vector<double> forces(static_cast<std::size_t>(loop.delay_ms), 0);
  Outcome outcome;
  double energy_mj = 0;
  const int ticks = static_cast<int>(1000 * loop.duration_s);
  for (int i = 0; i < ticks; ++i) {
    const double position_mm = kCountMm * std::round(body.positionMm() / kCountMm);
    guard.observe((i + 1) * kMs, position_mm, forces.back(), 1e-3 * loop.delay_ms);
    const double asked_n = source(position_mm);
    const double guarded_n = guard.control(asked_n);
    outcome.acted += guarded_n != asked_n ? 1 : 0;
    outcome.lowest_mj = std::min(outcome.lowest_mj, guard.energyMj());
    forces.push_back(std::clamp(loop.guarded ? guarded_n : asked_n, -2.0, 2.0));

    const double acting_n = forces[static_cast<std::size_t>(i)];
    const double before_mm = body.positionMm();
    const HandTarget wish = loop.plan(1e-3 * i);
    for (int step = 0; step < 100; ++step) body.step(wish, acting_n, 1e-5);
    energy_mj += acting_n * (body.positionMm() - before_mm);
    outcome.given_mj = std::max(outcome.given_mj, -energy_mj);
    if (i >= ticks - 500) outcome.end_speed_mm_s += body.speedMmS() * body.speedMmS() / 500;
  }
  outcome.end_speed_mm_s = std::sqrt(outcome.end_speed_mm_s);
  return outcome;
}

/// -b times a speed that is low-passed with 5 ms.
Source negativeDamping(double damping_n_s_mm) {
  return [=, before_mm = 0.0, speed_mm_s = 0.0](double position_mm) mutable {
    speed_mm_s += (1 - std::exp(-1.0 / 5)) * (1000 * (position_mm - before_mm) - speed_mm_s);
    before_mm = position_mm;
    return -damping_n_s_mm * speed_mm_s;
  };
}

Source spring(double stiffness_n_mm) {
  return [=](double position_mm) { return stiffness_n_mm * position_mm; };
}

Source rendered(const render::RendererSettings& settings, double force_n) {
  return [=, state = render::RendererState{}](double position_mm) mutable {
    state =
        render::stepAsking(state, {position_mm, true, 0, {}}, settings, 0.001, [&](const render::ForcePoint& point) {
          return render::ModelForce{force_n + 0.0015 * point.speed_mm_s, true};
        });
    return state.force_n;
  };
}

// By hand, without a delay: 1 N held while the reference behind the play moves. 0.06 mm of play: 0.03 mm each way.
TEST(PassivityGuard, AddsForceTimesWay) {
  PassivityGuard guard;
  guard.reset(0, 0);
  guard.observe(kMs, 1.03, 1, 0);
  EXPECT_NEAR(guard.energyMj(), 1.0, 1e-3);  // mJ = N mm; less than stored at 0.1 N/mm: no leak
  guard.observe(2 * kMs, 0.47, 1, 0);
  EXPECT_NEAR(guard.energyMj(), 0.5, 1e-3);
}

TEST(PassivityGuard, PairsTheForceWithTheMotionAfterTheDelay) {
  PassivityGuard guard;
  guard.reset(0, 0);
  guard.observe(1 * kMs, 0, 1, 0.002);   // 1 N asked for at 0 acts from 2 to 3 ms
  guard.observe(2 * kMs, 10, 0, 0.002);  // moves without a force
  EXPECT_EQ(guard.energyMj(), 0);
  guard.observe(3 * kMs, 11, 0, 0.002);
  EXPECT_NEAR(guard.energyMj(), 1, 1e-3);
  guard.observe(4 * kMs, 20, 0, 0.002);
  EXPECT_NEAR(guard.energyMj(), 1, 1e-2);  // the force is over
}

// W = -1.5 mJ: half of 0.002 N s/mm. -3 mJ: all of it, and half of the force. -5 mJ: no force, only damping.
TEST(PassivityGuard, DampsFirstAndThenTakesTheForceAway) {
  const auto controlled = [](double given_mj) {
    PassivityGuard guard;
    guard.reset(0, 0);
    for (int i = 1; i <= 10; ++i) guard.observe(i * kMs, -0.03 - 0.1 * given_mj * i, 1, 0);
    // The filter of 1.6 ms has followed 10 steps of one speed.
    return std::pair(guard.control(1), -100 * given_mj);
  };
  const auto [none_n, slow] = controlled(0.9);
  EXPECT_EQ(none_n, 1);
  const auto [half_n, fast] = controlled(1.5);
  EXPECT_NEAR(half_n, 1 + 0.001 * fast, 0.01);
  const auto [faded_n, faster] = controlled(3);
  EXPECT_NEAR(faded_n, 0.5 - 0.5, 0.02);  // 0.002 x 300 is more than the largest damping of 0.5 N
  const auto [gone_n, fastest] = controlled(5);
  EXPECT_NEAR(gone_n, 0 - 0.5, 0.001);
  EXPECT_LT(fastest, faster);
  EXPECT_LT(fast, slow);
}

TEST(PassivityGuard, CreditIsCappedAndLeaks) {
  PassivityGuard guard;
  guard.reset(0, 0);
  for (int i = 1; i <= 1000; ++i) guard.observe(i * kMs, i, 1, 0);  // 1 J taken from the hand
  EXPECT_LE(guard.energyMj(), 1.0 / 0.2 + 2);                       // 1 N in a spring of 0.1 N/mm: 5 mJ, and 2 mJ
  for (int i = 1001; i <= 11000; ++i) guard.observe(i * kMs, 1000, 1, 0);
  EXPECT_NEAR(guard.energyMj(), 5, 0.01);  // what a spring could still hold
  for (int i = 11001; i <= 21000; ++i) guard.observe(i * kMs, 1000, 0, 0);
  EXPECT_NEAR(guard.energyMj(), 0, 0.01);
}

TEST(PassivityGuard, OneCountToAndFroMovesNothing) {
  PassivityGuard guard;
  guard.reset(0, 0);
  double position_mm = 0;
  double force_n = 0;
  for (int i = 1; i <= 20000; ++i) {
    position_mm = i % 2 == 0 ? 0 : kCountMm;
    guard.observe(i * kMs, position_mm, force_n, 0);
    force_n = 2 - 10 * position_mm;  // the worst a 10 N/mm source could do: -0.03 mJ a flicker
    ASSERT_EQ(guard.control(force_n), force_n);
  }
}

struct NamedPlan {
  const char* name;
  HandPlan plan;
  double duration_s;
};

TEST(PassivityGuard, NeverTouchesTheRendererInNormalUse) {
  const std::vector<NamedPlan> plans = {
      {"stroke", stroke(60, 0.8), 1.3},
      {"fast stroke", stroke(60, 0.4), 0.9},
      {"slow push", push(5), 3},
      {"tremor on a stuck tube", both(swing(0.3, 10), stroke(5, 1)), 3},
      {"tremor of a few counts", swing(0.1, 10), 3},
      {"reversals", swing(15, 0.8), 3},
      {"rest on the spring for 5 s, then back", both(stroke(12, 1), after(6, stroke(-12, 1))), 8},
  };
  // Each stiffness with the delays at which the servo renders it: half of 1.9 N s/m / (T / 2 + delay).
  const std::pair<double, int> springs[] = {{0.1, 3}, {0.25, 1}, {0.25, 2}, {0.4, 1}, {0.6, 1}};
  for (const auto& [stiffness_n_mm, delay_ms] : springs) {
    for (const SimulatedHand& hand : {kPinch, kArm, kFiveParameters}) {
      for (const NamedPlan& plan : plans) {
        for (const double force_n : {0.1, 0.4, 1.7}) {
          SCOPED_TRACE(std::string(plan.name) + ", " + std::string(hand.name) + ", k " +
                       std::to_string(stiffness_n_mm) + ", delay " + std::to_string(delay_ms) + ", F " +
                       std::to_string(force_n));
          render::RendererSettings settings;
          settings.friction.stiffness_n_mm = stiffness_n_mm;
          const Outcome outcome = run({hand, plan.plan, plan.duration_s, delay_ms}, rendered(settings, force_n));
          EXPECT_EQ(outcome.acted, 0);
          EXPECT_GE(outcome.lowest_mj, -0.5);  // half of what the guard allows
        }
      }
    }
  }
}

TEST(PassivityGuard, LeavesASpringADamperAndDryFrictionAlone) {
  const Source damper = [before_mm = 0.0, speed = 0.0](double position_mm) mutable {
    speed += 0.15 * (1000 * (position_mm - before_mm) - speed);  // 25 Hz
    before_mm = position_mm;
    return 0.002 * speed;
  };
  const Source friction = [anchor_mm = 0.0](double position_mm) mutable {
    anchor_mm = std::clamp(anchor_mm, position_mm - 2, position_mm + 2);
    return 0.25 * (position_mm - anchor_mm);
  };
  for (const Source& source : {spring(0.3), damper, friction})
    for (const HandPlan& plan : {swing(15, 0.8), swing(1, 4), stroke(60, 0.4)})
      EXPECT_EQ(run({kPinch, plan, 4, 1}, source).acted, 0);
}

// What a guarded source may give: 4 mJ at once, a deficit that leaks with 1.5 s, and what moves while the force goes.
constexpr double kLargestGiftMj = 4 + 4 * 4 / 1.5 + 6;

TEST(PassivityGuard, BoundsTheEnergyOfNegativeDamping) {
  const HandPlan disturbed = both(swing(2, 2), stroke(3, 0.3));
  for (const SimulatedHand& hand : {kPinch, kArm}) {
    for (const double damping_n_s_mm : {0.003, 0.010}) {
      SCOPED_TRACE(std::string(hand.name) + ", b " + std::to_string(damping_n_s_mm));
      const Outcome wild = run({hand, disturbed, 4, 1, false}, negativeDamping(damping_n_s_mm));
      const Outcome held = run({hand, disturbed, 4, 1, true}, negativeDamping(damping_n_s_mm));
      EXPECT_LE(held.given_mj, kLargestGiftMj);
      EXPECT_LT(held.given_mj, wild.given_mj);
      EXPECT_LT(held.end_speed_mm_s, 40);  // the hand's own swing is 25 mm/s at most
    }
  }
  EXPECT_GT(run({kPinch, disturbed, 4, 1, false}, negativeDamping(0.01)).given_mj, 1000);
}

TEST(PassivityGuard, BoundsTheEnergyOfASpringTooStiffForItsDelay) {
  for (const auto& [stiffness_n_mm, delay_ms] : {std::pair(3.0, 6), std::pair(6.0, 3), std::pair(6.0, 6)}) {
    SCOPED_TRACE(std::to_string(stiffness_n_mm) + " N/mm, " + std::to_string(delay_ms) + " ms");
    const Outcome wild = run({kPinch, stroke(1, 0.1), 4, delay_ms, false}, spring(stiffness_n_mm));
    const Outcome held = run({kPinch, stroke(1, 0.1), 4, delay_ms, true}, spring(stiffness_n_mm));
    EXPECT_GT(wild.given_mj, 300);
    EXPECT_LE(held.given_mj, kLargestGiftMj);
    EXPECT_LT(held.end_speed_mm_s, wild.end_speed_mm_s / 5);
  }
}

// A second long credit must not hide what comes later.
TEST(PassivityGuard, SeesActivityAfterALongPassiveTime) {
  const auto source = [brake = negativeDamping(-0.002), active = negativeDamping(0.01), ticks = 0](double x) mutable {
    const double braked_n = brake(x);
    const double driven_n = active(x);
    return ++ticks < 10000 ? braked_n : driven_n;
  };
  const HandPlan plan = swing(15, 0.8);
  const Outcome held = run({kPinch, plan, 14, 1, true}, source);
  EXPECT_GT(held.acted, 0);
  EXPECT_LT(held.end_speed_mm_s, 80);  // 15 mm at 0.8 Hz alone: 53 mm/s rms
}

TEST(PassivityGuard, AddsAtMostHalfANewton) {
  base::Random random(5);
  PassivityGuard guard;
  guard.reset(0, 0);
  double position_mm = 0;
  for (int i = 1; i < 20000; ++i) {
    position_mm += random.uniform(-3, 3);
    guard.observe(i * kMs, position_mm, random.uniform(-3, 3), 0.001 * random.below(5));
    const double asked_n = random.uniform(-3, 3);
    const double guarded_n = guard.control(asked_n);
    const double low_n = std::min(0.0, asked_n) - 0.5;
    const double high_n = std::max(0.0, asked_n) + 0.5;
    ASSERT_TRUE(guarded_n >= low_n && guarded_n <= high_n) << i;
  }
}

TEST(PassivityGuard, AtRestNothingOfItDecaysIntoSubnormalNumbers) {
  for (const double way_mm : {1.0, -1.0}) {
    PassivityGuard guard;
    guard.reset(0, 0);
    std::int64_t now_ns = 0;
    for (int i = 1; i <= 10; ++i) guard.observe(now_ns += kMs, i * way_mm / 10, 0.5, 0.001);
    EXPECT_NE(guard.energyMj(), 0);
    std::feclearexcept(FE_ALL_EXCEPT);
    for (int i = 0; i < 2'000'000; ++i) guard.observe(now_ns += kMs, way_mm, 0, 0.001);  // 33 minutes
    EXPECT_EQ(guard.energyMj(), 0);
    EXPECT_EQ(std::fetestexcept(FE_UNDERFLOW), 0);
  }
}

}  // namespace
}  // namespace tactus::haptics
