#include "app/workbench/plot/label_layout.h"

#include <gtest/gtest.h>

namespace tactus::workbench {
namespace {

TEST(LabelLayout, NamesWithRoomStandCenteredInTheLowestRow) {
  const std::vector<Label> labels = {{50, 40}, {150, 40}};
  const auto places = placeLabels(labels, 2, 0, 200, 8);
  ASSERT_TRUE(places[0] && places[1]);
  EXPECT_EQ(places[0]->left, 30);
  EXPECT_EQ(places[1]->left, 130);
  EXPECT_EQ(places[0]->row, 0);
  EXPECT_EQ(places[1]->row, 0);
}

TEST(LabelLayout, NamesNeverOverlapAndStayInside) {
  const std::vector<Label> labels = {{12, 68}, {36, 70}, {51, 65}, {68, 88}, {124, 58}, {200, 50}};
  const auto places = placeLabels(labels, 2, 0, 260, 8);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    ASSERT_TRUE(places[i]) << i;
    EXPECT_GE(places[i]->left, 0);
    EXPECT_LE(places[i]->left + labels[i].width, 260);
    for (std::size_t j = 0; j < i; ++j) {
      if (places[i]->row != places[j]->row) continue;
      EXPECT_GE(places[i]->left, places[j]->left + labels[j].width + 8);
    }
  }
}

TEST(LabelLayout, ANameWithoutRoomIsLeftOut) {
  const std::vector<Label> labels = {{50, 90}, {50, 90}};
  const auto places = placeLabels(labels, 1, 0, 100, 8);
  EXPECT_NE(places[0].has_value(), places[1].has_value());
}

TEST(LabelLayout, ManyNamesDoNotTakeForever) {
  const std::vector<Label> labels(64, Label{100, 40});
  EXPECT_EQ(placeLabels(labels, 2, 0, 400, 8).size(), 64U);
}

}  // namespace
}  // namespace tactus::workbench
