#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "core/base/random.h"
#include "elicitation/clustering/fcm.h"
#include "elicitation/speed/speed_terms.h"

namespace tactus::elicitation {
namespace {

// m = 3: a membership is 1/d by the sum of all 1/d, so 1/u - 1 of a cluster is its distance by each of the others.
TEST(MembershipEdge, AThirdCentreByHand) {
  const std::vector<double> centres = {0, 1, 2};
  // At 1/4: (1/4)/(3/4) + (1/4)/(7/4) = 1/3 + 1/7 = 10/21.
  EXPECT_NEAR(membershipEdge(centres, 0, 1, 3, 21.0 / 31), 0.25, 1e-15);
  // At 3/4, from 1 downwards: (1/4)/(3/4) + (1/4)/(5/4) = 1/3 + 1/5 = 8/15. The other side is its mirror image.
  EXPECT_NEAR(membershipEdge(centres, 1, 0, 3, 15.0 / 23), 0.75, 1e-15);
  EXPECT_NEAR(membershipEdge(centres, 1, 2, 3, 15.0 / 23), 1.25, 1e-15);
}

TEST(MembershipEdge, ANeighborVeryNearOnTheOtherSide) {
  // m = 3 and a center 1e-9 behind: at a distance d in the long gap 1/u - 1 = d/(1 - d) + d/(d + 1e-9), which is 1/4 at
  // d = 1e-9/3 but for terms of 1e-9 of it.
  const double edge = membershipEdge(std::vector<double>{0, 1e-9, 1}, 1, 2, 3, 0.8);
  EXPECT_NEAR((edge - 1e-9) / (1e-9 / 3), 1, 1e-8);
}

TEST(MembershipEdge, HasTheMembershipAndLosesItBeyond) {
  base::Random random(7);
  for (int round = 0; round < 500; ++round) {
    std::vector<double> centres = {random.uniform(-1, 1)};
    for (int k = random.below(4); k >= 0; --k) centres.push_back(centres.back() + std::exp(random.uniform(-9, 3)));
    const auto cluster = static_cast<std::size_t>(random.below(static_cast<int>(centres.size()) - 1));
    const double m = 1 + std::exp(random.uniform(-3, 4));
    const double alpha = random.uniform(0.5001, 0.9999);
    const double edge = membershipEdge(centres, cluster, cluster + 1, m, alpha);
    std::vector<double> u(centres.size());
    fcmMemberships(edge, centres, m, u);
    EXPECT_GE(u[cluster], alpha * (1 - 1e-14)) << m;  // some roundings of the sum
    // A millionth of the way further the membership is lower by far more than its rounding.
    fcmMemberships(edge + 1e-6 * (centres[cluster + 1] - edge), centres, m, u);
    EXPECT_LT(u[cluster], alpha) << m;
  }
}

}  // namespace
}  // namespace tactus::elicitation
