// Weights of samples, and the caller's say while a clustering runs.
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "elicitation/clustering/fcm.h"

#include "tests/elicitation/clustering/fcm_cases.h"

namespace tactus::elicitation {
namespace {

TEST(FcmWeights, AWeightOfTwoCountsLikeTheSampleTwice) {
  const std::vector<double> samples = {1, 2, 7, 8, 8.5, 30, 33};
  const std::vector<double> weights = {2, 1, 0, 3, 1, 2, 1};
  const std::vector<double> repeated = {1, 1, 2, 8, 8, 8, 8.5, 30, 30, 33};
  for (const double m : {1.3, 2.0, 3.5}) {
    const auto weighted = fuzzyCMeans(samples, weights, {.m = m});
    const auto plain = fuzzyCMeans(repeated, {.m = m});
    ASSERT_TRUE(weighted && plain);
    EXPECT_LE(largestError(weighted->centres, plain->centres), 1e-13);  // some ulps of 30
    EXPECT_NEAR(*weighted->objective / *plain->objective, 1, 1e-13);
  }
}

TEST(FcmWeights, TheirScaleDoesNotMatter) {
  const std::vector<double> samples = {1, 2, 7, 8, 8.5, 30, 33};
  const std::vector<double> weights = {2, 1, 5, 3, 1, 2, 1};
  const auto plain = fuzzyCMeans(samples, weights, {});
  ASSERT_TRUE(plain);
  for (const double scale : {0x1p1000, 0x1p-1000}) {
    auto scaled = weights;
    for (double& weight : scaled) weight *= scale;
    const auto result = fuzzyCMeans(samples, scaled, {});
    ASSERT_TRUE(result);
    EXPECT_EQ(result->centres, plain->centres);
    EXPECT_NEAR(*result->objective_log10, *plain->objective_log10 + std::log10(scale), 1e-9);
  }
}

TEST(FcmWeights, RefusalsNameTheWeight) {
  const auto message = [](std::vector<double> weights) {
    const auto result = fuzzyCMeans(std::vector<double>{1, 2, 3, 4}, weights, {});
    return result ? std::string("no error") : result.error().message();
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message({1, 1, -0.5, 1}), "weight 3: found -0.5, wanted a finite number of at least 0");
  EXPECT_EQ(message({1, nan, 1, 1}), "weight 2: found nan, wanted a finite number of at least 0");
  EXPECT_EQ(message({1, 1, 1, INFINITY}), "weight 4: found inf, wanted a finite number of at least 0");
  EXPECT_EQ(message({1, 1, 1}), "weights: found 3, wanted 4, one for each sample");
  EXPECT_EQ(message({}), "weights: found none, wanted 4, one for each sample");
  EXPECT_EQ(message({0, 0, 0, 0}), "weights: found none above 0, wanted at least one above 0 for each cluster");
  EXPECT_EQ(message({1, 0, 1, 0}), "samples: found 2 distinct values, wanted at least 3, one for each cluster");
}

TEST(FcmProgress, CanStopARunBeforeAnyPass) {
  const auto samples = readFirstColumn("S1_24k.csv");
  const auto whole = fuzzyCMeans(samples);
  ASSERT_TRUE(whole);
  int calls = 0;
  int passes = 0;
  FcmSettings settings;
  settings.keep_going = [&](const FcmProgress& progress) {
    EXPECT_GE(progress.passes, passes);
    EXPECT_TRUE(progress.change >= 0 && progress.change <= 1);
    passes = progress.passes;
    ++calls;
    return true;
  };
  const auto watched = fuzzyCMeans(samples, settings);
  ASSERT_TRUE(watched);
  EXPECT_EQ(watched->centres, whole->centres) << "watching changes nothing";
  EXPECT_EQ(passes, whole->passes);

  for (const int last : {1, 2, 5, calls - 1, calls}) {
    int left = last;
    settings.keep_going = [&](const FcmProgress&) { return --left > 0; };
    const auto stopped = fuzzyCMeans(samples, settings);
    ASSERT_FALSE(stopped) << last;
    EXPECT_EQ(stopped.error().code, base::ErrorCode::kCancelled);
    EXPECT_EQ(stopped.error().message(), "clustering: found a request to stop, wanted to go on to the end");
    EXPECT_EQ(left, 0) << "not asked again";
  }
}

}  // namespace
}  // namespace tactus::elicitation
