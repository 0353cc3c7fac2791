#include "experiments/force_series.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace tactus::experiments {
namespace {

TEST(ForceSeries, TheAscendingSeriesIsThePapers) {
  const auto series = ascendingSeries({});
  ASSERT_EQ(series.size(), 17U);
  for (int i = 0; i < 17; ++i) {
    const auto& step = series[static_cast<std::size_t>(i)];
    EXPECT_EQ(step.force_n, (i + 1) / 10.0);  // exactly: 0.3, not 0.30000000000000004
    EXPECT_EQ(step.step, i + 1);
    EXPECT_EQ(step.series, "ascending");
  }
}

TEST(ForceSeries, TheDescendingSeriesStartsAtMostTwoStepsLower) {
  ForceSettings settings;
  std::map<double, int> starts;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) ++starts[descendingStart(settings, 1.2, seed)];
  ASSERT_EQ(starts.size(), 3U);
  for (const double start_n : {1.0, 1.1, 1.2}) EXPECT_NEAR(starts[start_n], 333, 75);  // five standard deviations of 15
  EXPECT_GE(descendingStart(settings, 0.1, 3), 0.1);

  const auto series = descendingSeries(settings, 0.4);
  ASSERT_EQ(series.size(), 4U);
  EXPECT_EQ(series[0].force_n, 0.4);
  EXPECT_EQ(series[3].force_n, 0.1);
  EXPECT_EQ(series[3].step, 4);
}

// Of 200 seeds each: ladders whose catch trials can be told apart from their steps by the mark alone.
TEST(ForceSeries, CatchTrialsStandBetweenTheStepsOfALadder) {
  ForceSettings settings;
  for (int catches = 1; catches <= 4; ++catches) {
    settings.ladder_catches = catches;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      for (const auto& plain : {ascendingSeries(settings), descendingSeries(settings, 1.2)}) {
        const auto series = withCatchTrials(plain, settings, seed);
        EXPECT_EQ(series, withCatchTrials(plain, settings, seed));
        std::vector<SeriesStep> steps;
        int blanks = 0;
        int repeats = 0;
        for (std::size_t i = 0; i < series.size(); ++i) {
          EXPECT_EQ(series[i].step, static_cast<int>(i) + 1);
          if (!series[i].catch_trial) {
            steps.push_back(series[i]);
            continue;
          }
          ++(series[i].force_n == 0 ? blanks : repeats);
          ASSERT_GE(i, 2U);
          ASSERT_LT(i + 1, series.size());
          EXPECT_FALSE(series[i - 1].catch_trial || series[i + 1].catch_trial);
          EXPECT_NE(series[i].force_n, series[i - 1].force_n);
          const bool was_there = std::any_of(steps.begin(), steps.end(),
                                             [&](const auto& step) { return step.force_n == series[i].force_n; });
          EXPECT_TRUE(series[i].force_n == 0 || was_there);
          // An ascending series may end early: 60 % of its 17 steps, and the catch trials before this one.
          if (series[i].series == kAscending) {
            EXPECT_LE(steps.size(), 10U);
          }
        }
        EXPECT_EQ(blanks, (catches + 1) / 2);
        EXPECT_EQ(repeats, catches / 2);
        ASSERT_EQ(steps.size(), plain.size());
        for (std::size_t i = 0; i < steps.size(); ++i) EXPECT_EQ(steps[i].force_n, plain[i].force_n);
      }
      // Too short for any: as it was.
      EXPECT_EQ(withCatchTrials(descendingSeries(settings, 0.2), settings, seed).size(), 2U);
    }
  }
  settings.ladder_catches = 5;
  EXPECT_FALSE(validate(settings).has_value());
}

void expectConstraints(const ForceSettings& settings, const std::vector<SeriesStep>& block) {
  int large_jumps_running = 0;
  for (std::size_t i = 0; i < block.size(); ++i) {
    EXPECT_EQ(block[i].step, static_cast<int>(i) + 1);
    if (i == 0) {
      EXPECT_GT(block[0].force_n, 0);
      continue;
    }
    EXPECT_NE(block[i].force_n, block[i - 1].force_n);
    const double jump = std::abs(block[i].force_n - block[i - 1].force_n) / settings.random_steps.step_n;
    large_jumps_running = jump > settings.random_widest_jump + 0.5 ? large_jumps_running + 1 : 0;
    EXPECT_LT(large_jumps_running, 2);
  }
}

TEST(ForceSeries, TheRandomBlockObeysItsConstraintsForEachSeed) {
  const ForceSettings settings;
  std::set<std::vector<double>> orders;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const auto block = randomBlock(settings, seed);
    ASSERT_TRUE(block.has_value());
    ASSERT_EQ(block->size(), 38U);  // 11 forces three times, and 5 catch trials
    expectConstraints(settings, *block);
    std::map<double, int> times;
    std::map<double, int> caught;
    std::vector<double> order;
    for (const auto& step : *block) {
      ++times[step.force_n];
      if (step.catch_trial) ++caught[step.force_n];
      order.push_back(step.force_n);
    }
    orders.insert(order);
    EXPECT_EQ(times[0], 3);
    EXPECT_EQ(caught[0], 3);
    int hidden = 0;
    for (int i = 1; i <= 11; ++i) {
      hidden += caught[i / 10.0];
      EXPECT_EQ(times[i / 10.0], 3 + caught[i / 10.0]);
      EXPECT_LE(caught[i / 10.0], 1);
    }
    EXPECT_EQ(hidden, 2);
    // A hidden repeat is the last time of its force.
    for (auto step = block->begin(); step != block->end(); ++step) {
      if (!step->catch_trial || step->force_n == 0) continue;
      EXPECT_TRUE(
          std::none_of(step + 1, block->end(), [&](const auto& later) { return later.force_n == step->force_n; }));
    }
    EXPECT_EQ(*block, *randomBlock(settings, seed));
  }
  EXPECT_GT(orders.size(), 990U);
}

TEST(ForceSeries, OtherBlocksObeyThemToo) {
  ForceSettings settings;
  settings.random_repeats = 10;
  settings.random_widest_jump = 3;
  settings.catch_share = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto block = randomBlock(settings, seed);
    ASSERT_TRUE(block.has_value());
    EXPECT_EQ(block->size(), 110U);
    expectConstraints(settings, *block);
  }
  settings.random_steps = {0.3, 0.3, 0.1};  // one force ten times has no allowed order
  EXPECT_FALSE(randomBlock(settings, 1).has_value());
}

TEST(ForceSettings, NonsenseIsRefusedWithOneSentence) {
  const auto refused = [](auto change) {
    ForceSettings settings;
    change(settings);
    const auto result = validate(settings);
    return result ? std::string("accepted") : result.error().message();
  };
  EXPECT_EQ(refused([](auto&) {}), "accepted");
  EXPECT_EQ(refused([](auto& s) { s.ladder.lowest_n = 0; }),
            "ladder.lowest_n: found 0, wanted above 0 and at most 3 N");
  EXPECT_EQ(refused([](auto& s) { s.ladder.highest_n = 4; }),
            "ladder.highest_n: found 4, wanted above 0 and at most 3 N");
  EXPECT_EQ(refused([](auto& s) { s.ladder.highest_n = 0.05; }),
            "ladder.highest_n: found 0.05, wanted at least lowest_n (0.1)");
  EXPECT_EQ(refused([](auto& s) { s.ladder.step_n = 0.3; }),
            "ladder.step_n: found 0.3, wanted whole steps from lowest_n to highest_n, at most 100 forces");
  EXPECT_EQ(refused([](auto& s) { s.ascending = false; }),
            "ascending: found no series, wanted the ascending series or the random block");
  EXPECT_EQ(refused([](auto& s) { s.terms = {"small"}; }),
            "terms: found 'small', wanted at least two different term ids");
  EXPECT_EQ(refused([](auto& s) { s.familiarisation_n = {5}; }),
            "familiarisation_n: found 5, wanted above 0 and at most 3 N");
  EXPECT_EQ(refused([](auto& s) { s.pause_s = 1; }), "pause_s: found 1, wanted 2 to 60 s");
  EXPECT_EQ(refused([](auto& s) { s.catch_share = 0.5; }),
            "catch_share: found 0.5, wanted 0.1 to 0.15, or 0 for no catch trials");
  EXPECT_EQ(refused([](auto& s) { s.device_friction_n = -0.1; }), "device_friction_n: found -0.1, wanted 0 to 1 N");
  EXPECT_EQ(refused([](auto& s) { s.ramp_s = std::nan(""); }), "ramp_s: found nan, wanted 0.05 to 1 s");
}

}  // namespace
}  // namespace tactus::experiments
