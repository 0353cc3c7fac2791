#include <gtest/gtest.h>
#include <tuple>

#include "elicitation/rules/expert_rules.h"

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

TEST(RulesFromAnswers, EveryItemIsARuleOrMissingWithItsReasonAndLine) {
  auto long_form = form();
  for (int item = 4; item <= 6; ++item) long_form.items.push_back({item, "", {{"depth", "stomach"}}});
  const std::vector<study::Answer> answers{{"P1", "f1", 6, "", Status::kCleared, {5}},
                                           {"P1", "f1", 2, "large", Status::kAnswered, {2}},
                                           {"P1", "f1", 3, "", Status::kCantTell, {3}},
                                           {"P1", "f1", 5, "", Status::kSkipped, {4}}};
  const auto rules = rulesFromAnswers(answers, long_form, kTerms);
  ASSERT_TRUE(rules);
  ASSERT_EQ(rules->origins.size(), 1U);
  EXPECT_EQ(rules->origins[0].form, "f1");
  EXPECT_EQ(rules->origins[0].item, 2);
  EXPECT_EQ(rules->origins[0].line.number, 2U);
  using Reason = MissingItem::Reason;
  const std::vector<std::tuple<int, Reason, std::uint32_t>> wanted = {{1, Reason::kNoAnswer, 0},
                                                                      {3, Reason::kCantTell, 3},
                                                                      {4, Reason::kNoAnswer, 0},
                                                                      {5, Reason::kSkipped, 4},
                                                                      {6, Reason::kCleared, 5}};
  ASSERT_EQ(rules->missing.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const auto& item = rules->missing[i];
    EXPECT_EQ(std::tuple(item.origin.item, item.reason, item.origin.line.number), wanted[i]);
  }
  EXPECT_EQ(rules->missing[0].conditions, (std::vector<fuzzy::Condition>{{"speed", "slow"}, {"depth", "stomach"}}));
}

TEST(RulesFromAnswers, RefusesAnswersToAnotherFormAndTermsWithoutAnAnswer) {
  const auto message = [](study::Answer answer) {
    const auto rules = rulesFromAnswers(std::vector{std::move(answer)}, form(), kTerms);
    return rules ? std::string("no error") : rules.error().message();
  };
  EXPECT_EQ(message({"P1", "f2", 1, "small", Status::kAnswered, {8}}),
            "answers.csv: line 8, column 'form': found 'f2', wanted an answer to form 'f1'");
  EXPECT_EQ(message({"P1", "f1", 1, "small", Status::kCleared, {9}}),
            "answers.csv: line 9, column 'term': found 'small', wanted no term, as the item has no answer (cleared)");
  EXPECT_EQ(message({"P1", "f1", 1, "", Status::kAnswered, {9}}),
            "answers.csv: line 9, column 'term': found '', wanted one of small, large");
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
