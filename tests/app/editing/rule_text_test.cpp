#include <gtest/gtest.h>

#include "app/editing/rule_edits.h"
#include "app/editing/rule_grid.h"

#include "tests/app/editing/sample_models.h"

namespace tactus::editing {
namespace {

using fuzzy::Rule;

class RuleText : public testing::Test {
 protected:
  RuleText() {
    auto& expert = model_.experts[0];
    expert.rules[1].weight = 0.5;
    expert.rules[2].enabled = false;
  }

  const fuzzy::Expert& expert() const { return model_.experts[0]; }
  std::string refusedLine(const std::string& text) const {
    const auto rules = rulesFromText(model_, expert(), text);
    return rules ? std::string() : rules.error().message();
  }

  fuzzy::ForceModel model_ = support::s4AsPrinted();
};

TEST_F(RuleText, ARuleIsOneLineWithItsWeightAndItsState) {
  const std::vector<std::size_t> three = {0, 1, 2};
  EXPECT_EQ(rulesAsText(model_, expert(), three),
            "IF Tube lubrication is well AND Depth is nasal_cavity THEN Force is very_small\n"
            "IF Tube lubrication is well AND Depth is nasopharynx THEN Force is small WITH 0.5\n"
            "OFF IF Tube lubrication is well AND Depth is laryngopharynx THEN Force is small\n");
}

TEST_F(RuleText, WhatIsCopiedReadsBackTheSame) {
  std::vector<std::size_t> all;
  for (std::size_t r = 0; r < expert().rules.size(); ++r) all.push_back(r);
  const auto rules = rulesFromText(model_, expert(), rulesAsText(model_, expert(), all));
  ASSERT_TRUE(rules.has_value()) << rules.error().message();
  ASSERT_EQ(rules->size(), 45U);
  for (std::size_t r = 0; r < 45; ++r) {
    EXPECT_TRUE((*rules)[r] == expert().rules[r]) << r;
  }
}

TEST_F(RuleText, APersonMayTypeIdsSpacesAndAnyCase) {
  const auto rules =
      rulesFromText(model_, expert(), "\n  if  SPEED is fast\tand neck_flexion is Large then LARGE \r\n");
  ASSERT_TRUE(rules.has_value()) << rules.error().message();
  EXPECT_EQ(rules->at(0), (Rule{{{"speed", "fast"}, {"neck_flexion", "large"}}, "large"}));
}

TEST_F(RuleText, ALabelMayHoldTheWordsOfTheLanguage) {
  model_.inputs[0].terms[0].label = "Dry";
  model_.inputs[0].terms[1].label = "Dry and rough";
  const auto rules =
      rulesFromText(model_, expert(), "IF Tube lubrication is Dry and rough AND Speed is fast THEN small");
  ASSERT_TRUE(rules.has_value()) << rules.error().message();
  EXPECT_EQ(rules->at(0).conditions[0].term, model_.inputs[0].terms[1].id);
  EXPECT_EQ(rules->at(0).conditions.size(), 2U);
}

TEST_F(RuleText, ALineThatIsNoRuleIsNamedWithWhatItDoesNotKnow) {
  const std::string good = "IF Speed is fast THEN small\n\n";
  EXPECT_EQ(refusedLine(good + "IF Speed is fats THEN small"), "line 3: found 'fats', wanted a term of Speed (fast?)");
  EXPECT_EQ(refusedLine(good + "IF Sped is fast THEN small"), "line 3: found 'Sped', wanted an input (Speed?)");
  EXPECT_EQ(refusedLine("Speed is fast"), "line 1: found 'Speed is fast', wanted IF or OFF IF");
  EXPECT_EQ(refusedLine("IF Speed is fast"), "line 1: found the end of the line, wanted AND or THEN");
  EXPECT_EQ(refusedLine("IF Speed is fast THEN small WITH much"), "line 1: found 'much', wanted a weight from 0 to 1");
  EXPECT_EQ(refusedLine("IF Speed is fast THEN small and large"),
            "line 1: found ' and large', wanted WITH a weight, or the end of the line");
  EXPECT_FALSE(refusedLine(" \n").empty());
  // A weight that no rule may have is refused with the whole block.
  refusal(putRules(model_, "S4", rulesFromText(model_, expert(), "IF Speed is fast THEN small WITH 2").value()));
}

TEST_F(RuleText, ABlockTakesThePlaceOfTheRulesWithItsConditions) {
  const auto block = rulesFromText(model_, expert(),
                                   "IF Depth is nasal_cavity AND Tube lubrication is well THEN large\n"
                                   "IF Speed is fast THEN small\n"
                                   "IF Speed is fast THEN small\n")
                         .value();
  const auto edit = must(putRules(model_, "S4", block));
  const auto& rules = edit.model.experts[0].rules;
  ASSERT_EQ(rules.size(), 46U);
  EXPECT_EQ(rules[0].then, "large");
  EXPECT_EQ(rules[1], expert().rules[1]);
  EXPECT_EQ(rules[45], (Rule{{{"speed", "fast"}}, "small"}));
  EXPECT_EQ(edit.label, "S4: 2 rules pasted, 1 of them new");
}

TEST_F(RuleText, RulesThatConflictStayTwo) {
  Rule other = expert().rules[0];
  other.then = "large";
  model_.experts[0].rules.push_back(other);
  const std::vector<std::size_t> both = {0, 45};
  const auto block = rulesFromText(model_, expert(), rulesAsText(model_, expert(), both)).value();
  EXPECT_EQ(must(putRules(model_, "S4", block)).model.experts[0].rules, expert().rules);
}

}  // namespace
}  // namespace tactus::editing
