#include "app/editing/rule_edits.h"

#include <array>
#include <gtest/gtest.h>
#include <limits>

#include "tests/app/editing/sample_models.h"

namespace tactus::editing {
namespace {

using fuzzy::Rule;

class RuleEdits : public testing::Test {
 protected:
  const fuzzy::ForceModel model_ = support::s4AsPrinted();
  const std::string s4_ = "S4";
};

TEST_F(RuleEdits, ARuleMayHaveFourConditions) {
  const Rule rule{{{"speed", "fast"}, {"depth", "stomach"}, {"neck_flexion", "large"}, {"lubrication", "poor"}},
                  "very_large"};
  const auto edit = must(addRule(model_, s4_, rule));
  const auto& added = edit.model.experts[0].rules.back();
  EXPECT_EQ(added.conditions,
            (std::vector<fuzzy::Condition>{
                {"lubrication", "poor"}, {"neck_flexion", "large"}, {"depth", "stomach"}, {"speed", "fast"}}));
  EXPECT_EQ(edit.label,
            "S4: IF Tube lubrication is poor AND Neck flexion is large AND Depth is stomach AND Speed is fast THEN "
            "very_large, added");
}

TEST_F(RuleEdits, RulesThatMakeNoSenseAreRefused) {
  refusal(addRule(model_, s4_, {{}, "small"}));
  refusal(addRule(model_, s4_, {{{"depth", "elbow"}}, "small"}));
  refusal(addRule(model_, s4_, {{{"heat", "hot"}}, "small"}));
  refusal(addRule(model_, s4_, {{{"depth", "stomach"}, {"depth", "esophagus"}}, "small"}));
  refusal(addRule(model_, s4_, {{{"depth", "stomach"}}, "huge"}));
  refusal(addRule(model_, s4_, model_.experts[0].rules[7]));
  refusal(addRule(model_, "S9", {{{"depth", "stomach"}}, "small"}));
  refusal(setConsequent(model_, s4_, 45, "small"));
  refusal(setConsequent(model_, s4_, 0, "huge"));
  refusal(setRuleWeight(model_, s4_, 0, 1.5));
  refusal(setRuleWeight(model_, s4_, 0, std::numeric_limits<double>::quiet_NaN()));
  refusal(setExpertWeight(model_, s4_, 0));
  refusal(removeRules(model_, s4_, {}));
}

TEST_F(RuleEdits, OneRuleIsChanged) {
  const auto word = must(setConsequent(model_, s4_, 0, "small"));
  EXPECT_EQ(word.label, "S4: IF Tube lubrication is well AND Depth is nasal_cavity: very_small to small");
  EXPECT_EQ(word.model.experts[0].rules[0].then, "small");
  EXPECT_EQ(must(setRuleWeight(model_, s4_, 3, 0.25)).model.experts[0].rules[3].weight, 0.25);
  EXPECT_EQ(must(setExpertWeight(model_, s4_, 3)).model.experts[0].weight, 3);
  const auto other = must(replaceRule(model_, s4_, 2, {{{"speed", "slow"}}, "small"}));
  EXPECT_EQ(other.model.experts[0].rules[2].conditions.size(), 1);
  EXPECT_EQ(other.model.experts[0].rules.size(), 45);
}

TEST_F(RuleEdits, SeveralRulesAreOneEdit) {
  const auto words = must(setConsequent(model_, s4_, std::array<std::size_t, 3>{0, 1, 4}, "large"));
  EXPECT_EQ(words.label, "S4: 3 rules THEN large");
  for (const std::size_t rule : {0, 1, 4}) EXPECT_EQ(words.model.experts[0].rules[rule].then, "large");
  EXPECT_EQ(words.model.experts[0].rules[2], model_.experts[0].rules[2]);
  const auto weights = must(setRuleWeight(model_, s4_, std::array<std::size_t, 2>{0, 1}, 0.5));
  EXPECT_EQ(weights.label, "S4: 2 rules, weight 0.5");
  EXPECT_EQ(weights.model.experts[0].rules[1].weight, 0.5);
  refusal(setConsequent(model_, s4_, std::array<std::size_t, 2>{0, 45}, "large"));
  refusal(setConsequent(model_, s4_, std::span<const std::size_t>(), "large"));
  // Two rules with the same conditions would become one and the same.
  fuzzy::ForceModel two = model_;
  two.experts[0].rules.push_back(model_.experts[0].rules[0]);
  two.experts[0].rules.back().then = "medium";
  refusal(setConsequent(two, s4_, std::array<std::size_t, 2>{0, 45}, "large"));
}

TEST_F(RuleEdits, TheRefusalOfADoubledRuleNamesTheOther) {
  const Rule third = model_.experts[0].rules[2];
  const std::string sentence = "S4: found the same as rule 3, wanted a new rule";
  EXPECT_EQ(addRule(model_, s4_, third).error().message(), sentence);
  EXPECT_EQ(replaceRule(model_, s4_, 7, third).error().message(), sentence);
  EXPECT_TRUE(replaceRule(model_, s4_, 2, third).has_value());
  Rule other = third;
  other.then = "large";
  const auto both = must(addRule(model_, s4_, other)).model;
  EXPECT_EQ(setConsequent(both, s4_, 45, third.then).error().message(), sentence);
  EXPECT_EQ(addRule(model_, s4_, {{}, "small"}).error().message(),
            "S4: found a rule without a condition, wanted one condition or more");
}

TEST_F(RuleEdits, ConflictsAreRulesThatCountAndContradict) {
  auto model = model_;
  auto& rules = model.experts[0].rules;
  EXPECT_TRUE(conflictingRules(model.experts[0]).empty());
  rules.push_back({{rules[2].conditions[1], rules[2].conditions[0]}, "very_large"});
  EXPECT_EQ(conflictingRules(model.experts[0]), (std::vector<std::size_t>{2, 45}));
  rules[2].weight = 0;
  EXPECT_TRUE(conflictingRules(model.experts[0]).empty());
  rules[2].weight = 1;
  rules[45].enabled = false;
  EXPECT_TRUE(conflictingRules(model.experts[0]).empty());
}

TEST_F(RuleEdits, SeveralRulesGoAtOnce) {
  const std::array<std::size_t, 3> indices = {44, 0, 2};
  const auto off = must(enableRules(model_, s4_, indices, false));
  EXPECT_EQ(off.label, "S4: 3 rules, disabled");
  EXPECT_FALSE(off.model.experts[0].rules[44].enabled);
  EXPECT_EQ(must(enableRules(off.model, s4_, indices, true)).model, model_);
  const auto removed = must(removeRules(model_, s4_, indices));
  ASSERT_EQ(removed.model.experts[0].rules.size(), 42);
  EXPECT_EQ(removed.model.experts[0].rules[0], model_.experts[0].rules[1]);
  EXPECT_EQ(removed.model.experts[0].rules[1], model_.experts[0].rules[3]);
}

}  // namespace
}  // namespace tactus::editing
