#include "app/figures/force_curves.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/two_experts.h"

namespace tactus::figures {
namespace {

constexpr std::size_t kSpeed = 0;
constexpr std::size_t kDepth = 1;

class ForceCurvesTest : public testing::Test {
 protected:
  fuzzy::ForceModel model = tests::twoExperts();
  fuzzy::CompiledModel compiled = *fuzzy::compile(model);
};

TEST_F(ForceCurvesTest, SamplesHoldEveryVertexOfEveryTermList) {
  model.experts[1].overrides.push_back({"depth",
                                        {{"mid", "Mid", fuzzy::Shape::kTriangle, {1.0 / 3, 2.0 / 3, 4}},
                                         {"far", "Far", fuzzy::Shape::kGaussian, {8.1, 1}}}});
  const std::vector<double> x = samplePositions(model, kDepth);
  EXPECT_TRUE(std::is_sorted(x.begin(), x.end()));
  EXPECT_EQ(x.front(), 0);
  EXPECT_EQ(x.back(), 10);
  for (const double vertex : {4.0, 5.0, 6.0, 7.0, 1.0 / 3, 2.0 / 3, 8.1}) {
    EXPECT_TRUE(std::binary_search(x.begin(), x.end(), vertex)) << vertex;
  }
}

TEST_F(ForceCurvesTest, CurvesAreTheModelAtEverySample) {
  const std::array<double, 2> values = {47, 3};
  const ForceCurves curves = computeCurves(model, compiled, kDepth, values);
  ASSERT_EQ(curves.experts.size(), 2U);
  for (std::size_t i = 0; i < curves.x.size(); ++i) {
    const std::array<double, 2> point = {47, curves.x[i]};
    EXPECT_EQ(curves.mean[i].force_n, compiled.evaluate(point).force_n);
    EXPECT_EQ(curves.mean[i].fired, compiled.evaluate(point).fired);
    for (std::size_t expert = 0; expert < 2; ++expert) {
      EXPECT_EQ(curves.experts[expert][i].force_n, compiled.evaluateExpert(expert, point).force_n);
      EXPECT_EQ(curves.experts[expert][i].fired, compiled.evaluateExpert(expert, point).fired);
    }
  }
}

TEST_F(ForceCurvesTest, CurvesOfManyExpertsAreTheModelToo) {
  const std::vector<fuzzy::Expert> two = model.experts;
  for (std::size_t i = 2; i < 40; ++i) {
    fuzzy::Expert copy = two[i % 2];
    copy.id += std::to_string(i);
    model.experts.push_back(std::move(copy));
  }
  compiled = *fuzzy::compile(model);
  const std::array<double, 2> values = {47, 3};
  const ForceCurves curves = computeCurves(model, compiled, kDepth, values);
  ASSERT_EQ(curves.experts.size(), 40U);
  for (std::size_t i = 0; i < curves.x.size(); ++i) {
    const std::array<double, 2> point = {47, curves.x[i]};
    for (std::size_t expert = 0; expert < 40; ++expert) {
      const fuzzy::Evaluation alone = compiled.evaluateExpert(expert, point);
      ASSERT_EQ(curves.experts[expert][i].fired, alone.fired);
      // Different entry points agree to 4 ulp.
      ASSERT_NEAR(curves.experts[expert][i].force_n, alone.force_n, 4.5e-16);
    }
  }
}

TEST_F(ForceCurvesTest, EndsOfSilenceAreExact) {
  const std::array<double, 2> values = {20, 0};
  const ForceCurves curves = computeCurves(model, compiled, kDepth, values);
  const std::vector<Interval> everyone = silentIntervals(curves.x, curves.mean);
  ASSERT_EQ(everyone.size(), 1U);
  EXPECT_EQ(everyone[0].low, 5);
  EXPECT_EQ(everyone[0].high, 6);
  const std::vector<Interval> b = silentIntervals(curves.x, curves.experts[1]);
  ASSERT_EQ(b.size(), 1U);
  EXPECT_EQ(b[0].low, 0);
  EXPECT_EQ(b[0].high, 6);
}

TEST_F(ForceCurvesTest, ASilentPointWithoutWidthIsNoInterval) {
  model.inputs[kDepth].terms[1].points = {5, 6, 10, 10};  // near ends where far begins
  const ForceCurves curves = computeCurves(model, *fuzzy::compile(model), kDepth, std::array<double, 2>{20, 0});
  EXPECT_TRUE(silentIntervals(curves.x, curves.mean).empty());
}

TEST_F(ForceCurvesTest, AnyInputCanBeTheAxis) {
  const ForceCurves curves = computeCurves(model, compiled, kSpeed, std::array<double, 2>{0, 2});
  // A at depth 2: only "low" up to 40 mm/s, only "high" from 60 mm/s on.
  EXPECT_NEAR(curves.mean.front().force_n, 0.25, 1e-15);  // rounding of one division
  EXPECT_NEAR(curves.mean.back().force_n, 0.75, 1e-15);
}

}  // namespace
}  // namespace tactus::figures
