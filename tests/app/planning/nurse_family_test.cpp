#include "app/planning/nurse_family.h"

#include <cmath>
#include <gtest/gtest.h>

#include "app/planning/simulated_people.h"
#include "core/procedure/procedure.h"

namespace tactus::planning {
namespace {

TEST(SpreadParts, HandCalculation) {
  // Two rows that differ by 2 in every column and by nothing else: the variance between two rows is 2.
  const auto parts = spreadParts({{1, 2, 3, 4}, {3, 4, 5, 6}}, {0, 0, 1, 1});
  EXPECT_NEAR(parts.row, std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(parts.group, 0, 1e-12);
  EXPECT_NEAR(parts.cell, 0, 1e-12);
  EXPECT_EQ(parts.column_mean, (std::vector<double>{2, 3, 4, 5}));
}

TEST(SpreadParts, FindsTheSpreadOfItsInput) {
  base::Random random(3);
  const std::vector<std::size_t> group = {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3};
  std::vector<std::vector<double>> rows;
  for (int r = 0; r < 2000; ++r) {
    const double all = 0.5 * random.normal();
    std::vector<double> of_group;
    for (int g = 0; g < 4; ++g) of_group.push_back(0.4 * random.normal());
    auto& row = rows.emplace_back();
    for (const std::size_t g : group) row.push_back(all + of_group[g] + 0.3 * random.normal());
  }
  const auto parts = spreadParts(rows, group);
  // 2,000 rows: a standard deviation is known to about 2 %.
  EXPECT_NEAR(parts.row, 0.5, 0.05);
  EXPECT_NEAR(parts.group, 0.4, 0.03);
  EXPECT_NEAR(parts.cell, 0.3, 0.02);
}

TEST(NurseFamily, DefaultsComeFromThePublishedTables) {
  const auto questions = questionsOf(procedure::defaultProcedure());
  const auto family = defaultFamily(questions);
  EXPECT_EQ(questions.items.size(), 45U);
  EXPECT_EQ(family.level.size(), 45U);
  EXPECT_EQ(family.threshold_n.size(), 4U);
  // Table 1: the geometric means of the four nurses.
  const double slow = std::pow(46.0 * 121.1 * 57.9 * 31.1, 0.25);
  EXPECT_NEAR(family.speed_mm_s[0], slow, 1e-9);
  EXPECT_LT(family.speed_mm_s[0], family.speed_mm_s[1]);
  EXPECT_LT(family.speed_mm_s[1], family.speed_mm_s[2]);
  EXPECT_GT(family.threshold_log, 0);
}

TEST(SimulatedPeople, TheForceTermsOfOneAreHerOwn) {
  const auto questions = questionsOf(procedure::defaultProcedure());
  TrueNurse nurse;
  nurse.threshold_n = {0.25, 0.45, 0.65, 0.85};
  nurse.level.assign(45, 2);
  nurse.speed_mm_s = {50, 120, 220};
  const auto data = trueDataOf(questions, nurse);
  ASSERT_TRUE(data);
  const auto output = outputOf(questions, {&*data, 1}, elicitation::ForceTermsFrom::kThresholds);
  ASSERT_TRUE(output);
  // Judged at 0.1, 0.2, …: a threshold half way between two forces is found exactly, with ramps of half a step.
  EXPECT_NEAR(output->terms[2].points[0], 0.40, 1e-9);
  EXPECT_NEAR(output->terms[2].points[1], 0.50, 1e-9);
  EXPECT_NEAR(output->terms[2].points[2], 0.60, 1e-9);
  EXPECT_NEAR(output->terms[2].points[3], 0.70, 1e-9);
}

}  // namespace
}  // namespace tactus::planning
