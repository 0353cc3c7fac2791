// Data too long to be sorted: the histogram, the table of distinct values, and the passes over all samples.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "core/base/random.h"
#include "elicitation/clustering/fcm.h"

#include "tests/elicitation/clustering/fcm_cases.h"
#include "tests/reference/fcm_reference.h"

namespace tactus::elicitation {
namespace {

/// Simulated strokes at three speeds, mm/s.
std::vector<double> strokes(std::size_t count) {
  base::Random random(11);
  std::vector<double> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t stroke = i * 12 / count;
    const double phase = std::fmod(static_cast<double>(i) * 12 / static_cast<double>(count), 1.0);
    out[i] = 60 * static_cast<double>(1 + stroke / 4 * 2) * std::sin(std::numbers::pi * phase) + 3 * random.normal();
  }
  return out;
}

std::vector<double> referenceCentres(const std::vector<double>& samples, const std::vector<double>& weights,
                                     const FcmSettings& settings, const std::vector<double>& start) {
  const reference::FcmProblem problem{samples, weights, settings.m};
  // From a little beside the result, so that the reference has to find its own way.
  std::vector<long double> centres;
  for (const double centre : start) centres.push_back(centre * 1.001L);
  const auto fixed = reference::fcmFixedPoint(problem, centres, 300);
  return {fixed.centres.begin(), fixed.centres.end()};
}

double errorOf(const std::vector<double>& samples, const std::vector<double>& weights, const FcmSettings& settings) {
  const auto result = weights.empty() ? fuzzyCMeans(samples, settings) : fuzzyCMeans(samples, weights, settings);
  EXPECT_TRUE(result);
  if (!result) return INFINITY;
  EXPECT_EQ(result->stop, FcmStop::kConverged);
  return largestError(result->centres, referenceCentres(samples, weights, settings, result->centres));
}

// Rounding of sums of 5,000 terms and of centers of some hundreds: a few units in the last place.
constexpr double kSumRounding = 2e-13;

TEST(FcmLongData, AgreesWithTheTextbookIterationInLongDouble) {
  const auto samples = strokes(5000);
  EXPECT_LE(errorOf(samples, {}, {}), kSumRounding);
  EXPECT_LE(errorOf(samples, {}, {.clusters = 2}), kSumRounding);
  EXPECT_LE(errorOf(samples, {}, {.clusters = 4}), kSumRounding);
  EXPECT_LE(errorOf(samples, {}, {.m = 1.5}), kSumRounding);
  EXPECT_LE(errorOf(samples, {}, {.m = 3}), kSumRounding);
}

TEST(FcmLongData, FewDistinctValuesNeedNoPassOverAllSamples) {
  auto samples = strokes(5000);
  for (double& x : samples) x = std::round(x);
  const auto result = fuzzyCMeans(samples);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->passes, 0);
  EXPECT_LE(errorOf(samples, {}, {}), kSumRounding);
}

// Above m = 3 J has minima at single samples, so more starts are made: not where all of the first ones agree.
TEST(FcmLongData, MoreStartsAreMadeOnlyIfTheFirstDisagree) {
  const auto samples = strokes(5000);
  const auto passes = [&](double m) {
    int count = 0;  // over entries and over all samples
    FcmSettings settings{.m = m};
    settings.keep_going = [&](const FcmProgress&) { return ++count > 0; };
    const auto result = fuzzyCMeans(samples, settings);
    EXPECT_TRUE(result && result->other_minima.empty()) << m;
    return count;
  };
  // 16 starts each, and at m = 3.2 the 8 relocations of the minimum; with 64 starts it would be more than four times.
  EXPECT_LT(passes(3.2), 2.5 * passes(2.9));
  EXPECT_LE(errorOf(samples, {}, {.m = 3.2}), kSumRounding);
}

TEST(FcmLongData, AnOutlierTakesNoDigitsFromTheRest) {
  auto samples = strokes(5000);
  samples[777] = 1e6;
  // Three clusters: the outlier has one of its own. The others are as exact as ever.
  const auto result = fuzzyCMeans(samples);
  ASSERT_TRUE(result);
  EXPECT_NEAR(result->centres[2], 1e6, 1);
  const auto wanted = referenceCentres(samples, {}, {}, result->centres);
  EXPECT_NEAR(result->centres[0], wanted[0], 1e-12);
  EXPECT_NEAR(result->centres[1], wanted[1], 1e-12);
}

TEST(FcmLongData, AnOffsetCostsOnlyTheDigitsOfTheDataThemselves) {
  auto samples = strokes(5000);
  for (double& x : samples) x = (x + 1e15) - 1e15;  // multiples of 1/8
  auto moved = samples;
  for (double& x : moved) x += 1e15;
  const auto result = fuzzyCMeans(samples);
  const auto far = fuzzyCMeans(moved);
  ASSERT_TRUE(result && far);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(far->centres[k] - 1e15, result->centres[k], 0.0626);
  EXPECT_NEAR(*far->objective / *result->objective, 1, 1e-12);
}

TEST(FcmLongData, WeightsAndOddLengthsAreTakenIntoAccount) {
  base::Random random(5);
  auto samples = strokes(5003);
  std::vector<double> weights(samples.size());
  for (double& weight : weights) weight = random.below(3) == 0 ? 0 : random.uniform(0.1, 4);
  EXPECT_LE(errorOf(samples, weights, {}), kSumRounding);
  EXPECT_LE(errorOf(samples, weights, {.m = 2.5}), kSumRounding);
}

TEST(FcmLongData, ASampleWithoutWeightHasNoSay) {
  auto samples = strokes(5000);
  std::vector<double> weights(samples.size(), 1.0);
  const auto plain = fuzzyCMeans(samples);
  samples.push_back(1e12);
  weights.push_back(0);
  const auto result = fuzzyCMeans(samples, weights, {});
  ASSERT_TRUE(plain && result);
  EXPECT_LE(largestError(result->centres, plain->centres), kSumRounding);
}

/// Where Bezdek's iteration stands still for each center by itself: its own test measures by the range of the samples,
/// which an outlier stretches.
std::vector<long double> fixedPointOfEach(const std::vector<double>& samples, const std::vector<double>& start,
                                          double m) {
  std::vector<long double> centres;
  for (const double centre : start) centres.push_back(centre * 1.0001L);
  for (int round = 0; round < 100; ++round) centres = reference::fcmFixedPoint({samples, {}, m}, centres, 5).centres;
  return centres;
}

TEST(FcmLongData, AnOutlierCostsTheOtherCentresNothing) {
  // Before, the center on the outlier forbade Newton's steps to all: errors of 1e-8 to 1e-6 mm/s.
  for (const std::size_t count : {300U, 5000U}) {
    base::Random random(5);
    std::vector<double> speeds;
    for (std::size_t i = 0; i < count; ++i) {
      speeds.push_back(static_cast<double>(i % 3 + 1) * 15 + 4 * random.normal());
    }
    for (const double m : {1.5, 2.0, 2.5}) {
      for (const double outlier : {1e4, 1e6, -1e6, 1e8, 1e12}) {
        auto samples = speeds;
        samples.push_back(outlier);
        const auto result = fuzzyCMeans(samples, {.clusters = 4, .m = m});
        ASSERT_TRUE(result);
        EXPECT_EQ(result->stop, FcmStop::kConverged);
        const auto reference = fixedPointOfEach(samples, result->centres, m);
        for (std::size_t k = 0; k < 4; ++k) {
          if (std::abs(result->centres[k]) > 100) continue;
          // Two units in the last place of 45, as without an outlier.
          EXPECT_NEAR(result->centres[k], static_cast<double>(reference[k]), 2e-14)
              << count << ' ' << m << ' ' << outlier;
        }
      }
    }
  }
}

TEST(FcmLongData, AnOutlierAmongThreeClusters) {
  // One center goes to the outlier, the two others share the speeds.
  base::Random random(6);
  std::vector<double> samples(3000);
  for (double& x : samples) x = 30 + 8 * random.normal();
  samples[1234] = 1e6;
  const auto result = fuzzyCMeans(samples);
  ASSERT_TRUE(result);
  const auto reference = fixedPointOfEach(samples, result->centres, 2);
  EXPECT_NEAR(result->centres[0], static_cast<double>(reference[0]), 2e-14);
  EXPECT_NEAR(result->centres[1], static_cast<double>(reference[1]), 2e-14);
  EXPECT_LE(result->iterations, 60);
}

}  // namespace
}  // namespace tactus::elicitation
