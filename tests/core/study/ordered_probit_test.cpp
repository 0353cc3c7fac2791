#include "core/study/ordered_probit.h"

#include <gtest/gtest.h>

namespace tactus::study {
namespace {

using Method = TermThresholds::Method;

/// Two series of 0.1 to 1.1 N.
std::vector<TermAtForce> twoSeries(const std::vector<std::size_t>& terms) {
  std::vector<TermAtForce> judgements;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    judgements.push_back({static_cast<double>(i % 11 + 1) / 10, terms[i]});
  }
  return judgements;
}

// Reference: R 4, MASS::polr(factor(term) ~ force, method = "probit"), thresholds zeta / beta and 1 / beta.
TEST(OrderedProbit, AgreesWithPolr) {
  const auto result = termThresholds(twoSeries({0, 0, 1, 1, 2, 1, 3, 2, 3, 4, 4, 0, 1, 0, 1, 2, 2, 2, 3, 4, 3, 4}), 5);
  ASSERT_EQ(result.method, Method::kOrderedProbit);
  const double wanted[] = {0.2484116686, 0.5063498201, 0.7483397504, 0.9509809837};
  // polr stops at a relative change of 1e-8 of the deviance: about six digits of the parameters
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(result.threshold_n[i].value(), wanted[i], 1e-6);
  EXPECT_NEAR(result.sigma_n.value(), 0.0954512662, 1e-6);
}

TEST(OrderedProbit, ATermThatWasNeverUsedHasNoWidth) {
  // Terms 0, 1 and 3 of five; polr sees three categories.
  const auto result = termThresholds(twoSeries({0, 0, 1, 1, 3, 1, 3, 3, 3, 3, 3, 0, 1, 0, 1, 1, 3, 1, 3, 3, 3, 3}), 5);
  ASSERT_EQ(result.method, Method::kOrderedProbit);
  EXPECT_NEAR(result.threshold_n[0].value(), 0.2467996257, 1e-6);
  EXPECT_NEAR(result.threshold_n[1].value(), 0.6007518471, 1e-6);
  EXPECT_EQ(result.threshold_n[1], result.threshold_n[2]);
  EXPECT_FALSE(result.threshold_n[3].has_value());
  EXPECT_NEAR(result.sigma_n.value(), 0.1206691976, 1e-6);
}

TEST(OrderedProbit, TermsThatDoNotOverlapGetMidpoints) {
  const std::vector<TermAtForce> judgements = {{0.1, 0}, {0.2, 0}, {0.3, 1}, {0.6, 2}, {0.7, 4}};
  const auto result = termThresholds(judgements, 5);
  EXPECT_EQ(result.method, Method::kMidpoints);
  EXPECT_FALSE(result.sigma_n.has_value());
  EXPECT_DOUBLE_EQ(result.threshold_n[0].value(), 0.25);
  EXPECT_DOUBLE_EQ(result.threshold_n[1].value(), 0.45);
  EXPECT_DOUBLE_EQ(result.threshold_n[2].value(), 0.65);
  EXPECT_DOUBLE_EQ(result.threshold_n[3].value(), 0.65);
}

TEST(OrderedProbit, OneSharedForceIsNoOverlap) {
  // At 0.2 N both terms: the likelihood grows without end as sigma shrinks. Places 0.15 and 0.25 are equally good.
  const std::vector<TermAtForce> judgements = {{0.1, 0}, {0.2, 0}, {0.2, 1}, {0.3, 1}};
  const auto result = termThresholds(judgements, 2);
  EXPECT_EQ(result.method, Method::kMidpoints);
  EXPECT_DOUBLE_EQ(result.threshold_n[0].value(), 0.2);
}

TEST(OrderedProbit, TermsThatFallWithTheForceGetMidpoints) {
  const std::vector<TermAtForce> judgements = {{0.1, 1}, {0.2, 1}, {0.3, 0}, {0.4, 0}, {0.5, 1}, {0.15, 0}, {0.6, 0}};
  const auto result = termThresholds(judgements, 2);
  EXPECT_EQ(result.method, Method::kMidpoints);
  EXPECT_FALSE(result.sigma_n.has_value());
}

TEST(OrderedProbit, WithoutJudgementsThereAreNoThresholds) {
  for (const auto& threshold : termThresholds({}, 5).threshold_n) EXPECT_FALSE(threshold.has_value());
  const TermAtForce one{0.5, 2};
  for (const auto& threshold : termThresholds({&one, 1}, 5).threshold_n) EXPECT_FALSE(threshold.has_value());
}

}  // namespace
}  // namespace tactus::study
