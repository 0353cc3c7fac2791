#include "core/base/random.h"

#include <gtest/gtest.h>
#include <vector>

#include "core/base/statistics.h"

namespace tactus::base {
namespace {

TEST(Random, IsTheStandardEngine) {
  // ISO C++, [rand.predef]: the 10000th number of mt19937_64 with the default seed 5489.
  Random random(5489);
  for (int i = 1; i < 10000; ++i) random.next();
  EXPECT_EQ(random.next(), 9981545732273789042ULL);
}

TEST(Random, UniformNumbersStayInTheirRange) {
  Random random(1);
  std::vector<int> counts(5);
  for (int i = 0; i < 50000; ++i) {
    const double x = random.uniform(-2, 3);
    ASSERT_GE(x, -2);
    ASSERT_LT(x, 3);
    const int k = random.below(5);
    ASSERT_GE(k, 0);
    ASSERT_LT(k, 5);
    ++counts[static_cast<std::size_t>(k)];
  }
  // Binomial with mean 10000 and standard deviation 89; five of them.
  for (const int count : counts) EXPECT_NEAR(count, 10000, 450);
}

TEST(Random, NormalNumbersHaveMeanZeroAndDeviationOne) {
  Random random(2);
  std::vector<double> sample(40000);
  for (double& x : sample) x = random.normal();
  // Standard errors: 1/sqrt(n) = 0.005 of the mean, 1/sqrt(2n) = 0.0035 of the deviation; five of them.
  EXPECT_NEAR(mean(sample), 0, 0.025);
  EXPECT_NEAR(standardDeviation(sample), 1, 0.018);
  // Quartile of the standard normal: 0.674490; standard error sqrt(3)/4 / (density 0.317777 * sqrt(n)) = 0.0068.
  EXPECT_NEAR(quantile(sample, 0.75), 0.674490, 0.034);
}

}  // namespace
}  // namespace tactus::base
