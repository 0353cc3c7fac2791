// The loops for each instruction set: the same bits from all, and the sums of their definition.

#include <cmath>
#include <gtest/gtest.h>
#include <span>

#include "core/base/random.h"
#include "elicitation/clustering/fcm_pass.h"

#include "tests/reference/fcm_reference.h"

namespace tactus::elicitation {
namespace {

struct Place {
  std::vector<double> centres;
  double m;
};

std::vector<Place> places() {
  std::vector<Place> out;
  for (const double m : {2.0, 1.01, 1.3, 3.0, 7.5}) {
    for (const std::size_t clusters : {1U, 2U, 3U, 4U, 5U, 9U, 40U}) {
      Place place{{}, m};
      for (std::size_t k = 0; k < clusters; ++k) {
        place.centres.push_back(-0.9 + 1.8 * static_cast<double>(k) / static_cast<double>(clusters));
      }
      out.push_back(place);
    }
    out.push_back({{0.25, 0.25 + 1e-200, 0.5, 0.75}, m});  // products of squared distances underflow
  }
  return out;
}

FcmData unitData(std::span<const double> values, std::span<const double> weights) {
  FcmData data;
  data.values = values;
  data.weights = weights;
  return data;
}

class FcmKernelsTest : public testing::Test {
 protected:
  FcmKernelsTest() {
    base::Random random(3);
    for (int i = 0; i < 1205; ++i) {
      values_.push_back(random.uniform(-1, 1));
      weights_.push_back(random.uniform(0, 2));
    }
    values_[17] = 0.25;  // on a center
  }

  std::vector<double> values_, weights_;
};

TEST_F(FcmKernelsTest, EveryInstructionSetGivesTheSameBits) {
  for (const Place& place : places()) {
    for (const bool weighted : {false, true}) {
      const FcmData data = unitData(values_, weighted ? std::span<const double>(weights_) : std::span<const double>());
      FcmSums first;
      FcmPass(place.centres.size(), place.m, supportedFcmKernels().front()).run(data, place.centres, first);
      for (const FcmKernels& kernels : supportedFcmKernels()) {
        FcmSums sums;
        FcmPass(place.centres.size(), place.m, kernels).run(data, place.centres, sums);
        EXPECT_EQ(sums.weight, first.weight) << kernels.name;
        EXPECT_EQ(sums.pull, first.pull) << kernels.name;
        EXPECT_EQ(sums.curvature, first.curvature) << kernels.name;
        EXPECT_EQ(sums.objective, first.objective) << kernels.name;
      }
    }
  }
}

TEST_F(FcmKernelsTest, SumsAreThoseOfTheDefinition) {
  for (const Place& place : places()) {
    SCOPED_TRACE(std::to_string(place.centres.size()) + " clusters, m = " + std::to_string(place.m));
    FcmSums sums;
    FcmPass(place.centres.size(), place.m).run(unitData(values_, weights_), place.centres, sums);
    const std::vector<long double> centres(place.centres.begin(), place.centres.end());
    std::vector<long double> weight(centres.size(), 0);
    std::vector<long double> pull(centres.size(), 0);
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const auto u = reference::fcmMemberships(values_[i], centres, place.m);
      for (std::size_t k = 0; k < u.size(); ++k) {
        const long double share = weights_[i] * std::pow(u[k], static_cast<long double>(place.m));
        weight[k] += share;
        pull[k] += share * (values_[i] - centres[k]);
      }
    }
    // At most 1205 terms, each good to some roundings of its largest factor.
    const double tolerance = 1e-14 * static_cast<double>(values_.size());
    for (std::size_t k = 0; k < centres.size(); ++k) {
      EXPECT_NEAR(sums.weight[k], static_cast<double>(weight[k]), tolerance);
      EXPECT_NEAR(sums.pull[k], static_cast<double>(pull[k]), tolerance);
    }
    const auto objective = reference::fcmObjective({values_, weights_, place.m}, centres);
    EXPECT_NEAR(sums.objective / static_cast<double>(objective), 1, 1e-13);
  }
}

TEST_F(FcmKernelsTest, CurvatureIsTheDerivativeOfThePull) {
  for (const Place& place : places()) {
    const std::size_t c = place.centres.size();
    if (place.m < 1.2 || place.m > 3 || c == 1 || place.centres[1] == place.centres[0]) continue;
    const FcmData data = unitData(values_, weights_);
    FcmPass pass(c, place.m);
    FcmSums here, above, below;
    pass.run(data, place.centres, here);
    for (std::size_t l = 0; l < c; ++l) {
      const double step = 1e-6;
      auto moved = place.centres;
      moved[l] += step;
      pass.run(data, moved, above);
      moved[l] -= 2 * step;
      pass.run(data, moved, below);
      for (std::size_t k = 0; k < c; ++k) {
        const double slope = (below.pull[k] - above.pull[k]) / (2 * step);
        // Central difference: step^2 of third derivatives of up to 1 / gap^2 per sample; for m = 3 kinks at samples
        // within a step of a center, of which there is one, placed on purpose.
        EXPECT_NEAR(here.curvature[k * c + l], slope, place.m == 3 ? 3.0 : 0.01) << c << " clusters, m " << place.m;
      }
    }
  }
}

}  // namespace
}  // namespace tactus::elicitation
