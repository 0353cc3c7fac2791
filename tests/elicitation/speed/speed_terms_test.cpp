#include "elicitation/speed/speed_terms.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/fuzzy/membership.h"
#include "elicitation/clustering/fcm.h"

#include "tests/support/default_procedure.h"

namespace tactus::elicitation {
namespace {

TEST(SpeedTerms, TwoCentresGiveTheClosedForm) {
  // m = 2: u_1 = d_2^2 / (d_1^2 + d_2^2) = 0.8 where d_2 = 2 d_1, a third of the way.
  const auto ramps = alphaCutRamps(std::vector<double>{10, 40}, 2, 0.8);
  ASSERT_TRUE(ramps);
  EXPECT_NEAR(ramps->at(0).p, 20, 1e-13);  // bisection ends at the last double that still has the membership
  EXPECT_NEAR(ramps->at(0).q, 30, 1e-13);
  // m = 3: u_1 = d_2 / (d_1 + d_2) is linear.
  const auto linear = alphaCutRamps(std::vector<double>{0, 100}, 3, 0.95);
  EXPECT_NEAR(linear->at(0).p, 5, 1e-12);
  EXPECT_NEAR(linear->at(0).q, 95, 1e-12);
}

TEST(SpeedTerms, AlphaOneIsTheLiteralReading) {
  const auto ramps = alphaCutRamps(std::vector<double>{32, 110, 195}, 2, 1);
  ASSERT_TRUE(ramps);
  EXPECT_EQ(*ramps, (std::vector<Ramp>{{32, 110}, {110, 195}}));
}

TEST(SpeedTerms, AlphaOutsideItsRangeIsRefused) {
  for (const double alpha : {0.5, 0.0, 1.0001, std::nan("")}) {
    const auto ramps = alphaCutRamps(std::vector<double>{1, 2}, 2, alpha);
    ASSERT_FALSE(ramps);
    EXPECT_EQ(ramps.error().place, "alpha");
  }
}

TEST(SpeedTerms, RandomCentresKeepTheOrderAndTheMemberships) {
  base::Random random(11);
  for (int round = 0; round < 300; ++round) {
    std::vector<double> centres;
    const int clusters = 2 + random.below(5);
    for (int k = 0; k < clusters; ++k) centres.push_back(random.uniform(-50, 400));
    std::sort(centres.begin(), centres.end());
    const double m = random.uniform(1.05, 5);
    const double alpha = random.uniform(0.501, 0.999);
    const auto ramps = alphaCutRamps(centres, m, alpha);
    ASSERT_TRUE(ramps);
    std::vector<double> u(centres.size());
    for (std::size_t k = 0; k < ramps->size(); ++k) {
      const Ramp ramp = (*ramps)[k];
      EXPECT_LE(centres[k], ramp.p);
      EXPECT_LT(ramp.p, ramp.q);
      EXPECT_LE(ramp.q, centres[k + 1]);
      // One ulp of x changes u by at most (2/(m-1)) ulp(x)/d times; d is what the edge is away from its center.
      fcmMemberships(ramp.p, centres, m, u);
      EXPECT_NEAR(u[k], alpha, 1e-8);
      fcmMemberships(ramp.q, centres, m, u);
      EXPECT_NEAR(u[k + 1], alpha, 1e-8);
    }
  }
}

TEST(SpeedTerms, NeighboringTermsSumToOne) {
  fuzzy::Variable speed = support::ngtInputs()[3];
  speed.terms = speedTerms(speed, std::vector<Ramp>{{50, 100}, {130, 190}});
  EXPECT_EQ(speed.terms[0].points, (std::vector<double>{0, 0, 50, 100}));
  EXPECT_EQ(speed.terms[1].points, (std::vector<double>{50, 100, 130, 190}));
  EXPECT_EQ(speed.terms[2].points, (std::vector<double>{130, 190, 400, 400}));
  EXPECT_EQ(speed.terms[2].id, "fast");
  for (double x = 0; x <= 400; x += 0.5) {
    double sum = 0;
    for (const auto& term : speed.terms) sum += fuzzy::MembershipFunction::of(term)(x);
    EXPECT_NEAR(sum, 1, 1e-15);  // two roundings of values up to 1
  }
}

TEST(SpeedTerms, AveragesByHand) {
  const std::vector<std::vector<Ramp>> ramps{{{10, 20}, {30, 50}}, {{20, 40}, {60, 80}}, {{60, 66}, {90, 101}}};
  EXPECT_EQ(averageRamps(ramps, {}, Averaging::kMean), (std::vector<Ramp>{{30, 42}, {60, 77}}));
  EXPECT_EQ(averageRamps(ramps, {}, Averaging::kMedian), (std::vector<Ramp>{{20, 40}, {60, 80}}));
  const std::vector<double> weights{1, 3, 0};
  EXPECT_EQ(averageRamps(ramps, weights, Averaging::kWeightedMean), (std::vector<Ramp>{{17.5, 35}, {52.5, 72.5}}));
}

TEST(SpeedTerms, EveryAverageKeepsTheOrder) {
  base::Random random(4);
  for (int round = 0; round < 200; ++round) {
    std::vector<std::vector<Ramp>> ramps;
    std::vector<double> weights;
    for (int who = 0; who < 2 + random.below(4); ++who) {
      std::vector<double> centres(3);
      for (double& centre : centres) centre = random.uniform(0, 400);
      std::sort(centres.begin(), centres.end());
      ramps.push_back(alphaCutRamps(centres, 2, random.uniform(0.51, 1)).value());
      weights.push_back(random.uniform(0.1, 3));
    }
    for (const auto averaging : {Averaging::kMean, Averaging::kWeightedMean, Averaging::kMedian}) {
      const auto averaged = averageRamps(ramps, weights, averaging);
      EXPECT_LT(averaged[0].p, averaged[0].q);
      EXPECT_LE(averaged[0].q, averaged[1].p);
      EXPECT_LT(averaged[1].p, averaged[1].q);
    }
  }
}

TEST(SpeedTerms, AveragesOfFourSimulatedParticipants) {
  // Centers of other traces simulated to Table 1; alpha = 1 reads them as they are. By hand: 127.9 / 4, 434.6 / 4,
  // 781.2 / 4.
  std::vector<std::vector<Ramp>> ramps;
  for (const std::vector<double>& centres : std::vector<std::vector<double>>{
           {43.7, 145.5, 308.0}, {23.9, 140.9, 226.0}, {54.5, 112.8, 193.9}, {5.8, 35.4, 53.3}}) {
    ramps.push_back(alphaCutRamps(centres, 2, 1).value());
  }
  const auto averaged = averageRamps(ramps, {}, Averaging::kMean);
  EXPECT_NEAR(averaged[0].p, 31.975, 1e-12);  // rounding of decimal fractions, here and below
  EXPECT_NEAR(averaged[0].q, 108.65, 1e-12);
  EXPECT_NEAR(averaged[1].p, 108.65, 1e-12);
  EXPECT_NEAR(averaged[1].q, 195.3, 1e-12);
}

TEST(SpeedTerms, TheUniverseGrowsToTheNextHundred) {
  EXPECT_EQ(speedUniverseMax(400, 311, std::vector<Ramp>{{1, 2}}), 400);
  EXPECT_EQ(speedUniverseMax(400, 400, {}), 400);
  EXPECT_EQ(speedUniverseMax(400, 401, {}), 500);
  EXPECT_EQ(speedUniverseMax(400, 100, std::vector<Ramp>{{1, 630}}), 700);
}

TEST(SpeedTerms, TrimmingLooksAtEachStroke) {
  std::vector<study::SpeedSample> samples;
  for (const auto& [stroke, speed] :
       std::vector<std::pair<int, double>>{{1, 10}, {1, 100}, {1, 20}, {2, 10}, {2, 30}, {2, 5}}) {
    samples.push_back({"S1", "slow", stroke, 0, 0, speed});
  }
  std::vector<double> kept;
  for (const auto& sample : trimStrokes(samples, 0.2)) kept.push_back(sample.speed_mm_s);
  EXPECT_EQ(kept, (std::vector<double>{100, 20, 10, 30}));
  EXPECT_EQ(trimStrokes(samples, 0).size(), 6U);
}

// Any finite weight may stand in a table of weights; the sum of two of these is beyond double.
TEST(SpeedTerms, WeightsOfAnySizeAverage) {
  const std::vector<std::vector<Ramp>> ramps = {{{10, 20}}, {{30, 60}}};
  for (const double weight : {1e-300, 1.0, 1.5e308}) {
    EXPECT_EQ(averageRamps(ramps, std::vector<double>{weight, weight}, Averaging::kWeightedMean),
              (std::vector<Ramp>{{20, 40}}));
  }
}

}  // namespace
}  // namespace tactus::elicitation
