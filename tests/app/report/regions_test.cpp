#include "app/report/regions.h"

#include <gtest/gtest.h>

#include "tests/support/french_probe.h"
#include "tests/support/ngt_model.h"

namespace tactus::report {
namespace {

fuzzy::Variable depth() { return support::ngtVariables().inputs[2]; }

std::vector<Region> regionsOfNgt(const fuzzy::Variable& way) { return wayRegions(*procedure::defaultProcedure(), way); }

TEST(Regions, EndWhereNeighboringTermsAreEqual) {
  // The default terms cross at 70, 115, 150, 200 and 440 mm.
  const std::vector<Region> regions = regionsOfNgt(depth());
  ASSERT_EQ(regions.size(), 6U);
  const std::vector<double> limits = {70, 115, 150, 200, 440, 600};
  for (std::size_t i = 0; i < limits.size(); ++i) EXPECT_DOUBLE_EQ(regions[i].to_mm, limits[i]);
  EXPECT_DOUBLE_EQ(regions[0].from_mm, 0);
}

TEST(Regions, CrossingOfUnequalRampsIsWhereTheirMembershipsAre) {
  fuzzy::Variable variable = depth();
  variable.terms[0].points = {0, 0, 40, 80};                       // 1 - (x - 40)/40
  variable.terms[1].points = {60, 80, 105, 125};                   // (x - 60)/20: equal 1/3 at 66 2/3
  EXPECT_NEAR(regionsOfNgt(variable)[0].to_mm, 200.0 / 3, 1e-12);  // rounding of one division
}

TEST(Regions, AnAbsentTermLeavesTheDefaultLimits) {
  fuzzy::Variable variable = depth();
  variable.terms.erase(variable.terms.begin() + 2);  // no oropharynx
  const std::vector<Region> regions = regionsOfNgt(variable);
  EXPECT_DOUBLE_EQ(regionOf(regions, "oropharynx").from_mm, 115);
  EXPECT_DOUBLE_EQ(regionOf(regions, "oropharynx").to_mm, 150);
}

TEST(Regions, WhereaboutsNamesRegionsAndBorders) {
  const std::vector<Region> regions = regionsOfNgt(depth());
  EXPECT_EQ(whereabouts(regions, 30), "nasal cavity");
  EXPECT_EQ(whereabouts(regions, 200), "border of laryngopharynx and esophagus");
  EXPECT_EQ(whereabouts(regions, 600), "stomach");
}

TEST(Regions, OfAnotherProcedureAreItsOwn) {
  const auto probe = support::frenchProbe();
  const std::vector<Region> regions = wayRegions(*probe, probe->wayInput());
  ASSERT_EQ(regions.size(), 3U);
  // The terms of [0, 60] mm cross at 20 and 40 mm.
  EXPECT_NEAR(regions[1].from_mm, 20, 1e-12);
  EXPECT_NEAR(regions[1].to_mm, 40, 1e-12);
  EXPECT_EQ(regions[2].to_mm, 60);
  EXPECT_EQ(regions[1].code, "CA");
  EXPECT_EQ(regions[1].label, "capsule");
}

}  // namespace
}  // namespace tactus::report
