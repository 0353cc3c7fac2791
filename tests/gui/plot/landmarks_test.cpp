#include "app/workbench/plot/landmarks.h"

#include <gtest/gtest.h>

namespace tactus::workbench {
namespace {

TEST(Landmarks, StandOnADepthAxisOnly) {
  fuzzy::Variable variable{"depth", "Insertion depth", "mm", 0, 600, {}};
  const std::vector<Landmark> all = landmarksFor(variable);
  ASSERT_EQ(all.size(), 6U);
  for (const Landmark& landmark : all) {
    EXPECT_FALSE(landmark.name.isEmpty());
    EXPECT_FALSE(landmark.what.isEmpty());
    EXPECT_FALSE(landmark.source.isEmpty());
    EXPECT_LE(landmark.from_mm, landmark.to_mm);
  }
  variable.max = 150;
  EXPECT_EQ(landmarksFor(variable).size(), 2U);  // turbinate and bend
  variable.unit = "cm";
  EXPECT_TRUE(landmarksFor(variable).empty());
  variable = {"speed", "Speed", "mm", 0, 600, {}};
  EXPECT_TRUE(landmarksFor(variable).empty());
}

}  // namespace
}  // namespace tactus::workbench
