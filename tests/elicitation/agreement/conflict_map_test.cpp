#include "elicitation/agreement/conflict_map.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/support/invented_experts.h"

namespace tactus::elicitation {
namespace {

const CellConflict& cellOf(const ConflictMap& map, std::string_view term, std::string_view region) {
  return *std::find_if(map.cells.begin(), map.cells.end(), [&](const CellConflict& cell) {
    return cell.conditions[0].term == term && cell.conditions[1].term == region;
  });
}

// Numbers of another program, to the digits that it printed.
TEST(ConflictMap, GivesTheNumbersOfAnotherProgramForFourExperts) {
  const auto map = conflictMap(support::inventedExperts());
  ASSERT_TRUE(map) << map.error().message();
  EXPECT_EQ(map->points, 4096U);
  EXPECT_EQ(map->cells.size(), 45U);
  EXPECT_NEAR(map->between_n, .107553, 5e-7);
  EXPECT_NEAR(map->largest_spread_n, .457143, 5e-7);

  const auto& large_es = cellOf(*map, "large", "esophagus");
  EXPECT_NEAR(large_es.rms_n, .11787, 5e-6);
  EXPECT_NEAR(large_es.rms_noticeable, 1.4125, 5e-5);
  EXPECT_NEAR(large_es.share, .1308, 5e-5);
  EXPECT_EQ(large_es.middle_word, "medium");

  const auto& poor_es = cellOf(*map, "poor", "esophagus");
  EXPECT_NEAR(poor_es.rms_n, .11405, 5e-6);
  EXPECT_NEAR(poor_es.rms_noticeable, 1.2651, 5e-5);
  EXPECT_NEAR(poor_es.share, .1898, 5e-5);
  EXPECT_NEAR(poor_es.stake_n, .07854, 5e-6);

  EXPECT_NEAR(cellOf(*map, "fast", "laryngopharynx").rms_n, .10751, 5e-6);
  EXPECT_NEAR(cellOf(*map, "fast", "nasopharynx").rms_n, .10638, 5e-6);
  EXPECT_NEAR(cellOf(*map, "fast", "esophagus").rms_n, .10560, 5e-6);
  EXPECT_NEAR(cellOf(*map, "fast", "esophagus").share, .1637, 5e-5);
  EXPECT_EQ(cellOf(*map, "well", "nasal_cavity").rms_n, 0);
}

// The spread of the four along the curve of Fig. 11, printed for six depths.
TEST(ConflictMap, TakesThePointsOfTheCaller) {
  const std::vector<std::pair<double, double>> printed = {{30, .18451}, {90, .2},  {150, .14302},
                                                          {200, .15},   {300, .1}, {500, .23545}};
  for (const auto& [depth_mm, spread_n] : printed) {
    ConflictSettings settings;
    settings.points = {{1, 60, depth_mm, 50}};
    const auto map = conflictMap(support::inventedExperts(), settings);
    ASSERT_TRUE(map);
    EXPECT_NEAR(map->largest_spread_n, spread_n, 5e-6) << depth_mm;
    EXPECT_EQ(map->spread_at, settings.points[0]);
  }
}

/// Regions near and far of one input, forces .2, .5 and .8 N by symmetric terms, whose centroid stays at any strength.
fuzzy::ForceModel threeForces() {
  constexpr auto kTrapezoid = fuzzy::Shape::kTrapezoid;
  fuzzy::ForceModel model;
  model.name = "test";
  model.inputs = {
      {"x", "X", "1", 0, 1, {{"near", "", kTrapezoid, {0, 0, 0.5, 0.5}}, {"far", "", kTrapezoid, {0.5, 0.5, 1, 1}}}}};
  model.output = {"force",
                  "Force",
                  "N",
                  0,
                  1,
                  {{"small", "", kTrapezoid, {0.1, 0.2, 0.2, 0.3}},
                   {"medium", "", kTrapezoid, {0.4, 0.5, 0.5, 0.6}},
                   {"large", "", kTrapezoid, {0.7, 0.8, 0.8, 0.9}}}};
  return model;
}

fuzzy::Expert saying(const char* id, const char* near, const char* far, double weight = 1) {
  fuzzy::Expert expert{id, id, weight, {}, {}};
  if (near != nullptr) expert.rules.push_back({{{"x", "near"}}, near});
  if (far != nullptr) expert.rules.push_back({{{"x", "far"}}, far});
  return expert;
}

constexpr double kCentroidRounding = 1e-12;  // of the centroids

TEST(ConflictMap, OfTwoExpertsByHand) {
  auto model = threeForces();
  model.experts = {saying("A", "small", "medium"), saying("B", "small", "large")};
  ConflictSettings settings;
  settings.points = {{0.2}, {0.8}, {0.9}};
  std::vector<double> progress;
  settings.progress = [&](double share) { progress.push_back(share); };
  const auto map = conflictMap(model, settings);
  ASSERT_TRUE(map) << map.error().message();
  EXPECT_EQ(progress, (std::vector<double>{0.5, 1}));
  ASSERT_EQ(map->cells.size(), 2U);
  EXPECT_EQ(map->cells[0].points, 1U);
  EXPECT_EQ(map->cells[0].rms_n, 0);
  const auto& far = map->cells[1];
  EXPECT_EQ(far.points, 2U);
  EXPECT_EQ(far.words, (std::vector<std::string>{"medium", "large"}));
  EXPECT_EQ(far.middle_word, "large") << "the upper median";
  EXPECT_NEAR(far.felt_n[0], 0.5, kCentroidRounding);
  EXPECT_NEAR(far.felt_n[1], 0.8, kCentroidRounding);
  // Both move by .3 with the other's word; the mean is .65 and goes to .8; no variance is left.
  EXPECT_NEAR(far.rms_n, 0.3, kCentroidRounding);
  EXPECT_NEAR(far.largest_n, 0.3, kCentroidRounding);
  EXPECT_NEAR(far.rms_noticeable, 0.3 / std::hypot(0.04, 0.12 * 0.65), 1e-11);
  EXPECT_NEAR(far.stake_n, 0.15, kCentroidRounding);
  EXPECT_NEAR(far.share, 1, kCentroidRounding);
  // Standard deviations 0, .3 / sqrt 2, .3 / sqrt 2 at the three points.
  EXPECT_NEAR(map->between_n, std::sqrt(0.09 / 3), kCentroidRounding);
}

TEST(ConflictMap, WhoSaysTheSameCountsAndMovesNothing) {
  auto model = threeForces();
  model.experts = {saying("A", "small", nullptr), saying("B", "small", nullptr), saying("C", "large", nullptr)};
  const auto map = conflictMap(model);
  ASSERT_TRUE(map);
  ASSERT_EQ(map->cells.size(), 1U);
  EXPECT_EQ(map->cells[0].middle_word, "small");
  EXPECT_NEAR(map->cells[0].rms_n, std::sqrt(4.0 / 6) * 0.6, kCentroidRounding) << "four of six ordered pairs differ";
  EXPECT_NEAR(map->cells[0].stake_n, 0.2, kCentroidRounding) << "the mean falls from .4 to .2";
}

TEST(ConflictMap, AnExpertWithoutTheRuleOrWithoutWeightTakesNoPart) {
  auto model = threeForces();
  model.experts = {saying("A", "small", "small"), saying("B", "small", nullptr), saying("C", "large", "large", 0)};
  const auto map = conflictMap(model);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->cells[1].words, (std::vector<std::string>{"small", "", "large"}));
  for (const auto& cell : map->cells) {
    EXPECT_EQ(cell.rms_n, 0);
    EXPECT_EQ(cell.middle_word, "small");
  }
  EXPECT_EQ(map->between_n, 0);
}

TEST(ConflictMap, EndsOnRequestAndRefusesABrokenModel) {
  std::stop_source source;
  ConflictSettings settings;
  settings.stop = source.get_token();
  settings.progress = [&](double) { source.request_stop(); };
  const auto stopped = conflictMap(support::inventedExperts(), settings);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, base::ErrorCode::kCancelled);
  EXPECT_FALSE(conflictMap(threeForces()));
}

}  // namespace
}  // namespace tactus::elicitation
