#include <gtest/gtest.h>

#include "app/workbench/feel/procedure.h"

#include "tests/gui/sample_models.h"

namespace tactus::workbench {
namespace {

fuzzy::Variable partition() {
  const auto trapezoid = [](const char* id, std::vector<double> points) {
    return fuzzy::Term{id, id, fuzzy::Shape::kTrapezoid, std::move(points)};
  };
  return {"depth",
          "Depth",
          "mm",
          0,
          600,
          {trapezoid("nose", {0, 0, 60, 80}), trapezoid("throat", {60, 80, 185, 215}),
           trapezoid("esophagus", {185, 215, 600, 600})}};
}

TEST(DepthRegions, MeetWhereNeighborsAreEquallyTrue) {
  const auto regions = depthRegions(partition());
  ASSERT_EQ(regions.size(), 3u);
  constexpr double kStep = 600.0 / 4000;
  EXPECT_EQ(regions[0].from_mm, 0);
  EXPECT_NEAR(regions[0].to_mm, 70, kStep);
  EXPECT_EQ(regions[1].from_mm, regions[0].to_mm);
  EXPECT_NEAR(regions[1].to_mm, 200, kStep);
  EXPECT_EQ(regions[2].to_mm, 600);
  EXPECT_EQ(regions[2].label, QStringLiteral("esophagus"));
}

TEST(DepthRegions, LeaveOutWhatBelongsToNoTerm) {
  const auto regions = depthRegions(tests::twoExperts().inputs[1]);  // nothing between 5 and 6
  ASSERT_EQ(regions.size(), 2u);
  constexpr double kStep = 10.0 / 4000;
  EXPECT_NEAR(regions[0].to_mm, 5, kStep);
  EXPECT_NEAR(regions[1].from_mm, 6, kStep);
  EXPECT_FALSE(regionAt(regions, 5.5));
  EXPECT_EQ(regionAt(regions, 0), 0u);
  EXPECT_EQ(regionAt(regions, 10), 1u);
  EXPECT_FALSE(regionAt(regions, 10.1));
  EXPECT_FALSE(regionAt(regions, -1));
}

}  // namespace
}  // namespace tactus::workbench
