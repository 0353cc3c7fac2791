#include "app/workbench/plot/landmarks.h"

#include <algorithm>
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

TEST(Landmarks, ThePuncturesOfTheModelStandAmongThem) {
  fuzzy::Variable variable{"depth", "Insertion depth", "mm", 0, 600, {}};
  variable.terms = {{"wall", "Wall", fuzzy::Shape::kTrapezoid, {20, 22, 30, 32}},
                    {"end", "End", fuzzy::Shape::kTriangle, {400, 700, 800}}};
  const std::vector<fuzzy::TubeEvent> events = {{"end", 0.25}, {"wall", 0.6}, {"gone", 0.5}};
  const std::size_t others = landmarksFor(variable).size();
  const auto all = landmarksFor(variable, events);
  ASSERT_EQ(all.size(), others + 2);
  const auto wall = std::find_if(all.begin(), all.end(), [](const Landmark& one) { return one.from_mm == 30; });
  ASSERT_NE(wall, all.end());
  EXPECT_EQ(wall->name, QStringLiteral("Puncture: Wall"));
  EXPECT_EQ(wall->what, QStringLiteral("60 % of the force is lost, once in a stroke"));
  EXPECT_EQ(all.back().from_mm, 600) << "a core that ends beyond the universe ends with it";
  variable.id = "speed";
  EXPECT_TRUE(landmarksFor(variable, events).empty());
}

}  // namespace
}  // namespace tactus::workbench
