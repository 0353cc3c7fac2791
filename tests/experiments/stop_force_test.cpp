#include "experiments/stop_force.h"

#include <gtest/gtest.h>
#include <vector>

#include "core/base/random.h"

namespace tactus::experiments {
namespace {

std::vector<StopAnswer> answers(const std::vector<std::pair<double, bool>>& said) {
  std::vector<StopAnswer> out;
  for (const auto& [force_n, stop] : said) out.push_back({"S1", "ascending", 1, force_n, stop});
  return out;
}

TEST(StopForce, LiesInTheMiddleBetweenGoingOnAndStopping) {
  const auto force = stopForce(answers({{0.2, false}, {0.4, false}, {0.6, true}, {0.8, true}}));
  EXPECT_EQ(force.asked, 4U);
  EXPECT_EQ(force.stops, 2U);
  EXPECT_EQ(force.highest_on_n, 0.4);
  EXPECT_EQ(force.lowest_stop_n, 0.6);
  EXPECT_DOUBLE_EQ(*force.stop_force_n, 0.5);
}

TEST(StopForce, OfAnswersThatMirrorEachOtherIsTheirMiddle) {
  const auto force = stopForce(answers({{0.2, false}, {0.4, true}, {0.6, false}, {0.8, true}}));
  EXPECT_EQ(force.highest_on_n, 0.6);
  EXPECT_EQ(force.lowest_stop_n, 0.4);
  EXPECT_NEAR(*force.stop_force_n, 0.5, 1e-9);
}

TEST(StopForce, IsNotKnownWhereOneAnswerIsMissing) {
  EXPECT_EQ(stopForce({}).stop_force_n, std::nullopt);
  EXPECT_EQ(stopForce(answers({{0.2, false}, {2, false}})).stop_force_n, std::nullopt);
  EXPECT_EQ(stopForce(answers({{0.2, true}})).stop_force_n, std::nullopt);
}

TEST(StopForce, FindsWhereAResponderStops) {
  base::Random random(5);
  std::vector<std::pair<double, bool>> said;
  for (int round = 0; round < 40; ++round) {
    for (int step = 1; step <= 12; ++step) {
      const double force_n = step / 5.0;
      said.emplace_back(force_n, force_n + 0.2 * random.normal() >= 1.7);
    }
  }
  // 40 answers near the threshold, sd 0.2 N: the standard error of the threshold is about 0.03 N.
  EXPECT_NEAR(*stopForce(answers(said)).stop_force_n, 1.7, 0.1);
}

}  // namespace
}  // namespace tactus::experiments
