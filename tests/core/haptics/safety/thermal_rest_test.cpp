// The rest before a force: by hand, and against the budget of a servo tick by tick.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "core/base/random.h"
#include "core/haptics/safety/thermal_budget.h"

#include "tests/core/haptics/loop_numbers.h"
#include "tests/core/haptics/safety/thermal_rating.h"

namespace tactus::haptics {
namespace {

/// Of restBeforeS for ticks, and its effect on the time at which a load is forgotten.
constexpr double kTickMarginS = 0.005;

/// Motors under the budget, tick by tick.
struct Motors {
  ThermalBudget budget;
  std::int64_t now_ns = 0;
  double held_n = 0;
  double least_share = 1;  ///< of the wanted force, while it was wanted in full

  Motors() { budget.advance(0, 0, kRatingN, kWindowS); }
  void want(double force_n, bool full) {
    now_ns += kTickNs;
    budget.advance(now_ns, held_n, kRatingN, kWindowS);
    held_n = std::min(force_n, budget.ceilingN());
    if (full && force_n > 0) least_share = std::min(least_share, held_n / force_n);
  }
  void rest(double seconds) {
    const auto ticks = static_cast<int>(std::ceil(1000 * seconds));
    for (int i = 0; i < ticks; ++i) want(0, false);
  }
  /// Ramp up, hold, ramp down.
  void hold(const PlannedHold& planned) {
    const int ramp = static_cast<int>(std::lround(1000 * planned.ramp_s));
    for (int i = 1; i <= ramp; ++i) want(planned.force_n * i / ramp, false);
    const int full = static_cast<int>(std::lround(1000 * planned.hold_s));
    for (int i = 0; i < full; ++i) want(planned.force_n, true);
    for (int i = ramp - 1; i >= 0; --i) want(planned.force_n * i / std::max(1, ramp), false);
    want(0, false);
  }
  double share(const PlannedHold& planned) {
    least_share = 1;
    hold(planned);
    return least_share;
  }
  std::optional<double> restBefore(const PlannedHold& planned) const {
    return restBeforeS(budget, planned, kRatingN, kWindowS);
  }
};

TEST(ThermalRest, ColdMotorsNeedNone) {
  EXPECT_EQ(restBeforeS({}, {1.7, 0.15, 3}, kRatingN, kWindowS), 0);
  EXPECT_EQ(restBeforeS({}, {0, 0.15, 3}, kRatingN, kWindowS), 0);
}

// 0.88² · 60 = 46.464 N²s. Held for 3 s (0.05 s of heat in the ramp of 0.15 s, 0.002 s for a tick) with 2 s in reserve:
// F² (3.052 + 2) = 46.464, F = 3.0327 N. Held for 14 s: F² · 16.052 = 46.464, F = 1.7013 N.
TEST(ThermalRest, ColdMotorsHaveALargestForce) {
  EXPECT_NEAR(largestHoldN(0.15, 3, kRatingN, kWindowS), 3.0327, 1e-4);
  EXPECT_NEAR(largestHoldN(0.15, 14, kRatingN, kWindowS), 1.7013, 1e-4);
  EXPECT_TRUE(restBeforeS({}, {1.70, 0.15, 14}, kRatingN, kWindowS));
  EXPECT_FALSE(restBeforeS({}, {1.71, 0.15, 14}, kRatingN, kWindowS));
}

// Four times 1.7 N for 3 s, from 0, 6, 12 and 18 s on: 4 · 8.67 = 34.68 N²s at 21 s. Beside 1.7 N, of which 2 s stay in
// reserve, 46.464 - 5.78 = 40.684 N²s may be spent. The first 0.5 s are forgotten at 60.5 s, the next at 61 s. Until
// 61 s there is room for 40.684 - 34.68 + 1.445 = 7.449 N²s, 2.5775 s of 1.7 N: the fifth begins at 58.4225 s, after a
// rest of 37.4225 s.
TEST(ThermalRest, ByHand) {
  Motors motors;
  for (int i = 0; i < 4; ++i) {
    motors.hold({1.7, 0, 3});
    if (i < 3) motors.rest(3 - 0.001);  // hold ends with a tick of 0 N
  }
  const auto rest_s = motors.restBefore({1.7, 0, 3});
  ASSERT_TRUE(rest_s);
  EXPECT_NEAR(*rest_s, 37.4225, kTickMarginS);
}

// The ceiling comes back by 0.5 N/s: from 0.8 N to 1.7 N in 1.8 s, if no load is in the way.
TEST(ThermalRest, TheCeilingNeedsTimeToComeBack) {
  ThermalBudget budget;
  budget.advance(0, 0, 0.1, kWindowS);  // 0.1² · 60 = 0.6 N²s: the ceiling is sqrt(0.3) N
  const auto rest_s = restBeforeS(budget, {1.7, 0, 1}, kRatingN, kWindowS);
  ASSERT_TRUE(rest_s);
  EXPECT_NEAR(*rest_s, 2 * (1.7 - std::sqrt(0.3)), 1e-9);
}

/// The ascending series of the paper, 0.1 to 1.7 N in steps of 0.1 N, each force felt `times`.
std::vector<double> seriesFeltEach(int times) {
  std::vector<double> forces;
  for (int i = 1; i <= 17; ++i) forces.insert(forces.end(), static_cast<std::size_t>(times), 0.1 * i);
  return forces;
}

/// The least share of each force of the series that was delivered; held for 3 s, after a pause of 3 s or a longer rest.
std::vector<double> shares(const std::vector<double>& forces, bool rests, double* rested_s = nullptr) {
  Motors motors;
  std::vector<double> found;
  for (const double force_n : forces) {
    const PlannedHold planned{force_n, 0.15, 3};
    const double needed_s = rests ? motors.restBefore(planned).value_or(1e9) : 0;
    motors.rest(std::max(3.0, needed_s));
    if (rested_s != nullptr) *rested_s += std::max(0.0, needed_s - 3);
    found.push_back(motors.share(planned));
  }
  return found;
}

TEST(ThermalRest, WithoutItTheLastStepsAreCut) {
  const auto once = shares(seriesFeltEach(1), false);
  EXPECT_EQ(once.front(), 1);
  EXPECT_LT(1.7 * once.back(), 0.95);  // 0.90 N of 1.7 N
  const auto twice = shares(seriesFeltEach(2), false);
  EXPECT_EQ(twice[2 * 12], 1);      // 1.3 N
  EXPECT_LT(twice[2 * 13 + 1], 1);  // from 1.4 N on
}

TEST(ThermalRest, WithItEveryForceIsDeliveredInFull) {
  for (const int times : {1, 2, 3}) {
    double rested_s = 0;
    for (const double share : shares(seriesFeltEach(times), true, &rested_s)) EXPECT_EQ(share, 1) << times;
    EXPECT_GT(rested_s, 0);
    RecordProperty("rested_s_" + std::to_string(times), std::to_string(rested_s));
  }
}

/// The ceiling is exactly at its limit where the rest is as short as allowed: a little less is too short.
TEST(ThermalRest, IsAsShortAsItCanBeAndLongEnough) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    base::Random random(seed);
    Motors before;
    for (int i = 0; i < 14; ++i) {
      before.rest(random.uniform(0, 4));
      before.hold({random.uniform(0.5, 2), random.uniform(0.01, 0.3), random.uniform(0.5, 5)});
    }
    const PlannedHold planned{random.uniform(0.8, 2), random.uniform(0.01, 0.3), random.uniform(0.5, 5)};
    const auto rest_s = before.restBefore(planned);
    ASSERT_TRUE(rest_s);
    const auto lowest_ceiling = [&](double seconds) {
      Motors motors = before;
      motors.rest(seconds);
      double least_n = motors.budget.ceilingN();
      const int ramp = static_cast<int>(std::lround(1000 * planned.ramp_s));
      const int ticks = ramp + static_cast<int>(std::lround(1000 * planned.hold_s));
      for (int i = 1; i <= ticks; ++i) {
        motors.want(planned.force_n * std::min(1.0, static_cast<double>(i) / std::max(1, ramp)), false);
        least_n = std::min(least_n, motors.budget.ceilingN());
      }
      return least_n;
    };
    for (const double longer_s : {0.0, 0.1, 0.6, 7.0}) EXPECT_GE(lowest_ceiling(*rest_s + longer_s), planned.force_n);
    if (*rest_s > 0.1) {
      EXPECT_LT(lowest_ceiling(*rest_s - 2 * kTickMarginS), planned.force_n);
    }
  }
}

}  // namespace
}  // namespace tactus::haptics
