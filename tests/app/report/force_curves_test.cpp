#include "app/report/force_curves.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/ngt_model.h"

namespace tactus::report {
namespace {

TEST(ForceCurves, S4AsPrintedHasTheKnownForcesAndItsHole) {
  const auto curves = ForceCurves::of(support::s4AsPrinted());
  ASSERT_TRUE(curves);
  const ForceCurve curve = curves->curve({1, 60, 0, 50}, 0);
  ASSERT_EQ(curve.size(), 601U);
  // Five printed digits of an independent exact integration of the same model.
  const std::vector<std::pair<std::size_t, double>> known = {
      {30, .12667}, {70, .33765}, {100, .45}, {139, .5}, {150, .47875}, {200, .58944}, {300, .54365}, {440, .46445}};
  for (const auto& [depth_mm, force_n] : known) {
    ASSERT_TRUE(curve[depth_mm].force_n) << depth_mm;
    EXPECT_NEAR(*curve[depth_mm].force_n, force_n, 5.1e-6) << depth_mm;
  }
  for (std::size_t depth_mm = 125; depth_mm <= 138; ++depth_mm) EXPECT_FALSE(curve[depth_mm].force_n) << depth_mm;
  EXPECT_TRUE(curve[124].force_n);
  EXPECT_FALSE(toSeries(curve)[130].y);
}

TEST(ForceCurves, TheWayMayBeAnyInput) {
  fuzzy::ForceModel model = support::s4FiveRegions();
  const auto straight = ForceCurves::of(model);
  std::swap(model.inputs[0], model.inputs[2]);
  const auto swapped = ForceCurves::of(model);
  ASSERT_TRUE(straight && swapped);
  EXPECT_EQ(*straight->force({0.3, 45, 0, 80}, 170, 0), *swapped->force({0, 45, 0.3, 80}, 170, 0));
}

TEST(ForceCurves, AModelWithoutAWayIsRefused) {
  fuzzy::ForceModel model = support::ngtVariables();
  model.inputs[2].role = fuzzy::Role::kCondition;
  model.experts.push_back({.id = "E", .label = "E", .overrides = {}, .rules = {{{{"depth", "stomach"}}, "small"}}});
  const auto curves = ForceCurves::of(model);
  ASSERT_FALSE(curves);
  EXPECT_NE(curves.error().message().find("`way`"), std::string::npos);
}

TEST(ForceCurves, PlottedCurvesHoldTheEndsOfAHole) {
  const auto curves = ForceCurves::of(support::s4AsPrinted());
  ASSERT_TRUE(curves);
  // The small force ends at the last vertex of its depth term, 125 mm; the next term begins at 138 mm.
  const ForceCurve curve = curves->plotted({1, 60, 0, 50}, 0);
  const auto silent = [](const CurvePoint& point) { return !point.force_n; };
  const auto first = std::find_if(curve.begin(), curve.end(), silent);
  const auto last = std::find_if(curve.rbegin(), curve.rend(), silent);
  ASSERT_NE(first, curve.end());
  EXPECT_EQ(first->depth_mm, 125);
  EXPECT_EQ(last->depth_mm, 138);
}

}  // namespace
}  // namespace tactus::report
