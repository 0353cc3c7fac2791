#include <gtest/gtest.h>

#include "app/workbench/understand/curves/force_spread.h"

namespace tactus::workbench {
namespace {

/// A curve over x = 0 … 10 with a force from `from` on that is `other`; a force < 0 does not fire.
std::vector<fuzzy::Evaluation> curve(double force_n, double other_n = 0, std::size_t from = 11) {
  std::vector<fuzzy::Evaluation> out;
  for (std::size_t i = 0; i <= 10; ++i) {
    const double value = i < from ? force_n : other_n;
    out.push_back({value < 0 ? 0 : value, value >= 0});
  }
  return out;
}

figures::ForceCurves of(std::vector<std::vector<fuzzy::Evaluation>> experts) {
  figures::ForceCurves curves;
  for (int i = 0; i <= 10; ++i) curves.x.push_back(i);
  curves.mean = experts.front();
  curves.experts = std::move(experts);
  return curves;
}

TEST(CoincidentCurves, CurvesThatLieOnEachOtherAreNumbered) {
  const auto found = coincidences(of({curve(0.5), curve(0.8), curve(0.5), curve(0.5005)}), 0.001);
  EXPECT_EQ(found, (std::vector<Coincidence>{{0, 3}, {0, 1}, {1, 3}, {2, 3}}));
}

TEST(CoincidentCurves, ACommonStretchOfATenthIsEnoughACrossingIsNot) {
  EXPECT_EQ(coincidences(of({curve(0.5), curve(0.5, 0.8, 2)}), 0.001)[1], (Coincidence{1, 2}));
  EXPECT_EQ(coincidences(of({curve(0.5), curve(0.5, 0.8, 1)}), 0.001)[1], (Coincidence{0, 1}));
}

TEST(CoincidentCurves, WhereNobodySpeaksNothingCoincides) {
  EXPECT_EQ(coincidences(of({curve(-1), curve(-1)}), 0.001)[1], (Coincidence{0, 1}));
}

TEST(CoincidentCurves, MoreExpertsThanColorsAreNotCompared) {
  std::vector<std::vector<fuzzy::Evaluation>> many(13, curve(0.5));
  for (const Coincidence& one : coincidences(of(std::move(many)), 0.001)) EXPECT_EQ(one.of, 1U);
}

}  // namespace
}  // namespace tactus::workbench
