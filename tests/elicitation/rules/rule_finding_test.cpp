#include "elicitation/rules/rule_finding.h"

#include <gtest/gtest.h>

namespace tactus::elicitation {
namespace {

TEST(RuleFinding, SourcesInWords) {
  EXPECT_EQ(describe({}), "");
  EXPECT_EQ(describe({{0, {}}, {4, {}}}), "rules 1, 5");
  EXPECT_EQ(describe({{1, {"", 0, {3}}}}), "rule 2 (rules.csv, line 3)");
  EXPECT_EQ(describe({{1, {"f", 3, {4}}}, {2, {"f", 8, {9}}}}), "items 3, 8 (answers.csv, lines 4, 9)");
  EXPECT_EQ(describe({{{}, {"f", 7, {}}}}), "item 7");
  std::vector<RuleFinding::Source> many;
  for (int item = 1; item <= 30; ++item) many.push_back({{}, {"f", item, {}}});
  EXPECT_EQ(describe(many), "items 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12 and 18 more");
}

}  // namespace
}  // namespace tactus::elicitation
