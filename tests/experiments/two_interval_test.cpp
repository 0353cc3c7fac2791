#include "experiments/two_interval.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "core/base/random.h"

namespace tactus::experiments {
namespace {

// Reference figures for one-sided exact tests at 0.05 with a power of 0.8, each computed by a separate program from the
// binomial distribution. Tolerances are half of the last digit that is given.
TEST(TwoInterval, TrialsForADifference) {
  struct Row {
    double jnd, share;
    int trials, critical;
    double abx;
    int abx_trials;
  };
  for (const Row& row :
       {Row{0.5, 0.632, 91, 54, 0, 2516}, Row{1, 0.75, 23, 16, 0.592, 188}, Row{1.5, 0.844, 13, 10, 0.681, 49},
        Row{2, 0.911, 8, 7, 0.771, 21}, Row{3, 0.979, 5, 5, 0, 8}}) {
    // The last one is 0.97849 with all digits of d', and 0.9785 with the four of the reference.
    EXPECT_NEAR(shareRight(row.jnd), row.share, row.jnd == 3 ? 6e-4 : 5e-4) << row.jnd;
    EXPECT_NEAR(differenceJnd(shareRight(row.jnd)), row.jnd, 1e-9);
    const auto test = smallestTest(shareRight(row.jnd));
    ASSERT_TRUE(test);
    EXPECT_EQ(test->trials, row.trials) << row.jnd;
    EXPECT_EQ(test->critical, row.critical) << row.jnd;
    const double abx = abxShareRight(row.jnd);
    if (row.abx > 0) {
      EXPECT_NEAR(abx, row.abx, 5e-4) << row.jnd;
    }
    const auto longer = smallestTest(abx);
    ASSERT_TRUE(longer);
    EXPECT_EQ(longer->trials, row.abx_trials) << row.jnd;
    if (row.jnd == 1) {
      EXPECT_EQ(longer->critical, 106);
    }
  }
}

TEST(TwoInterval, TrialsForAShare) {
  struct Row {
    double share;
    int trials, critical;
  };
  for (const Row& row :
       {Row{0.6, 158, 90}, Row{0.65, 69, 42}, Row{0.7, 37, 24}, Row{0.75, 23, 16}, Row{0.8, 18, 13}, Row{0.9, 8, 7}}) {
    const auto test = smallestTest(row.share);
    ASSERT_TRUE(test);
    EXPECT_EQ(test->trials, row.trials) << row.share;
    EXPECT_EQ(test->critical, row.critical) << row.share;
  }
  EXPECT_FALSE(smallestTest(0.5));
}

TEST(TwoInterval, SizeAndPowerOfFixedNumbers) {
  struct Row {
    int trials, critical;
    double size, power;
  };
  for (const Row& row : {Row{12, 10, .0193, .3907}, Row{20, 15, .0207, .6172}, Row{24, 17, .0320, .7662},
                         Row{30, 20, .0494, .8943}, Row{40, 26, .0403, .9456}}) {
    const BinomialTest test = testOf(row.trials, 0.75);
    EXPECT_EQ(test.critical, row.critical);
    EXPECT_NEAR(test.size, row.size, 5e-5);
    EXPECT_NEAR(test.power, row.power, 5e-5);
  }
  // Four trials, all right: 1/16 is above 0.05.
  EXPECT_GT(testOf(4, 0.99).critical, 4);
}

TEST(TwoInterval, Intervals) {
  const auto one = clopperPearson(15, 20);
  EXPECT_NEAR(one.low, .5090, 5e-5);
  EXPECT_NEAR(one.high, .9134, 5e-5);
  const auto many = clopperPearson(52, 82);
  EXPECT_NEAR(many.low, .5205, 5e-5);
  EXPECT_NEAR(many.high, .7378, 5e-5);
  // 1 - 0.025^(1/n), the closed form of an empty count.
  EXPECT_NEAR(clopperPearson(0, 10).high, 1 - std::pow(0.025, 0.1), 1e-12);
  EXPECT_EQ(clopperPearson(0, 10).low, 0);
  EXPECT_EQ(clopperPearson(10, 10).high, 1);
}

TEST(TwoInterval, WhatATestFinds) {
  for (const int trials : {9, 23, 40, 91}) {
    const BinomialTest test = testOf(trials, 0.75);
    EXPECT_NEAR(testOf(trials, shareRight(detectableJnd(test))).power, kPower, 1e-9);
  }
  EXPECT_TRUE(std::isinf(detectableJnd(testOf(4, 0.75))));
  EXPECT_NEAR(chanceWithoutDifference(15, 20), .0207, 5e-5);
}

TEST(TwoInterval, SequentialTest) {
  SequentialTest test;
  EXPECT_NEAR(test.rightStep(), .405465, 5e-7);
  EXPECT_NEAR(test.wrongStep(), -.693147, 5e-7);
  EXPECT_NEAR(test.differAt(), 2.772589, 5e-7);
  EXPECT_NEAR(test.stopAt(), -1.558145, 5e-7);
  EXPECT_NEAR(chancesOf(test, 0.5).differ, .0438, 5e-5);
  EXPECT_NEAR(chancesOf(test, 0.75).differ, .8169, 5e-5);
  test.most_trials = 1000;  // as good as without an end
  EXPECT_NEAR(chancesOf(test, 0.5).mean_trials, 11.61, 5e-3);
  EXPECT_NEAR(chancesOf(test, 0.75).mean_trials, 17.05, 5e-3);
  EXPECT_NEAR(chancesOf(test, 0.5).differ, .0456, 5e-5);
  EXPECT_NEAR(chancesOf(test, 0.75).differ, .8530, 5e-5);
}

TEST(TwoInterval, OrderEffect) {
  const auto effect = orderEffectOf({8, 10, 5, 10});
  EXPECT_NEAR(effect.preference, .693147, 5e-7);
  EXPECT_NEAR(effect.order, .693147, 5e-7);
  EXPECT_FALSE(effect.half_added);
  // All won: without half a win the estimate would have no end.
  const auto all = orderEffectOf({10, 10, 10, 10});
  EXPECT_TRUE(all.half_added);
  EXPECT_NEAR(all.preference, std::log(21.0), 1e-12);
  EXPECT_NEAR(all.order, 0, 1e-12);
}

// "Can't tell" counts one half. The exact chance of each sum of halves without a difference, for every share of "can't
// tell": the test keeps its size.
TEST(TwoInterval, HalvesKeepTheSize) {
  for (int trials = 5; trials <= 60; ++trials) {
    const int critical = testOf(trials, 0.75).critical;
    for (double untold = 0; untold < 1; untold += 0.1) {
      std::vector<double> chance = {1};
      for (int i = 0; i < trials; ++i) {
        std::vector<double> next(chance.size() + 2, 0.0);
        for (std::size_t halves = 0; halves < chance.size(); ++halves) {
          next[halves] += chance[halves] * (1 - untold) / 2;
          next[halves + 1] += chance[halves] * untold;
          next[halves + 2] += chance[halves] * (1 - untold) / 2;
        }
        chance = next;
      }
      double size = 0;
      for (auto halves = static_cast<std::size_t>(2 * critical); halves < chance.size(); ++halves)
        size += chance[halves];
      EXPECT_LE(size, kAlpha + 1e-12) << trials << " trials, " << untold;
    }
  }
}

// Reference figures: 0.61, 0.70 and 0.81 of the runs are within 25 % of the truth after 20, 40 and 70 trials. Truths
// are drawn from the prior. 800 runs give a standard error of 0.017; the reference has another grid and other truths.
TEST(TwoInterval, OwnJndWithin25Percent) {
  base::Random random(20261128);
  constexpr int kRuns = 800;
  const std::vector<int> after = {20, 40, 70};
  const std::vector<double> wanted = {0.61, 0.70, 0.81};
  std::vector<int> within(after.size(), 0);
  int covered = 0;
  for (int run = 0; run < kRuns; ++run) {
    const double truth = std::exp(0.6 * random.normal());
    JndSearch search;
    for (int trial = 1; trial <= after.back(); ++trial) {
      const double difference = search.next();
      search.add({difference, random.uniform() < JndSearch::shareRightOf(difference, truth)});
      const auto at = std::find(after.begin(), after.end(), trial);
      if (at == after.end()) continue;
      if (std::abs(search.estimate().factor / truth - 1) <= 0.25)
        ++within[static_cast<std::size_t>(at - after.begin())];
    }
    const OwnJnd estimate = search.estimate();
    covered += estimate.low <= truth && truth <= estimate.high ? 1 : 0;
  }
  for (std::size_t i = 0; i < after.size(); ++i)
    EXPECT_NEAR(within[i] / static_cast<double>(kRuns), wanted[i], 0.07) << after[i];
  EXPECT_NEAR(covered / static_cast<double>(kRuns), 0.95, 0.03);  // 4 standard errors
}

}  // namespace
}  // namespace tactus::experiments
