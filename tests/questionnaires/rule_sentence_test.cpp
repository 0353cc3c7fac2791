#include "questionnaires/rule_sentence.h"

#include <gtest/gtest.h>

namespace tactus::questionnaires {
namespace {

using Conditions = std::vector<study::ItemCondition>;

TEST(RuleSentence, ReadsConditionsAndConsequent) {
  const auto rule = parseRuleSentence(
      "IF Neck Flexion IS Large AND Tube Tip Position IS in Nasal Cavity, THEN Force IS Very Large", ngtAliases());
  ASSERT_TRUE(rule) << rule.error().message();
  EXPECT_EQ(rule->conditions, (Conditions{{"neck_flexion", "large"}, {"depth", "nasal_cavity"}}));
  EXPECT_EQ(rule->then, "very_large");
}

TEST(RuleSentence, BothSpellingsAndAnyCaseMeanTheSame) {
  for (const auto* text :
       {"IF Tube Tip Position IS in Oesophagus THEN Force Change IS:", "if depth is  esophagus ,then force is",
        "IF tube tip position IS Esophagus THEN FORCE IS :"}) {
    const auto rule = parseRuleSentence(text, ngtAliases());
    ASSERT_TRUE(rule) << rule.error().message();
    EXPECT_EQ(rule->conditions, (Conditions{{"depth", "esophagus"}}));
    EXPECT_TRUE(rule->then.empty());
  }
}

TEST(RuleSentence, ListsConditionsInTheOrderOfTheInputs) {
  const auto rule = parseRuleSentence(
      "IF Speed IS Fast AND Tube Tip Position IS in Stomach AND Tube Lubrication IS Well THEN Force IS Small",
      ngtAliases());
  ASSERT_TRUE(rule) << rule.error().message();
  EXPECT_EQ(rule->conditions, (Conditions{{"lubrication", "well"}, {"depth", "stomach"}, {"speed", "fast"}}));
}

std::string sentenceRefusal(std::string_view text) {
  const auto rule = parseRuleSentence(text, ngtAliases());
  return rule ? "" : rule.error().message();
}

TEST(RuleSentence, OtherSentencesAreRefused) {
  EXPECT_EQ(sentenceRefusal(""), "sentence '': found its end, wanted the word 'if'");
  EXPECT_EQ(sentenceRefusal("IF Speed IS Slow"), "sentence 'IF Speed IS Slow': found its end, wanted the word 'then'");
  EXPECT_EQ(
      sentenceRefusal("IF Mood IS Slow THEN Force IS"),
      "sentence 'IF Mood IS Slow THEN Force IS': found 'Mood', wanted an input: lubrication, neck_flexion, depth, "
      "speed");
  EXPECT_EQ(sentenceRefusal("IF Speed IS Slow AND Speed IS Fast THEN Force IS"),
            "sentence 'IF Speed IS Slow AND Speed IS Fast THEN Force IS': found two conditions on 'Speed', wanted one "
            "condition for each input");
  EXPECT_EQ(sentenceRefusal("IF Speed IS Slow THEN Speed IS"),
            "sentence 'IF Speed IS Slow THEN Speed IS': found 'Speed', wanted the output 'force'");
  EXPECT_EQ(sentenceRefusal("IF Speed IS Slow THEN Force IS Small IF"),
            "sentence 'IF Speed IS Slow THEN Force IS Small IF': found more after the rule, wanted its end");
}

TEST(Aliases, AWordMeansOneThing) {
  const auto table = parseAliases(R"({"format": "tactus-aliases", "inputs": [
      {"id": "a", "names": ["X"], "terms": {"low": ["Down"], "high": [" down "]}}],
      "output": {"id": "b", "names": [], "terms": {}}})",
                                  "words.json");
  ASSERT_FALSE(table);
  EXPECT_EQ(table.error().message(),
            "words.json: /inputs/0/terms/high: found ' down ' for two ids, wanted one id for each word");
}

}  // namespace
}  // namespace tactus::questionnaires
