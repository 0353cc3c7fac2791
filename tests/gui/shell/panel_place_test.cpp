#include "app/workbench/shell/panel_place.h"

#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace tactus::workbench {
namespace {

using How = PanelPlace::How;

// `editor | curves under editor 52%`
std::string placed(const std::set<std::string>& present) {
  const std::vector<PanelPlace> places = {
      {"editor", How::kFirst, "", 100},    {"grid", How::kTab, "editor"}, {"curves", How::kRight, "editor", 54},
      {"feel", How::kBelow, "curves", 52}, {"map", How::kTab, "feel"},    {"surface", How::kTab, "feel"}};
  std::ostringstream out;
  for (const PanelPlace& place :
       placesOfPresent(places, [&](const std::string& panel) { return present.contains(panel); })) {
    const char* const hows[] = {"first", "right of", "below", "behind"};
    out << place.panel << ' ' << hows[static_cast<int>(place.how)];
    if (place.how != How::kFirst) out << ' ' << place.beside;
    if (place.how == How::kRight || place.how == How::kBelow) out << ' ' << place.percent;
    out << "; ";
  }
  return out.str();
}

TEST(PanelPlaces, AreAsGivenWhereEveryPanelIsThere) {
  EXPECT_EQ(placed({"editor", "grid", "curves", "feel", "map", "surface"}),
            "editor first; grid behind editor; curves right of editor 54; feel below curves 52; map behind feel; "
            "surface behind feel; ");
}

TEST(PanelPlaces, TheNextTabTakesThePlaceOfAMissingPanel) {
  EXPECT_EQ(placed({"editor", "curves", "map", "surface"}),
            "editor first; curves right of editor 54; map below curves 52; surface behind map; ");
  EXPECT_EQ(placed({"grid", "curves"}), "grid first; curves right of grid 54; ");
}

TEST(PanelPlaces, WhatStoodBesideAMissingPanelMovesUp) {
  EXPECT_EQ(placed({"editor", "feel", "map"}), "editor first; feel below editor 52; map behind feel; ");
  EXPECT_EQ(placed({"curves", "map"}), "curves first; map below curves 52; ");
  EXPECT_EQ(placed({}), "");
}

}  // namespace
}  // namespace tactus::workbench
