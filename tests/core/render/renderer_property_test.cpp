// What holds for every parameter in its range and every motion.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "core/base/random.h"
#include "core/render/insertion_renderer.h"

#include "tests/core/render/scripted_tube.h"

namespace tactus::render {
namespace {

using base::Random;

/// Each parameter at an end of its range, or anywhere in it; small values as likely as large ones.
RendererSettings randomSettings(Random& random) {
  RendererSettings settings;
  for (const auto& field : fuzzy::kRendererFields) {
    double& value = settings.friction.*field.member;
    const int kind = random.below(10);
    const double lowest = field.min_excluded ? field.max * 1e-9 : field.min;
    if (kind == 0) value = lowest;
    if (kind == 1) value = field.max;
    if (kind > 1 && kind < 6) value = random.uniform(lowest, field.max);
    if (kind > 7 && field.min >= 0) value = field.max * std::pow(10, random.uniform(-6, 0));
  }
  settings.force_cap_n = random.uniform(0.1, 3);
  if (random.below(2) == 0) settings.depth_end_mm = settings.friction.depth_offset_mm + random.uniform(0, 300);
  return settings;
}

/// A hand that pushes, trembles, jumps, rests, and lets go now and then.
class RandomHand {
 public:
  explicit RandomHand(Random& random) : random_(random) {}

  RendererInput next() {
    if (random_.below(80) == 0) speed_mm_ = random_.below(3) == 0 ? 0 : 0.3 * random_.normal();
    if (random_.below(400) == 0) position_mm_ += 20 * random_.normal();
    if (random_.below(300) == 0) held_ = !held_;
    if (random_.below(200) == 0) ++conditions_;
    position_mm_ += speed_mm_ + 0.02 * random_.normal();
    return {0.055 * std::round(position_mm_ / 0.055), held_, conditions_, {}};
  }

 private:
  Random& random_;
  double position_mm_ = 0, speed_mm_ = 0;
  bool held_ = true;
  std::uint64_t conditions_ = 0;
};

double stored(const RendererState& state, const RendererSettings& settings) {
  return settings.friction.stiffness_n_mm * state.stretch_mm * state.stretch_mm / 2;
}

TEST(RendererProperties, HoldForEveryParameterAndMotion) {
  Random random(20261121);
  for (int run = 0; run < 300; ++run) {
    SCOPED_TRACE(run);
    const RendererSettings settings = randomSettings(random);
    const auto& friction = settings.friction;
    const double deepest_mm = settings.depth_end_mm - friction.depth_offset_mm;
    const double most_model_n = random.uniform(0, 2);
    // Friction is never more than this, in whatever direction and state.
    const double gain = (1 + friction.breakaway_ratio) * std::max(1.0, friction.withdrawal_ratio);
    const double most_n = std::min(settings.force_cap_n, gain * most_model_n);
    RandomHand hand(random);
    RendererState state;
    double taken = 0;
    for (int i = 0; i < 1500; ++i) {
      const double dt_s = random.below(50) == 0 ? random.uniform(0.0005, 0.006) : 0.001;
      const RendererInput input = hand.next();
      const RendererState before = state;
      state = stepAsking(state, input, settings, dt_s, [&](const ForcePoint& point) -> ModelForce {
        EXPECT_TRUE(std::isfinite(point.depth_mm) && point.speed_mm_s >= 0);
        return {random.uniform(0, most_model_n), random.below(20) != 0};
      });
      ASSERT_TRUE(std::isfinite(state.force_n) && std::isfinite(state.depth_mm) && std::isfinite(state.stretch_mm));
      ASSERT_LE(std::abs(state.force_n), settings.force_cap_n);
      ASSERT_TRUE(state.depth_mm >= 0 && state.depth_mm <= std::max(0.0, deepest_mm));

      const double k = friction.stiffness_n_mm;
      const double spring_n = k * state.stretch_mm;
      ASSERT_LE(std::abs(spring_n), most_n * (1 + 1e-12));
      const double moved_mm = before.position_mm ? *state.position_mm - *before.position_mm : 0;
      const bool rubbed = before.phase != Phase::kReleased;
      if (rubbed) taken += k * before.stretch_mm * moved_mm + k * moved_mm * moved_mm / 2;
      ASSERT_GE(taken - stored(state, settings), -1e-12 * (1 + taken));

      if (!rubbed || state.phase == Phase::kReleased) {
        ASSERT_TRUE(state.depth_mm == before.depth_mm) << "depth is counted while a stroke lasts, only";
        continue;
      }
      // The spring follows the hand, its clip follows the slew and two relaxations; nothing else moves it.
      const double slew_n = gain * friction.slew_n_s * dt_s;
      const double relaxed_n = most_n * (1 - decay(dt_s, std::min(friction.relaxation_s, kTubeOutS)));
      ASSERT_LE(std::abs(spring_n - k * before.stretch_mm), k * std::abs(moved_mm) + slew_n + relaxed_n + 1e-12);
      // Slip is what the spring does not take up, and never goes the other way.
      const double slip_mm = moved_mm - (state.stretch_mm - before.stretch_mm);
      const bool inside = state.depth_mm > 0 && state.depth_mm < deepest_mm && before.depth_mm > 0;
      ASSERT_TRUE(!inside || std::abs(state.depth_mm - before.depth_mm - slip_mm) <= 1e-10);
    }
  }
}

TEST(RendererProperties, PathIsCutIntoTicksAtWill) {
  // Without surplus and with a constant force nothing depends on time: how a path is sampled cannot matter.
  Random random(7);
  for (int run = 0; run < 100; ++run) {
    ScriptedTube coarse;
    coarse.settings.friction.breakaway_ratio = 0;
    coarse.settings.friction.withdrawal_ratio = random.uniform(0.1, 2);
    coarse.settings.friction.restick_mm = random.uniform(0, 1);
    coarse.settings.friction.stick_time_s = 10;
    coarse.state.depth_mm = 500;
    coarse.tick(0);
    ScriptedTube fine = coarse;
    for (int turn = 0; turn < 30; ++turn) {
      const double to_mm = random.uniform(-20, 20);
      coarse.moveTo(to_mm, 1 + random.below(5));
      fine.dt_s = 0.0002;
      fine.moveTo(to_mm, 1 + random.below(60));
      ASSERT_NEAR(coarse.state.depth_mm, fine.state.depth_mm, 1e-9);
      ASSERT_NEAR(coarse.state.stretch_mm, fine.state.stretch_mm, 1e-9);
    }
  }
}

TEST(RendererProperties, FinerTicksFeelTheSame) {
  // With all that depends on time, 1 kHz and 4 kHz differ by what happens within a tick: a relaxation of 10 ms and
  // filters of 6 ms seen 0.5 ms later on the mean, some 5 % of the 0.06 N of break-away and of the speed's 0.2 N.
  std::vector<double> force_n[2];
  double depth_mm[2];
  for (int rate = 0; rate < 2; ++rate) {
    const int parts = rate == 0 ? 1 : 4;
    RendererState state;
    for (int i = 0; i < 1000 * parts; ++i) {
      const double u = std::min(1.0, i * 0.001 / parts / 0.8);
      const RendererInput input{60 * u * u * u * (10 - 15 * u + 6 * u * u), true, 0, {}};
      state = stepAsking(state, input, {}, 0.001 / parts, [](const ForcePoint& point) -> ModelForce {
        return {0.35 + 0.0015 * point.speed_mm_s, true};
      });
      if (i % parts == 0) force_n[rate].push_back(state.force_n);
    }
    depth_mm[rate] = state.depth_mm;
  }
  for (std::size_t i = 0; i < force_n[0].size(); ++i) ASSERT_NEAR(force_n[0][i], force_n[1][i], 0.013) << i;
  EXPECT_NEAR(depth_mm[0], depth_mm[1], 0.055);
}

TEST(RendererProperties, ClosedPathNeverGivesEnergy) {
  // Round and round from rest to rest: what the force takes from the hand is not negative.
  Random random(11);
  for (int run = 0; run < 50; ++run) {
    ScriptedTube tube;
    tube.state.depth_mm = 300;
    tube.tick(0);
    double taken = 0;
    for (int turn = 0; turn < 10; ++turn) {
      const double from_mm = *tube.state.position_mm;
      const double to_mm = turn == 9 ? 0 : random.uniform(-15, 15);
      for (int i = 1; i <= 200; ++i) {
        const double before_mm = *tube.state.position_mm;
        const double before_n = tube.state.force_n;
        tube.tick(from_mm + (to_mm - from_mm) * i / 200);
        // The mean of both forces removes what the hold of one tick adds or hides.
        taken += 0.5 * (before_n + tube.state.force_n) * (*tube.state.position_mm - before_mm);
      }
    }
    EXPECT_GT(taken, 0);
  }
}

TEST(RendererProperties, EditsWhileThePushLastsMakeNoEnergy) {
  Random random(3);
  for (int run = 0; run < 100; ++run) {
    RendererSettings settings = randomSettings(random);
    RandomHand hand(random);
    RendererState state;
    double taken = 0;
    for (int i = 0; i < 1000; ++i) {
      if (random.below(100) == 0) settings = randomSettings(random);
      const RendererState before = state;
      state = stepAsking(state, hand.next(), settings, 0.001, [&](const ForcePoint&) -> ModelForce {
        return {random.uniform(0, 2), true};
      });
      ASSERT_TRUE(std::isfinite(state.force_n) && std::abs(state.force_n) <= settings.force_cap_n);
      if (before.phase == Phase::kReleased) continue;
      // The spring begins the tick with the smaller of its old stretch and the stretch of its old force.
      const double k = settings.friction.stiffness_n_mm;
      const double begin_mm = before.stretch_mm * std::min(1.0, before.stiffness_n_mm / k);
      const double moved_mm = *state.position_mm - *before.position_mm;
      taken += k * begin_mm * moved_mm + k * moved_mm * moved_mm / 2;
      ASSERT_GE(taken - stored(state, settings), -1e-12 * (1 + taken));
    }
  }
}

}  // namespace
}  // namespace tactus::render
