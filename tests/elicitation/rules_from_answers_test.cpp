#include "elicitation/rules_from_answers.h"

#include <gtest/gtest.h>

namespace tactus::elicitation {
namespace {

using Status = study::Answer::Status;

const std::vector<std::string> kTerms{"small", "large"};

study::Form form() {
  study::Form form;
  form.id = "f1";
  form.items = {
      {1, "one", {{"speed", "slow"}, {"depth", "stomach"}}}, {2, "two", {{"speed", "fast"}}}, {3, "three", {}}};
  return form;
}

TEST(RulesFromAnswers, AnItemWithoutAnAnswerIsAnAbsentRule) {
  const std::vector<study::Answer> answers{{"P1", "f1", 2, "large", Status::kAnswered},
                                           {"P1", "f1", 3, "", Status::kCantTell},
                                           {"P1", "f1", 1, "small", Status::kAnswered}};
  const auto rules = rulesFromAnswers(answers, form(), kTerms);
  ASSERT_TRUE(rules);
  const fuzzy::Rule first{{{"speed", "slow"}, {"depth", "stomach"}}, "small", 1, true};
  const fuzzy::Rule second{{{"speed", "fast"}}, "large", 1, true};
  EXPECT_EQ(rules->rules, (std::vector<fuzzy::Rule>{first, second}));
}

TEST(RulesFromAnswers, RefusesUnknownItemsTermsAndSecondAnswers) {
  const auto message = [](std::vector<study::Answer> answers) {
    const auto rules = rulesFromAnswers(answers, form(), kTerms);
    return rules ? std::string("no error") : rules.error().message();
  };
  EXPECT_EQ(message({{"P1", "f1", 46, "small", Status::kAnswered}}),
            "answer of participant P1 to item 46 of form f1: found an item that the form does not have, wanted one of "
            "its 3 items");
  EXPECT_EQ(message({{"P1", "f1", 1, "huge", Status::kAnswered}}),
            "answer of participant P1 to item 1 of form f1: found term 'huge', wanted one of small, large");
  EXPECT_EQ(message({{"P1", "f1", 1, "small", Status::kAnswered}, {"P1", "f1", 1, "large", Status::kAnswered}}),
            "answer of participant P1 to item 1 of form f1: found a second answer, wanted one answer per item");
}

TEST(RulesFromAnswers, AGivenRuleKeepsItsWeight) {
  const fuzzy::Rule wanted{{{"depth", "stomach"}}, "small", 0.5, true};
  EXPECT_EQ(ruleFrom({"P1", "", {{"depth", "stomach"}}, "small", 0.5}), wanted);
}

}  // namespace
}  // namespace tactus::elicitation
