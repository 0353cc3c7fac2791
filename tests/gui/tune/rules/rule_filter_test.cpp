#include <gtest/gtest.h>

#include "app/workbench/tune/rules/rule_rows.h"

namespace tactus::workbench {
namespace {

const RuleWords kRule{{QStringLiteral("Tube lubrication is Well"), QStringLiteral("Insertion depth is Stomach")},
                      QStringLiteral("Very small")};

bool takes(const char* typed) { return RuleFilter(QString::fromLatin1(typed)).takes(kRule); }

TEST(RuleFilter, TakesEveryRuleWhileNothingIsTyped) {
  EXPECT_TRUE(takes(""));
  EXPECT_TRUE(takes("   "));
}

TEST(RuleFilter, WordsStandForThemselves) {
  EXPECT_TRUE(takes("well STOM"));
  EXPECT_TRUE(takes("small tube"));
  EXPECT_FALSE(takes("well esophagus"));
}

TEST(RuleFilter, PartsBetweenAndMeanOneConditionEach) {
  EXPECT_TRUE(takes("if depth stomach and lubrication is well"));
  EXPECT_FALSE(takes("if depth well and stomach"));
  EXPECT_TRUE(takes("well and very small"));
}

TEST(RuleFilter, WhatStandsBehindThenIsTheConsequent) {
  EXPECT_TRUE(takes("if well then small"));
  EXPECT_TRUE(takes("then very"));
  EXPECT_FALSE(takes("then stomach"));
  EXPECT_FALSE(takes("if small then small"));
  EXPECT_TRUE(takes("if well and stomach then"));  // still being typed
}

}  // namespace
}  // namespace tactus::workbench
