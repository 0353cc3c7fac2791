#include "core/analysis/sample_points.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace tactus::analysis {
namespace {

using Choice = SamplePoints::Choice;

std::vector<double> upTo(int last) {
  std::vector<double> values;
  for (int k = 0; k <= last; ++k) values.push_back(k);
  return values;
}

TEST(SamplePoints, AllCombinationsWhereTheyAreFew) {
  const SamplePoints points({{1, 2}, {3, 4, 5}}, 6);
  ASSERT_TRUE(points.all());
  ASSERT_EQ(points.size(), 6U);
  EXPECT_EQ(points[0], (std::vector<double>{1, 3}));
  EXPECT_EQ(points[3], (std::vector<double>{2, 4}));
  EXPECT_EQ(points[5], (std::vector<double>{2, 5}));
}

TEST(SamplePoints, ASelectionWhereTheyAreMany) {
  const SamplePoints points({upTo(99), upTo(99), upTo(99)}, 50);
  EXPECT_FALSE(points.all());
  EXPECT_EQ(points.size(), 50U);
  EXPECT_EQ(points[7], points.at(points.choice(7)));
}

// A value that falls with the distance from (70, 20): one pass over each input finds the place.
TEST(SamplePoints, ClimbsToTheBestValueOfEachInput) {
  const SamplePoints points({upTo(99), upTo(99)}, 500);
  const auto value = [](const Choice& c) {
    const double x = static_cast<double>(c[0]) - 70;
    const double y = static_cast<double>(c[1]) - 20;
    return -x * x - y * y;
  };
  std::vector<double> seen;
  const Choice start = {0, 0};
  points.climb(start, value(start), [&](const Choice& c) -> std::optional<double> {
    seen.push_back(value(c));
    return seen.back();
  });
  EXPECT_EQ(*std::max_element(seen.begin(), seen.end()), 0);
  EXPECT_LT(seen.size(), 500U);
}

TEST(SamplePoints, ClimbsNoLongerThanItHasPoints) {
  const SamplePoints points({upTo(99), upTo(99)}, 30);
  int looks = 0;
  points.climb({0, 0}, -1, [&](const Choice& c) -> std::optional<double> {
    ++looks;
    return static_cast<double>(c[0] + c[1]);
  });
  EXPECT_EQ(looks, 30);
}

TEST(SamplePoints, WhereAllWasSeenThereIsNothingToClimb) {
  const SamplePoints points({{1, 2}, {3, 4}}, 10);
  points.climb({0, 0}, 0, [](const Choice&) -> std::optional<double> {
    ADD_FAILURE();
    return std::nullopt;
  });
}

}  // namespace
}  // namespace tactus::analysis
