#include <gtest/gtest.h>

#include "app/report/svg_plot.h"

namespace tactus::report {
namespace {

TEST(ReportTicks, AreMultiplesOfARoundStep) {
  EXPECT_EQ(niceTicks(0, 600, 6), (std::vector<double>{0, 100, 200, 300, 400, 500, 600}));
  EXPECT_EQ(niceTicks(-3, 7, 5), (std::vector<double>{-2, 0, 2, 4, 6}));
}

TEST(ReportTicks, IncludeTheEndsInSpiteOfRounding) {
  const std::vector<double> ticks = niceTicks(0, 1.1, 11);
  ASSERT_EQ(ticks.size(), 12U);
  EXPECT_DOUBLE_EQ(ticks.back(), 1.1);
}

TEST(ReportTicks, AnAxisBetweenTwoMultiplesGetsItsEnds) {
  EXPECT_EQ(niceTicks(0.11, 0.12, 2).size(), 3U);  // 0.110, 0.115, 0.120
  EXPECT_GE(niceTicks(0.4, 9.6, 2).size(), 2U);
}

TEST(ReportTicks, TextsHaveTheFewestDecimalsThatTellThemApart) {
  EXPECT_EQ(tickTexts({0, 100, 200}), (std::vector<std::string>{"0", "100", "200"}));
  EXPECT_EQ(tickTexts({0, 0.25, 0.5}), (std::vector<std::string>{"0.00", "0.25", "0.50"}));
  EXPECT_EQ(tickTexts({-0.0, 0.2}), (std::vector<std::string>{"0.0", "0.2"}));
}

}  // namespace
}  // namespace tactus::report
