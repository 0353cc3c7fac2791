#include <gtest/gtest.h>

#include "experiments/speed_from_positions.h"

namespace tactus::experiments {
namespace {

TEST(EvenPositions, UnevenSamplesOfAStraightLineStayOnIt) {
  EvenPositions positions({2, 10});
  const double steps_s[] = {0.0004, 0.003, 0.0011, 0.007, 0.012, 0.0005, 0.02};
  double time_s = 2;
  for (const double step_s : steps_s) {
    time_s += step_s;
    positions.add({time_s, 10 + 50 * (time_s - 2)});
  }
  // 44 ms are 45 fine steps from 0 ms on: eleven blocks of four.
  ASSERT_EQ(positions.size(), 11U);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double at_s = positions.timeS(static_cast<double>(i));
    EXPECT_NEAR(at_s, 2 + 0.0015 + 0.004 * static_cast<double>(i), 1e-12);
    EXPECT_NEAR(positions.at(i), 10 + 50 * (at_s - 2), 1e-9);  // the mean of four points of a line is their middle
  }
  positions.forgetBefore(4);
  EXPECT_EQ(positions.first(), 4U);
  EXPECT_EQ(positions.size(), 11U);
  EXPECT_NEAR(positions.at(4), 10 + 50 * 0.0175, 1e-9);
}

}  // namespace
}  // namespace tactus::experiments
