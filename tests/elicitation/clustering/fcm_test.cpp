#include "elicitation/clustering/fcm.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

#include "core/base/random.h"

#include "tests/elicitation/clustering/fcm_cases.h"

namespace tactus::elicitation {
namespace {

/// J from the paper's Eq. 1 with the memberships of Bezdek's iteration, in long double.
long double objectiveByDefinition(const std::vector<double>& samples, const std::vector<double>& centres, double m) {
  long double objective = 0;
  for (const double x : samples) {
    for (std::size_t k = 0; k < centres.size(); ++k) {
      const long double own = std::abs(static_cast<long double>(x) - centres[k]);
      long double sum = 0;
      bool crisp = false;
      for (std::size_t l = 0; l < centres.size(); ++l) {
        const long double other = std::abs(static_cast<long double>(x) - centres[l]);
        if (other == 0) crisp = true;
        if (other > 0) sum += std::pow(own / other, 2.0L / (m - 1));
      }
      if (!crisp) objective += std::pow(1 / sum, static_cast<long double>(m)) * own * own;
    }
  }
  return objective;
}

TEST(Fcm, ReachesTheReferenceCentres) {
  int cases = 0;
  for (const auto& one : readFcmCases()) {
    const std::string title = one.at("name");
    SCOPED_TRACE(title);
    FcmSettings settings;
    settings.clusters = one.at("c");
    settings.m = one.at("m");
    const auto samples = readFirstColumn(one.at("file"));
    ASSERT_EQ(samples.size(), one.at("n").get<std::size_t>());
    const auto result = fuzzyCMeans(samples, settings);
    ++cases;
    if (one.at("expect") != "ok") {
      ASSERT_FALSE(result);
      continue;
    }
    ASSERT_TRUE(result) << result.error().message();

    double error = largestError(result->centres, one.at("centres").get<std::vector<double>>());
    for (const auto& mirror : one.value("equivalent_centres", nlohmann::json::array())) {
      error = std::min(error, largestError(result->centres, mirror.get<std::vector<double>>()));
    }
    // The reference's own limit of what double precision can reach; it is far below `tolerance`.
    EXPECT_LE(error, one.at("stretch_tolerance").get<double>());
    EXPECT_LE(error, one.at("tolerance").get<double>());

    const double objective = base::parseNumber(one.at("J_str").get<std::string>()).value();
    ASSERT_TRUE(result->objective);
    // J at the minimum is flat: what remains is the rounding of the sum, and of the data at the offset of 1e9.
    EXPECT_NEAR(*result->objective, objective, 1e-12 * objective);
    for (const auto& other : one.at("other_minima")) {
      bool found = false;
      const auto centres = other.at("centres").get<std::vector<double>>();
      auto all = result->other_minima;
      all.push_back({result->centres, 1});
      for (const auto& minimum : all) found = found || largestError(minimum.centres, centres) < 1e-8;
      EXPECT_TRUE(found) << "another minimum was not reported";
    }
  }
  EXPECT_EQ(cases, 19);
}

TEST(Fcm, RefusesWhatHasNoAnswerAndSaysWhere) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto message = [](std::vector<double> samples, FcmSettings settings) {
    const auto result = fuzzyCMeans(samples, settings);
    return result ? std::string("no error") : result.error().message();
  };
  EXPECT_EQ(message({1, 2, nan, 4}, {}), "sample 3: found nan, wanted a finite number");
  EXPECT_EQ(message({1, 2, 3, -INFINITY}, {}), "sample 4: found -inf, wanted a finite number");
  EXPECT_EQ(message({}, {}), "samples: found none, wanted at least one for each cluster");
  EXPECT_EQ(message({5, 5, 5, 5}, {}), "samples: found 1 distinct value, wanted at least 3, one for each cluster");
  EXPECT_EQ(message({1, 2, 2, 1}, {}), "samples: found 2 distinct values, wanted at least 3, one for each cluster");
  EXPECT_EQ(
      message({0, 1e-320, 2e-320, 1}, {}),
      "samples: found clusters too close together for the range of the values, wanted values whose clusters double "
      "precision can tell apart");
  for (const double m : {1.0, 0.5, nan, std::numeric_limits<double>::infinity(), -2.0}) {
    FcmSettings settings;
    settings.m = m;
    EXPECT_EQ(message({1, 2, 3, 4}, settings).find("fuzziness m: found"), 0U) << m;
  }
  FcmSettings none;
  none.clusters = 0;
  EXPECT_EQ(message({1, 2}, none), "clusters: found 0, wanted 1 to 64");
}

TEST(Fcm, OneClusterIsTheMean) {
  FcmSettings settings;
  settings.clusters = 1;
  const auto result = fuzzyCMeans(std::vector<double>{1, 2, 6}, settings);
  ASSERT_TRUE(result);
  EXPECT_DOUBLE_EQ(result->centres.at(0), 3);
  EXPECT_DOUBLE_EQ(result->objective.value(), 14);
}

TEST(Fcm, AsManyValuesAsClustersAreTheCentres) {
  const auto result = fuzzyCMeans(std::vector<double>{7, 3, 20, 7});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->centres, (std::vector<double>{3, 7, 20}));
  EXPECT_EQ(result->objective, 0.0);
  EXPECT_FALSE(result->objective_log10);
  EXPECT_EQ(result->stop, FcmStop::kExact);
}

TEST(Fcm, OffsetsAndScalesDoNotMatter) {
  const auto samples = readFirstColumn("S1_600.csv");
  const auto plain = fuzzyCMeans(samples);
  ASSERT_TRUE(plain);
  for (const double scale : {1e160, 1e-160, 1e300, 1e-300, 1e-310}) {
    std::vector<double> scaled = samples;
    for (double& x : scaled) x *= scale;
    const auto result = fuzzyCMeans(scaled);
    ASSERT_TRUE(result) << result.error().message();
    for (std::size_t k = 0; k < 3; ++k) {
      // Scaling rounds each sample by half an ulp; 1e-310 leaves only about 13 digits of them.
      EXPECT_NEAR(result->centres[k] / scale, plain->centres[k], scale == 1e-310 ? 1e-11 : 1e-12);
    }
    ASSERT_TRUE(result->objective_log10);
    EXPECT_NEAR(*result->objective_log10 - 2 * std::log10(scale), *plain->objective_log10, 1e-9);
    EXPECT_FALSE(result->objective) << "1e320 and 1e-314 are outside the normal range";
  }
  // At an offset of 1e15 samples are multiples of 1/8, so the reference is the same data rounded and moved back.
  std::vector<double> offset = samples;
  std::vector<double> rounded;
  for (double& x : offset) {
    x += 1e15;
    rounded.push_back(x - 1e15);
  }
  const auto far = fuzzyCMeans(offset);
  const auto reference = fuzzyCMeans(rounded);
  ASSERT_TRUE(far && reference);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(far->centres[k] - 1e15, reference->centres[k], 0.0626);
  EXPECT_NEAR(*far->objective, *reference->objective, 1e-9 * *reference->objective);
}

TEST(Fcm, AnOutlierOfAMillionGetsItsOwnCentre) {
  auto samples = readFirstColumn("S4_600.csv");
  samples.push_back(1e6);
  const auto result = fuzzyCMeans(samples);
  ASSERT_TRUE(result);
  EXPECT_NEAR(result->centres[2], 1e6, 1);
  EXPECT_LT(result->centres[1], 60);
  samples.back() = 1e150;  // products of squared distances underflow on the way
  const auto extreme = fuzzyCMeans(samples);
  ASSERT_TRUE(extreme);
  EXPECT_EQ(extreme->centres[2], 1e150);
  EXPECT_TRUE(std::isfinite(extreme->centres[0]));
}

TEST(Fcm, EveryFuzzinessEndsAtAStationaryPointThatBeatsItsNeighbors) {
  const auto samples = readFirstColumn("S3_600.csv");
  for (const double m : {1.01, 1.2, 1.7, 2.0, 2.5, 4.0, 5.0, 6.0}) {
    SCOPED_TRACE(m);
    FcmSettings settings;
    settings.m = m;
    const auto result = fuzzyCMeans(samples, settings);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->stop, FcmStop::kConverged);
    EXPECT_EQ(result->warnings.size(), m > 5 ? 1U : 0U);
    const long double objective = objectiveByDefinition(samples, result->centres, m);
    // Long double against double: both are sums of 1800 positive terms.
    EXPECT_NEAR(static_cast<double>(objective / result->objective.value()), 1, 1e-12);
    for (std::size_t k = 0; k < 3; ++k) {
      for (const double step : {-0.01, 0.01}) {
        auto moved = result->centres;
        moved[k] += step;
        EXPECT_GE(objectiveByDefinition(samples, moved, m), objective);
      }
    }
  }
}

TEST(Fcm, ManyClustersAndHeavyDuplicatesConverge) {
  base::Random random(7);
  std::vector<double> samples;
  for (int i = 0; i < 2000; ++i) samples.push_back(i < 1500 ? 0 : std::floor(random.uniform(0, 40)));
  for (const std::size_t clusters : {2U, 5U, 12U, 30U}) {
    FcmSettings settings;
    settings.clusters = clusters;
    settings.starts = 4;
    const auto result = fuzzyCMeans(samples, settings);
    ASSERT_TRUE(result);
    ASSERT_EQ(result->centres.size(), clusters);
    for (const double centre : result->centres) EXPECT_TRUE(centre >= 0 && centre <= 39);
    EXPECT_TRUE(std::is_sorted(result->centres.begin(), result->centres.end()));
  }
}

TEST(Fcm, MembershipsSumToOneAndAreCrispOnACentre) {
  const std::vector<double> centres{-1, 2, 10};
  std::vector<double> u(3);
  fcmMemberships(2, centres, 2, u);
  EXPECT_EQ(u, (std::vector<double>{0, 1, 0}));
  fcmMemberships(0.5, centres, 2, u);
  // Squared distances 9/4, 9/4, 361/4: shares of 1/q, so 361 : 361 : 9.
  EXPECT_DOUBLE_EQ(u[0], 361.0 / 731);
  EXPECT_DOUBLE_EQ(u[2], 9.0 / 731);
  fcmMemberships(1e9, centres, 1.01, u);
  EXPECT_NEAR(std::accumulate(u.begin(), u.end(), 0.0), 1, 1e-15);
}

}  // namespace
}  // namespace tactus::elicitation
