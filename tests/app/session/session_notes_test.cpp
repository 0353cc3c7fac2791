#include "app/session/session_notes.h"

#include <gtest/gtest.h>

#include "app/session/session_settings.h"

namespace tactus::session {
namespace {

study::RecordId idOf(std::uint8_t number) {
  study::RecordId id;
  id.bytes.back() = number;
  return id;
}

study::EventRecord eventOf(const Note& note) { return {{}, note.kind, note.detail}; }

TEST(SessionNotes, SayWhatHappened) {
  EXPECT_EQ(languageChosen("zh-Hant"), (Note{"language_chosen", R"({"language":"zh-Hant"})"}));
  EXPECT_EQ(textSizeChosen(125).kind, "text_size_chosen");
  EXPECT_NE(textSizeChosen(125).detail.find("125"), std::string::npos);
  EXPECT_EQ(consentGiven("2026-2", "en", "I agree.").detail,
            R"({ "version": "2026-2", "language": "en", "text": "I agree." })");
  EXPECT_EQ(researcherNote("said \"ouch\"").detail, R"({"text":"said \"ouch\""})");
}

// The middles that facts and paper give: 2.5, 7.5, 12.5 and 20 years.
TEST(SessionNotes, BandsOfYearsHaveAMiddle) {
  const std::pair<const char*, double> bands[] = {
      {"years_1", 2.5}, {"years_2", 7.5}, {"years_3", 12.5}, {"years_4", 20}};
  for (const auto& [id, middle_years] : bands) {
    const auto band = experienceBandCalled(id);
    ASSERT_TRUE(band) << id;
    EXPECT_EQ(band->middle_years, middle_years);
    EXPECT_NE(experienceBandChosen(*band).detail.find(id), std::string::npos);
  }
  EXPECT_FALSE(experienceBandCalled("years_5"));
}

TEST(SessionNotes, TheInputOfAnAnswerComesBack) {
  const AnswerInput cycled{InputMeans::kDeviceButton, "medium", 3};
  const auto line = answerInputIn(eventOf(answerInput(idOf(9), cycled)));
  ASSERT_TRUE(line && *line);
  EXPECT_EQ((*line)->record, idOf(9));
  EXPECT_EQ((*line)->input, cycled);
  const AnswerInput touched{InputMeans::kTouch, "", 0};
  EXPECT_EQ((**answerInputIn(eventOf(answerInput(idOf(9), touched)))).input, touched);
  EXPECT_TRUE(validate(cycled));
  EXPECT_TRUE(validate(touched));
  EXPECT_FALSE(validate({InputMeans::kTouch, "medium", 0}));
  EXPECT_FALSE(validate({InputMeans::kDeviceButton, "medium", -1}));
}

TEST(SessionNotes, WhatWasSaidOfTheOwnModelComesBack) {
  const OwnModelPlace place{idOf(4), "oropharynx", 130, 0.41};
  const auto heavier = ownModelIn(eventOf(ownModelVerdict(place, OwnModelVerdict::kHeavier)));
  ASSERT_TRUE(heavier && *heavier);
  EXPECT_EQ((*heavier)->place, place);
  EXPECT_EQ((*heavier)->verdict, OwnModelVerdict::kHeavier);
  const OwnModelPlace bare{{}, "esophagus", {}, {}};
  const auto mark = ownModelIn(eventOf(ownModelMark(bare)));
  ASSERT_TRUE(mark && *mark);
  EXPECT_EQ((*mark)->place, bare);
  EXPECT_EQ((*mark)->verdict, std::nullopt);
}

TEST(SessionNotes, OtherLinesAreNoneAndBrokenOnesAreErrors) {
  EXPECT_EQ(ownModelIn({{}, "paused", ""})->has_value(), false);
  EXPECT_EQ(answerInputIn({{}, "paused", ""})->has_value(), false);
  for (const char* detail : {"", "{}", R"({"region":"esophagus"})", R"({"region":"esophagus","verdict":"odd"})"}) {
    EXPECT_FALSE(ownModelIn({{}, "own_model_verdict", detail})) << detail;
  }
  EXPECT_FALSE(answerInputIn({{}, "answer_input", R"({"record":"12","means":"touch"})"}));
}

TEST(SessionNotes, StepsOfTheSessionAreNoNotes) {
  for (const char* kind : {"began", "resumed", "stage_entered", "paused", "unpaused", "block_skipped", "aborted"}) {
    EXPECT_TRUE(steersSession(kind)) << kind;
  }
  EXPECT_FALSE(steersSession(kForceOff));
}

}  // namespace
}  // namespace tactus::session
