#include "core/fuzzy/membership.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/core/fuzzy/trapezoid.h"

namespace tactus::fuzzy {
namespace {

TEST(Membership, RampsAndCoreOfATrapezoid) {
  const auto f = trapezoid(1, 3, 4, 8);
  EXPECT_EQ(f(0.999), 0);
  EXPECT_EQ(f(1), 0);
  EXPECT_EQ(f(2), 0.5);
  EXPECT_EQ(f(3), 1);
  EXPECT_EQ(f(4), 1);
  EXPECT_EQ(f(5), 0.75);
  EXPECT_EQ(f(8), 0);
  EXPECT_EQ(f(9), 0);
}

TEST(Membership, AVerticalEdgeBelongsToTheTerm) {
  const auto f = trapezoid(1, 1, 2, 2);
  EXPECT_EQ(f(std::nextafter(1, 0)), 0);
  EXPECT_EQ(f(1), 1);
  EXPECT_EQ(f(2), 1);
  EXPECT_EQ(f(std::nextafter(2, 3)), 0);
}

TEST(Membership, ASingletonIsOneAtItsPoint) {
  const auto f = trapezoid(5, 5, 5, 5);
  EXPECT_EQ(f(5), 1);
  EXPECT_EQ(f(std::nextafter(5, 6)), 0);
}

TEST(Membership, InsideTheSupportItIsNeverZero) {
  const auto f = trapezoid(0, 1e150, 1e150, 2e150);
  EXPECT_GT(f(5e-324), 0);
}

TEST(Membership, Triangle) {
  const auto f = MembershipFunction::of({"t", "t", Shape::kTriangle, {0, 1, 3}});
  EXPECT_EQ(f(0.25), 0.25);
  EXPECT_EQ(f(1), 1);
  EXPECT_EQ(f(2), 0.5);
}

TEST(Membership, Gaussian) {
  const auto f = MembershipFunction::of({"t", "t", Shape::kGaussian, {2, 0.5}});
  EXPECT_EQ(f(2), 1);
  EXPECT_DOUBLE_EQ(f(2.5), std::exp(-0.5));
  EXPECT_DOUBLE_EQ(f(1), std::exp(-2.0));
}

}  // namespace
}  // namespace tactus::fuzzy
