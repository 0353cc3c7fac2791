// Strokes of a table: whether their units fit, and how their rows stand.
#include "experiments/table_strokes.h"

#include <gtest/gtest.h>

#include "experiments/stroke_units.h"

namespace tactus::experiments {
namespace {

using Rows = std::vector<study::SpeedSample>;

/// A stroke of 60 mm in 1.2 s at 50 mm/s, each column times a factor.
Rows strokeTimes(double time, double depth, double speed) {
  Rows rows;
  for (int i = 0; i <= 120; ++i) rows.push_back({"A", "slow", 1, time * 0.01 * i, depth * 0.5 * i, speed * 50});
  return rows;
}

UnitFit fitOf(const Rows& rows) { return unitFit(tableStrokes(rows).front()); }
RowOrder orderOf(const Rows& rows) { return rowOrder(tableStrokes(rows).front()); }

TEST(StrokeUnits, TheUnitsOfTheFormatFit) {
  const auto fit = fitOf(strokeTimes(1, 1, 1));
  EXPECT_EQ(fit.verdict, UnitFit::Verdict::kFits);
  EXPECT_NEAR(fit.depth_over_speed, 1, 1e-12);
  EXPECT_EQ(fitOf(strokeTimes(1, 1, 1.4)).verdict, UnitFit::Verdict::kFits) << "filters and rounding can give that";
}

TEST(StrokeUnits, AnotherUnitIsFoundByWhatMakesItFit) {
  EXPECT_EQ(fitOf(strokeTimes(1, 1, 0.1)).factors, (UnitFactors{1, 1, 10}));
  EXPECT_EQ(fitOf(strokeTimes(1, 1, 1e-3)).factors, (UnitFactors{1, 1, 1000}));
  EXPECT_EQ(fitOf(strokeTimes(1000, 1, 1)).factors, (UnitFactors{1e-3, 1, 1}));
  EXPECT_EQ(fitOf(strokeTimes(1e6, 1, 1)).factors, (UnitFactors{1e-6, 1, 1}));
  EXPECT_EQ(fitOf(strokeTimes(1, 0.1, 1)).factors, (UnitFactors{1, 10, 1}));
  EXPECT_EQ(fitOf(strokeTimes(1, 1e-3, 1)).factors, (UnitFactors{1, 1000, 1}));
  EXPECT_EQ(fitOf(strokeTimes(1, 1e-3, 1e-3)).factors, (UnitFactors{1, 1000, 1000}));
}

TEST(StrokeUnits, SingleWrongCellsDoNotCount) {
  Rows rows = strokeTimes(1, 1, 1);
  rows[40].speed_mm_s *= 1000;
  rows[80].depth_mm *= 1000;
  EXPECT_EQ(fitOf(rows).verdict, UnitFit::Verdict::kFits);
}

TEST(StrokeUnits, NothingIsSaidWhereNothingCanBeSeen) {
  EXPECT_EQ(fitOf(strokeTimes(0, 1, 1)).verdict, UnitFit::Verdict::kUnknown);
  EXPECT_EQ(fitOf(strokeTimes(1, 0, 1)).verdict, UnitFit::Verdict::kUnknown);
  EXPECT_EQ(fitOf({{"A", "slow", 1, 0, 0, 50}}).verdict, UnitFit::Verdict::kUnknown);
  EXPECT_EQ(fitOf(strokeTimes(1, 1, 3)).verdict, UnitFit::Verdict::kNeither) << "no unit is a third of another";
}

TEST(StrokeRows, OrdersAreToldApart) {
  const Rows rows = strokeTimes(1, 1, 1);
  EXPECT_EQ(orderOf(rows), RowOrder::kRising);
  EXPECT_EQ(orderOf(strokeTimes(0, 1, 1)), RowOrder::kNoTimes);
  EXPECT_EQ(orderOf({rows.rbegin(), rows.rend()}), RowOrder::kBackwards);
  Rows twice = rows;
  twice.insert(twice.end(), rows.begin(), rows.end());
  EXPECT_EQ(orderOf(twice), RowOrder::kTwice);
  Rows restarted = rows;
  for (auto row : rows) {
    row.speed_mm_s += 3;
    restarted.push_back(row);
  }
  EXPECT_EQ(orderOf(restarted), RowOrder::kRestarts);
  Rows mixed = rows;
  for (std::size_t i = 5; i < mixed.size(); i += 3) std::swap(mixed[i], mixed[i - 4]);
  EXPECT_EQ(orderOf(mixed), RowOrder::kUnsorted);
  Rows coarse = rows;  // times rounded to 0.05 s: five rows share one
  for (std::size_t i = 0; i < coarse.size(); ++i) coarse[i].time_s = 0.05 * static_cast<double>(i / 5);
  EXPECT_EQ(orderOf(coarse), RowOrder::kRising);
}

TEST(TableStrokes, AreGroupedWhereverTheirRowsStand) {
  const Rows rows = {{"A", "slow", 1, 0, 0, 1},
                     {"B", "slow", 1, 0, 0, 1},
                     {"A", "slow", 1, 1, 1, 1},
                     {"A", "fast", 1, 0, 0, 2},
                     {"A", "slow", 1, 1, 1, 1}};
  const auto strokes = tableStrokes(rows);
  ASSERT_EQ(strokes.size(), 3U);
  EXPECT_EQ(strokes[0].rows.size(), 3U);
  EXPECT_EQ(strokes[0].in_time.size(), 2U) << "a row that stands twice is one";
  const auto participants = byParticipant(strokes);
  ASSERT_EQ(participants.size(), 2U);
  EXPECT_EQ(strokesText(participants[0], 2), "all 2 strokes");
  EXPECT_EQ(strokesText(participants[1], 5), "stroke 1 at slow");
}

}  // namespace
}  // namespace tactus::experiments
