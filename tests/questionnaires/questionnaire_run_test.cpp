#include "questionnaires/questionnaire_run.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <span>

#include "core/base/random.h"

#include "tests/support/default_procedure.h"

namespace tactus::questionnaires {
namespace {

using Status = study::Answer::Status;

Questionnaire smallForm() {
  Questionnaire form{"f", 1, "plain", "en", "t", {}, {}, {{"a", "A"}, {"b", "B"}}, {}};
  for (int number = 1; number <= 4; ++number) form.questions.push_back({number, "q" + std::to_string(number)});
  return form;
}

/// A run, and the store that it relies on: records get an id and are kept in order.
class Desk {
 public:
  explicit Desk(ItemOrder order = ItemOrder::kFixed, std::uint64_t seed = 1)
      : run(smallForm(), order, seed), order_(order), seed_(seed) {}

  testing::AssertionResult reply(Status status, std::string value = {}) {
    auto record = run.draft({status, std::move(value)});
    if (!record) return testing::AssertionFailure() << record.error().message();
    record->entry.id = ids_.next();
    stored.push_back(*record);
    const auto added = run.add(*record);
    return added ? testing::AssertionSuccess() : testing::AssertionFailure() << added.error().message();
  }
  testing::AssertionResult say(std::string value) { return reply(Status::kAnswered, std::move(value)); }
  int shown() const { return run.page() ? run.page()->question->number : 0; }

  /// A run built from what was stored.
  QuestionnaireRun restored() const {
    QuestionnaireRun again(smallForm(), order_, seed_);
    for (const auto& record : stored) EXPECT_TRUE(again.add(record).has_value());
    return again;
  }

  QuestionnaireRun run;
  std::vector<study::AnswerRecord> stored;

 private:
  ItemOrder order_;
  std::uint64_t seed_;
  study::RecordIds ids_{1};
};

TEST(QuestionnaireRun, GoesThroughTheFormOnce) {
  Desk desk;
  EXPECT_EQ(desk.run.progress(), (Progress{0, 0, 0, 0, 4}));
  for (int number = 1; number <= 4; ++number) {
    ASSERT_TRUE(desk.run.page());
    EXPECT_EQ(desk.run.page()->position, static_cast<std::size_t>(number));
    EXPECT_EQ(desk.run.page()->count, 4U);
    EXPECT_EQ(desk.shown(), number);
    EXPECT_FALSE(desk.run.isComplete());
    EXPECT_TRUE(desk.say("a"));
  }
  EXPECT_TRUE(desk.run.isAtEnd());
  EXPECT_FALSE(desk.run.page());
  EXPECT_TRUE(desk.run.isComplete());
}

TEST(QuestionnaireRun, TheFourWaysToReplyAreDistinct) {
  Desk desk;
  EXPECT_TRUE(desk.say("b"));
  EXPECT_TRUE(desk.reply(Status::kSkipped));
  EXPECT_TRUE(desk.reply(Status::kCantTell));
  EXPECT_TRUE(desk.say("a"));
  desk.run.back();
  EXPECT_TRUE(desk.reply(Status::kCleared));
  EXPECT_EQ(desk.run.progress(), (Progress{1, 1, 1, 1, 0}));
  EXPECT_FALSE(desk.run.isComplete());
  EXPECT_EQ(desk.shown(), 4);  // a cleared answer stays on its page
}

TEST(QuestionnaireRun, NothingOpensBeforeTheAnswerIsStored) {
  Desk desk;
  const auto record = desk.run.draft({Status::kAnswered, "a"});
  ASSERT_TRUE(record.has_value());
  EXPECT_EQ(desk.shown(), 1);
  EXPECT_EQ(desk.run.progress().open, 4U);
}

TEST(QuestionnaireRun, ACorrectionIsAFurtherRecordAndLeadsBack) {
  Desk desk;
  EXPECT_TRUE(desk.say("a"));
  EXPECT_TRUE(desk.say("a"));
  EXPECT_EQ(desk.shown(), 3);
  desk.run.back();
  desk.run.back();
  EXPECT_EQ(desk.shown(), 1);
  ASSERT_NE(desk.run.page()->last_answer, nullptr);
  EXPECT_EQ(desk.run.page()->last_answer->value, "a");
  EXPECT_TRUE(desk.say("b"));
  EXPECT_EQ(desk.shown(), 3);

  const auto history = desk.run.history(1);
  ASSERT_EQ(history.size(), 2U);
  EXPECT_EQ(history[0].value, "a");
  EXPECT_EQ(history[1].value, "b");
  EXPECT_EQ(history[1].entry.supersedes, history[0].entry.id);
  EXPECT_EQ(desk.run.progress().answered, 2U);
  EXPECT_TRUE(desk.run.history(9).empty());
}

TEST(QuestionnaireRun, ForwardPassesOnlyWhatWasAnswered) {
  Desk desk;
  EXPECT_FALSE(desk.run.forward());
  EXPECT_TRUE(desk.say("a"));
  desk.run.back();
  desk.run.back();  // stays at the first
  EXPECT_EQ(desk.shown(), 1);
  EXPECT_TRUE(desk.run.forward());
  EXPECT_EQ(desk.shown(), 2);
  EXPECT_FALSE(desk.run.forward());
}

TEST(QuestionnaireRun, GoesToAnItemThatWasShownAndOnFromThere) {
  Desk desk;
  for (const char* value : {"a", "b"}) ASSERT_TRUE(desk.say(value));
  EXPECT_FALSE(desk.run.goTo(4)) << "item 3 is asked first";
  EXPECT_FALSE(desk.run.goTo(9)) << "no such item";
  EXPECT_EQ(desk.shown(), 3);
  ASSERT_TRUE(desk.run.goTo(1));
  EXPECT_EQ(desk.shown(), 1);
  desk.run.goOn();
  EXPECT_EQ(desk.shown(), 3);
  ASSERT_TRUE(desk.run.goTo(1));
  ASSERT_TRUE(desk.say("b"));
  EXPECT_EQ(desk.shown(), 3) << "a correction leads back";
}

TEST(QuestionnaireRun, WhatWasClearedIsFoundAgain) {
  Desk desk;
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(desk.say("a"));
  EXPECT_FALSE(desk.run.goToFirstOpen());
  for (int i = 0; i < 3; ++i) desk.run.back();
  EXPECT_EQ(desk.shown(), 2);
  EXPECT_TRUE(desk.reply(Status::kCleared));
  EXPECT_TRUE(desk.run.goToFirstOpen());
  EXPECT_EQ(desk.shown(), 2);
  EXPECT_TRUE(desk.say("b"));
  EXPECT_TRUE(desk.run.isAtEnd());
  EXPECT_TRUE(desk.run.isComplete());
}

TEST(QuestionnaireRun, NonsenseIsRefused) {
  Desk desk;
  EXPECT_FALSE(desk.run.draft({Status::kAnswered, "c"}).has_value());
  EXPECT_FALSE(desk.run.draft({Status::kAnswered, ""}).has_value());
  EXPECT_FALSE(desk.run.draft({Status::kSkipped, "a"}).has_value());
  EXPECT_FALSE(desk.run.draft({Status::kCleared, ""}).has_value());
  const auto record = desk.run.draft({Status::kAnswered, "a"});
  ASSERT_TRUE(record.has_value());
  auto wrong = *record;
  wrong.form = "g";
  EXPECT_FALSE(desk.run.add(wrong).has_value());
  wrong = *record;
  wrong.form_version = 2;
  EXPECT_FALSE(desk.run.add(wrong).has_value());
  wrong = *record;
  wrong.item = 5;
  EXPECT_FALSE(desk.run.add(wrong).has_value());
  wrong = *record;
  wrong.value = "z";
  EXPECT_FALSE(desk.run.add(wrong).has_value());
  EXPECT_TRUE(desk.run.add(*record).has_value());
  const auto twice = desk.run.add(*record);
  ASSERT_FALSE(twice.has_value());
  EXPECT_NE(twice.error().message().find("item 1"), std::string::npos);
  EXPECT_EQ(desk.run.progress().answered, 1U);  // a refusal changes nothing
}

TEST(QuestionnaireRun, AShuffledOrderShowsEachItemOnceAndKeepsTheFormsNumbers) {
  std::map<int, int> first;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Desk desk(ItemOrder::kShuffled, seed);
    std::set<int> seen;
    while (desk.run.page()) {
      if (seen.empty()) ++first[desk.shown()];
      EXPECT_TRUE(seen.insert(desk.shown()).second);
      EXPECT_EQ(desk.run.page()->position, seen.size());
      ASSERT_TRUE(desk.say("a"));
    }
    EXPECT_EQ(seen.size(), 4U);
  }
  // Each of the four is first in about 100 of 400 orders; 60 is more than four standard deviations (8.7) away.
  for (int number = 1; number <= 4; ++number) EXPECT_NEAR(first[number], 100, 40);
}

TEST(QuestionnaireRun, WithinBlocksEachFiveStayTogether) {
  const auto form = questionnaire(support::defaultProcedure(), "ngt-force-v1", "en");
  ASSERT_TRUE(form);
  std::set<std::vector<std::size_t>> orders;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto order = itemOrder(form->questions, ItemOrder::kWithinBlocks, seed);
    ASSERT_EQ(order.size(), 45U);
    for (std::size_t first = 0; first < 45; first += 5) {
      const std::set<std::size_t> block(order.begin() + static_cast<std::ptrdiff_t>(first),
                                        order.begin() + static_cast<std::ptrdiff_t>(first) + 5);
      EXPECT_EQ(block.size(), 5U);
      EXPECT_EQ(*block.begin(), first);
      EXPECT_EQ(*block.rbegin(), first + 4);
    }
    orders.insert(order);
  }
  EXPECT_GT(orders.size(), 49U);
}

// Whatever a person does, a run built from the stored records stands where the next question is asked.
TEST(QuestionnaireRun, GoesOnFromStoredRecords) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    base::Random random(seed);
    Desk desk(ItemOrder::kShuffled, seed);
    for (int step = 0; step < 25; ++step) {
      switch (random.below(6)) {
        case 0: desk.run.back(); continue;
        case 1: desk.run.forward(); continue;
        case 2:
          if (desk.run.draft({Status::kCleared, {}})) {
            EXPECT_TRUE(desk.reply(Status::kCleared));
          }
          break;
        case 3:
          if (desk.run.page()) {
            EXPECT_TRUE(desk.reply(random.below(2) == 0 ? Status::kSkipped : Status::kCantTell));
          }
          break;
        default:
          if (desk.run.page()) {
            EXPECT_TRUE(desk.say(random.below(2) == 0 ? "a" : "b"));
          }
      }
      if (desk.stored.empty()) continue;
      const auto again = desk.restored();
      EXPECT_EQ(again.progress(), desk.run.progress());
      for (int number = 1; number <= 4; ++number) EXPECT_EQ(again.history(number), desk.run.history(number));
    }
  }
}

/// The last open question, and the first one after an answer `b`.
QuestionnaireRun::Chosen byTheAnswers(const std::vector<std::string>& values, std::span<const std::size_t> open) {
  const bool said_b = std::find(values.begin(), values.end(), "b") != values.end();
  return {said_b ? open.front() : open.back(), {0.25, static_cast<double>(open.size())}};
}

TEST(QuestionnaireRun, TheNextQuestionFollowsFromTheAnswers) {
  Desk desk(ItemOrder::kLeastKnown);
  desk.run.chooseBy(byTheAnswers);
  EXPECT_EQ(desk.shown(), 4);
  EXPECT_EQ(desk.run.page()->reason, (Reason{0.25, 4}));
  ASSERT_TRUE(desk.say("b"));
  EXPECT_EQ(desk.shown(), 1);
  EXPECT_EQ(desk.run.page()->position, 2U);
  // A correction does not move what was asked; the rest follows from the new answer.
  desk.run.back();
  EXPECT_EQ(desk.shown(), 4);
  ASSERT_TRUE(desk.say("a"));
  EXPECT_EQ(desk.shown(), 1);
  ASSERT_TRUE(desk.say("a"));
  EXPECT_EQ(desk.shown(), 3);
  // The stored records say in which order the questions were asked, whatever would be chosen now.
  auto again = desk.restored();
  again.chooseBy([](const std::vector<std::string>& /*values*/, std::span<const std::size_t> open) {
    return QuestionnaireRun::Chosen{open.front(), {}};
  });
  EXPECT_EQ(again.page()->question->number, 2);
  EXPECT_EQ(again.page()->position, 3U);
  EXPECT_TRUE(again.goTo(4));
  EXPECT_EQ(again.page()->position, 1U);
  ASSERT_TRUE(desk.say("a"));
  ASSERT_TRUE(desk.say("a"));
  EXPECT_TRUE(desk.run.isComplete());
  EXPECT_TRUE(desk.run.isAtEnd());
}

TEST(QuestionnaireRun, InBlocksTheNextQuestionIsOfTheSameBlock) {
  auto form = questionnaire(support::defaultProcedure(), "ngt-force-v1", "en");
  ASSERT_TRUE(form);
  QuestionnaireRun run(*form, ItemOrder::kLeastKnownInBlocks, 1);
  run.chooseBy(byTheAnswers);
  study::RecordIds ids(1);
  int block = 1;
  while (const auto page = run.page()) {
    EXPECT_EQ(page->question->block, static_cast<int>((page->position - 1) / 5) + 1);
    EXPECT_GE(page->question->block, block);
    block = page->question->block;
    auto record = run.draft({Status::kAnswered, form->choices.front().value});
    ASSERT_TRUE(record);
    record->entry.id = ids.next();
    ASSERT_TRUE(run.add(*record));
  }
  EXPECT_TRUE(run.isComplete());
}

TEST(QuestionnaireRun, StandsAtTheSamePageAfterARestart) {
  Desk desk(ItemOrder::kShuffled, 5);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(desk.say("a"));
  const int next = desk.shown();
  desk.run.back();
  desk.run.back();
  EXPECT_TRUE(desk.say("b"));
  EXPECT_EQ(desk.shown(), next);
  const auto again = desk.restored();
  ASSERT_TRUE(again.page());
  EXPECT_EQ(again.page()->question->number, next);
}

}  // namespace
}  // namespace tactus::questionnaires
