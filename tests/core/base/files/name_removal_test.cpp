#include "core/base/files/name_removal.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace tactus::base {
namespace {

using Names = std::vector<std::string>;

TEST(NameRemoval, ANameGoesWhereverItStands) {
  const Names names = {"velvet-otter"};
  EXPECT_EQ(withoutNames("velvet-otter", names), "(withdrawn)");
  EXPECT_EQ(withoutNames("edit: velvet-otter: 3 rules, after velvet-otter's visit", names),
            "edit: (withdrawn): 3 rules, after (withdrawn)'s visit");
  EXPECT_EQ(withoutNames("NAME: velvet-otter alone", names), "NAME: (withdrawn) alone");
  EXPECT_EQ(withoutNames("velvet-otters Regeln, velvet-otter_old", names), "(withdrawn)s Regeln, (withdrawn)_old");
  EXPECT_FALSE(holdsName("velvet", names));
  EXPECT_FALSE(holdsName("", names));
  EXPECT_EQ(withoutNames("nobody", names), "nobody");
}

TEST(NameRemoval, AnotherCodeOrWordIsNotTheName) {
  EXPECT_FALSE(holdsName("S45", Names{"S4"}));
  EXPECT_FALSE(holdsName("S4-2", Names{"S4"}));
  EXPECT_FALSE(holdsName("XS4", Names{"S4"}));
  EXPECT_FALSE(holdsName("S4x", Names{"S4"}));
  EXPECT_FALSE(holdsName("S4\xC3\xA4", Names{"S4"}));
  EXPECT_FALSE(holdsName("nurse12", Names{"nurse1"}));
  EXPECT_FALSE(holdsName("calm-fox", Names{"calm"}));
  EXPECT_FALSE(holdsName("calm-fox", Names{"fox"}));
  EXPECT_TRUE(holdsName("calm - fox", Names{"fox"}));
  EXPECT_TRUE(holdsName("N01-rules", Names{"N01"}));
  EXPECT_TRUE(holdsName("S4-", Names{"S4"}));
  EXPECT_TRUE(holdsName("S4-b", Names{"S4"}));
  EXPECT_TRUE(holdsName("_S4_", Names{"S4"}));
  EXPECT_FALSE(holdsName("anything", Names{""}));
  EXPECT_TRUE(holdsName("(+4)", Names{"+4"}));
  EXPECT_EQ(withoutNames("Schwester Gr\xC3\xB6\xC3\x9F"
                         "er.",
                         Names{"Gr\xC3\xB6\xC3\x9F"
                               "er"}),
            "Schwester (withdrawn).");
}

TEST(NameRemoval, TheOrderOfNamesDoesNotMatter) {
  const std::string text = "S4, S4-2 and S5: calm-fox and calm-fox-3";
  const Names all = {"S4", "S4-2", "calm-fox", "calm-fox-3"};
  const Names turned = {"calm-fox-3", "calm-fox", "S4-2", "S4"};
  const std::string expected = "(withdrawn), (withdrawn) and S5: (withdrawn) and (withdrawn)";
  EXPECT_EQ(withoutNames(text, all), expected);
  EXPECT_EQ(withoutNames(text, turned), expected);
  std::string one_by_one = text;
  for (const auto& name : all) one_by_one = withoutNames(one_by_one, Names{name});
  EXPECT_EQ(one_by_one, expected);
}

}  // namespace
}  // namespace tactus::base
