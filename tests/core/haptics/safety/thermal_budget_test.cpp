#include "core/haptics/safety/thermal_budget.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <vector>

#include "core/base/random.h"

#include "tests/core/haptics/loop_numbers.h"
#include "tests/core/haptics/safety/thermal_rating.h"

namespace tactus::haptics {
namespace {

/// Force over time as it was given, and the largest rms of any window that begins or ends at a tick. Between two ticks
/// the force is constant, so that the largest of all windows is one of these.
struct History {
  std::vector<double> time_s{0};
  std::vector<double> spent_n2s{0};  ///< integral of F² so far
  double largest_n = 0;

  void hold(double force_n, double seconds) {
    time_s.push_back(time_s.back() + seconds);
    spent_n2s.push_back(spent_n2s.back() + force_n * force_n * seconds);
    largest_n = std::max(largest_n, std::abs(force_n));
  }
  double spentUntil(double at_s) const {
    if (at_s <= 0) return 0;
    const auto after = std::lower_bound(time_s.begin(), time_s.end(), at_s);
    if (after == time_s.end()) return spent_n2s.back();
    const auto i = static_cast<std::size_t>(after - time_s.begin());
    const double share = (at_s - time_s[i - 1]) / (time_s[i] - time_s[i - 1]);
    return spent_n2s[i - 1] + share * (spent_n2s[i] - spent_n2s[i - 1]);
  }
  double largestRms(double window_s) const {
    double most = 0;
    for (const double t : time_s) {
      most = std::max(most, spentUntil(t) - spentUntil(t - window_s));
      most = std::max(most, spentUntil(t + window_s) - spentUntil(t));
    }
    return std::sqrt(most / window_s);
  }
};

struct Demand {
  double wanted_n = 0;
  double seconds = 0.001;
};

History run(ThermalBudget& budget, int steps, const std::function<Demand(int)>& script) {
  History history;
  std::int64_t now_ns = 5'000'000'000;
  double held_n = 0;
  budget.advance(now_ns, held_n, kRatingN, kWindowS);
  for (int i = 0; i < steps; ++i) {
    const Demand step = script(i);
    held_n = std::clamp(step.wanted_n, -budget.ceilingN(), budget.ceilingN());
    const auto step_ns = static_cast<std::int64_t>(1e9 * step.seconds);
    now_ns += step_ns;
    history.hold(held_n, 1e-9 * static_cast<double>(step_ns));
    budget.advance(now_ns, held_n, kRatingN, kWindowS);
  }
  return history;
}

TEST(ThermalBudget, LeavesAnOrdinaryStrokeAlone) {
  ThermalBudget budget;
  // 1.7 N for 3 s is 8.7 of 46.5 N²s.
  const History history = run(budget, 3000, [](int) { return Demand{1.7}; });
  EXPECT_NEAR(history.spent_n2s.back(), 1.7 * 1.7 * 3, 1e-9);
  EXPECT_NEAR(budget.share(), 8.67 / 46.464, 1e-9);
}

TEST(ThermalBudget, TheRatingItselfIsHeldAlmostForEver) {
  ThermalBudget budget;
  // 0.6 N rms is less than half of the budget: never limited, whatever is older than the window is forgotten.
  const History history = run(budget, 200000, [](int) { return Demand{0.6}; });
  EXPECT_NEAR(history.spent_n2s.back(), 0.36 * 200, 1e-6);
  // At most one part of 0.5 s more than the window counts.
  EXPECT_LE(budget.share(), 0.36 * 60.5 / 46.464 + 1e-9);
  EXPECT_GE(budget.share(), 0.36 * 60 / 46.464 - 1e-3);
}

// Closed form: while F = 2 N the rest of the budget falls by 4 N²s a second; below 8 N²s the ceiling sqrt(rest / 2 s)
// takes over, and F² falls with a time constant of 2 s.
TEST(ThermalBudget, FadesBeforeTheBudgetIsUsedUpWithoutAStep) {
  ThermalBudget budget;
  double before_n = 2;
  double largest_step_n = 0;
  std::vector<double> force;
  run(budget, 30000, [&](int) {
    const double now_n = std::min(2.0, budget.ceilingN());
    largest_step_n = std::max(largest_step_n, before_n - now_n);
    before_n = now_n;
    force.push_back(now_n);
    return Demand{2};
  });
  const double full_s = (kRatingN * kRatingN * kWindowS - 8) / 4;  // 9.6 s
  EXPECT_EQ(force[static_cast<std::size_t>(1000 * full_s) - 5], 2);
  EXPECT_LT(force[static_cast<std::size_t>(1000 * full_s) + 50], 2);
  const auto later = static_cast<std::size_t>(1000 * (full_s + 4));
  EXPECT_NEAR(force[later], 2 * std::exp(-1.0), 2e-3);  // 4 s later F is down by e; 1 ms steps make 0.1 %
  EXPECT_LE(largest_step_n, 0.001 * 0.5 * 1.001);       // F / 4 s at most
  EXPECT_GT(budget.share(), 0.99);
}

TEST(ThermalBudget, ComesBackSlowly) {
  ThermalBudget budget;
  double before_n = 10;
  run(budget, 200000, [&](int) {
    EXPECT_LE(budget.ceilingN() - before_n, 0.001 * 0.5 + 1e-12);  // 0.5 N/s
    before_n = budget.ceilingN();
    return Demand{2};
  });
}

TEST(ThermalBudget, NoWindowExceedsTheRatingWhateverIsAsked) {
  double most_n = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    base::Random random(seed);
    ThermalBudget budget;
    double wanted_n = 0;
    int left = 0;
    const bool coarse = seed % 2 == 0;
    const History history = run(budget, 20000, [&](int) {
      if (left-- <= 0) {
        wanted_n = random.below(3) == 0 ? 0 : random.uniform(-3, 3);
        if (random.below(3) == 0) wanted_n = 3;
        left = random.below(4000);
      }
      double seconds = coarse ? random.uniform(0.001, 0.03) : 0.01;
      if (random.below(500) == 0) seconds = random.uniform(0.01, 1.9);  // stalls
      return Demand{wanted_n, seconds};
    });
    // Sums of 20000 terms: rounding.
    EXPECT_LE(history.largestRms(kWindowS), kRatingN * (1 + 1e-9));
    most_n = std::max(most_n, history.largest_n);
  }
  EXPECT_EQ(most_n, 3);
}

TEST(ThermalBudget, AnotherWindowForgetsNothing) {
  ThermalBudget budget;
  run(budget, 8000, [](int) { return Demand{2}; });  // 32 N²s until 13 s
  budget.advance(13'000 * kMs, 0, kRatingN, 120);
  EXPECT_NEAR(budget.share(), 32 / (kRatingN * kRatingN * 120), 1e-9);
  budget.advance(130'000 * kMs, 0, kRatingN, 120);
  EXPECT_NEAR(budget.share(), 32 / (kRatingN * kRatingN * 120), 1e-9);
  budget.advance(135'000 * kMs, 0, kRatingN, 120);  // 120 s and one part of 1 s later
  EXPECT_EQ(budget.share(), 0);
}

TEST(ThermalBudget, ADeviceWithoutARatingGivesNothing) {
  ThermalBudget budget;
  budget.advance(kMs, 0, 0, kWindowS);
  EXPECT_EQ(budget.ceilingN(), 0);
  EXPECT_EQ(budget.share(), 1);
}

}  // namespace
}  // namespace tactus::haptics
