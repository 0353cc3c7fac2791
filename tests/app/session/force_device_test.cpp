#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "app/session/judged_forces.h"

namespace tactus::session {
namespace {

using experiments::ForceSettings;

std::string refusal(const ForceSettings& settings, const haptics::LimitSettings& limits = {}) {
  const auto ok = requireHolds(settings, limits);
  return ok ? "" : ok.error().message();
}

TEST(ForceDevice, ATouchHoldsThePapersLadder) { EXPECT_EQ(refusal({}), ""); }

TEST(ForceDevice, AForceAboveTheCapIsRefused) {
  ForceSettings settings;
  settings.ladder.highest_n = 2.2;
  EXPECT_EQ(refusal(settings), "ladder.highest_n: found 2.2 N, wanted at most 2 N, the force cap of the device");
  settings.ladder.highest_n = 1.7;
  settings.familiarisation_n = {0.1, 2.5};
  EXPECT_EQ(refusal(settings), "familiarisation_n: found 2.5 N, wanted at most 2 N, the force cap of the device");
}

// Motors of 0.3 N continuously: 0.3² · 60 = 5.4 N²s; for 3 s with a ramp of 0.15 s, 2 s in reserve and a tick,
// F² (3.052 + 2) = 5.4, F = 1.034 N.
TEST(ForceDevice, AForceThatColdMotorsCannotHoldIsRefused) {
  haptics::LimitSettings weak;
  weak.continuous_force_n = 0.3;
  ForceSettings strong;
  strong.familiarisation_n = {0.1, 1.1};
  EXPECT_EQ(refusal(strong, weak),
            "familiarisation_n: found 1.1 N for 3 s, wanted at most 1.03 N, which the motors of the device can hold so "
            "long");
  ForceSettings low;
  low.familiarisation_n = {};
  low.ladder.highest_n = 1;
  EXPECT_EQ(refusal(low, weak), "");
  low.random = true;  // to 1.1 N
  EXPECT_NE(refusal(low, weak).find("random_steps.highest_n: found 1.1 N for 3 s"), std::string::npos);
}

// At 1 : 3 the ladder of three times the forces is what the paper's ladder is at 1 : 1, and refused at the same place.
TEST(ForceDevice, AScaleGoesAsFarBeyondTheDevice) {
  ForceSettings settings;
  settings.device_scale = 3;
  settings.continuous_n *= 3;
  settings.ladder = {0.3, 5.1, 0.3};
  settings.familiarisation_n = {1.5};
  EXPECT_TRUE(experiments::validate(settings));
  EXPECT_EQ(refusal(settings), "");
  settings.ladder.highest_n = 6.3;
  EXPECT_EQ(refusal(settings),
            "ladder.highest_n: found 6.3 N, wanted at most 6 N, the force cap of the device at 1 : 3");
  settings.ladder.highest_n = 9.3;
  EXPECT_FALSE(experiments::validate(settings));
  settings.device_scale = 0.5;
  EXPECT_FALSE(experiments::validate(settings));
}

// The servo ends what is above the rating after 3 s, whatever the settings ask for.
TEST(ForceDevice, TheServosOwnTimeLimitCounts) {
  ForceSettings longer;
  longer.hold_limit_s = 60;
  EXPECT_EQ(refusal(longer), "");
}

/// The whole series under a budget that follows it; each force is felt `times`, with no more than the pause that is
/// told. Returns the least share of a force that was delivered.
double leastShareOfSeries(int times) {
  const haptics::LimitSettings limits;
  haptics::ThermalBudget budget;
  std::int64_t now_ns = 0;
  double held_n = 0;
  double least = 1;
  const auto tick = [&](double wanted_n) {
    now_ns += 1'000'000;
    budget.advance(now_ns, held_n, limits.continuous_force_n, limits.thermal_window_s);
    held_n = std::min(wanted_n, budget.ceilingN());
    return wanted_n > 0 ? held_n / wanted_n : 1;
  };
  tick(0);
  auto protocol = *experiments::ForceProtocol::create({}, 1);
  for (std::uint64_t id = 1; !protocol.next().finished; ++id) {
    const auto plan = protocol.next();
    for (int i = 0; i < times; ++i) {
      const double pause_s = pauseBeforeS(plan, budget, limits);
      EXPECT_GE(pause_s, plan.pause_before_s);
      for (int ms = 0; ms < std::ceil(1000 * pause_s); ++ms) tick(0);
      for (int ms = 1; ms <= 150; ++ms) tick(plan.step.force_n * ms / 150);
      for (int ms = 0; ms < 3000; ++ms) least = std::min(least, tick(plan.step.force_n));
      for (int ms = 149; ms >= 0; --ms) tick(plan.step.force_n * ms / 150);
    }
    experiments::ForceAnswer answer{study::ForceJudgement::Kind::kNoAnswer, "", 0, 25, 40, 1.5};
    auto record = *protocol.record(answer);
    record.entry.id.bytes.back() = static_cast<std::uint8_t>(id);
    EXPECT_TRUE(protocol.add(record));
  }
  return least;
}

TEST(ForceDevice, WithThePausesEveryForceOfTheDefaultProtocolIsDelivered) {
  EXPECT_EQ(leastShareOfSeries(1), 1);
  EXPECT_EQ(leastShareOfSeries(2), 1);
}

}  // namespace
}  // namespace tactus::session
