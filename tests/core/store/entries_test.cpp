#include "core/store/entries.h"

#include <gtest/gtest.h>
#include <limits>

#include "core/store/batch.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"

#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Entries : public testing::Test {
 protected:
  void reopen() {
    ASSERT_TRUE(study_.file.close());
    auto file = StudyFile::open(path_);
    ASSERT_TRUE(file) << file.error().message();
    study_.file = *std::move(file);
  }
  template <class Record>
  std::string refusal(const Record& record) {
    const auto written = append(study_.file, record);
    return written ? "" : written.error().message();
  }
  study::RecordId sessionId() const { return study_.session.id; }

  support::TempFolder folder_;
  SampleRecords records_;
  std::string path_ = folder_.file("study.tactus");
  OpenStudy study_ = makeStudy(path_, records_);
};

TEST_F(Entries, EveryKindComesBackAsItWasWritten) {
  const auto profile = records_.profile(sessionId());
  const auto event = records_.event(sessionId());
  const auto stroke = records_.stroke(sessionId());
  const auto judgement = records_.judgement(sessionId());
  const auto answer = records_.answer(sessionId());
  const auto rating = records_.rating(sessionId());
  const auto rule = records_.rule(sessionId());
  ASSERT_EQ(refusal(profile), "");
  ASSERT_EQ(refusal(event), "");
  ASSERT_EQ(refusal(stroke), "");
  ASSERT_EQ(refusal(judgement), "");
  ASSERT_EQ(refusal(answer), "");
  ASSERT_EQ(refusal(rating), "");
  ASSERT_EQ(refusal(rule), "");
  reopen();
  EXPECT_EQ(*profiles(study_.file), std::vector{profile});
  EXPECT_EQ(*events(study_.file), std::vector{event});
  EXPECT_EQ(*strokes(study_.file), std::vector{stroke});
  EXPECT_EQ(*judgements(study_.file), std::vector{judgement});
  EXPECT_EQ(*answers(study_.file), std::vector{answer});
  EXPECT_EQ(*ratings(study_.file), std::vector{rating});
  EXPECT_EQ(*rules(study_.file), std::vector{rule});
  EXPECT_EQ(*sessions(study_.file), std::vector{study_.session});
  EXPECT_EQ(*persons(study_.file), std::vector{study_.person});
  EXPECT_EQ(*recordingOf(study_.file, stroke.entry.id), stroke.recording);
  EXPECT_TRUE(checkStudy(study_.file)->empty());
}

TEST_F(Entries, WhatWasNotToldStaysUntold) {
  auto profile = records_.profile(sessionId());
  profile.years_experience.reset();
  profile.weight.reset();
  auto judgement = records_.judgement(sessionId());
  judgement.felt_n.reset();
  judgement.kind = study::ForceJudgement::Kind::kNotFelt;
  judgement.term.clear();
  auto answer = records_.answer(sessionId());
  answer.status = study::Answer::Status::kCantTell;
  answer.value.clear();
  ASSERT_EQ(refusal(profile), "");
  ASSERT_EQ(refusal(judgement), "");
  ASSERT_EQ(refusal(answer), "");
  EXPECT_EQ(*profiles(study_.file), std::vector{profile});
  EXPECT_EQ(*judgements(study_.file), std::vector{judgement});
  EXPECT_EQ(*answers(study_.file), std::vector{answer});
}

TEST_F(Entries, StandInTheOrderInWhichTheyWereAdded) {
  std::vector<study::AnswerRecord> written;
  for (int item = 1; item <= 40; ++item) {
    written.push_back(records_.answer(sessionId(), 41 - item));
    written.back().entry.when = {1'770'000'000'000 - item, 0};  // a clock that runs backwards does not matter
    ASSERT_EQ(refusal(written.back()), "");
  }
  reopen();
  EXPECT_EQ(*answers(study_.file), written);
}

TEST_F(Entries, AreSelectedByPersonAndSession) {
  const auto other = records_.person("calm-fox");
  const auto others = records_.session(other.id);
  const auto again = records_.session(study_.person.id);
  ASSERT_EQ(refusal(other), "");
  ASSERT_EQ(refusal(others), "");
  ASSERT_EQ(refusal(again), "");
  const auto first = records_.answer(sessionId());
  const auto second = records_.answer(others.id);
  const auto third = records_.answer(again.id);
  for (const auto& answer : {third, second, first}) ASSERT_EQ(refusal(answer), "");
  EXPECT_EQ(*answers(study_.file), (std::vector{first, second, third}));
  EXPECT_EQ(*answers(study_.file, {.person = study_.person.id}), (std::vector{first, third}));
  EXPECT_EQ(*answers(study_.file, {.session = others.id}), std::vector{second});
  EXPECT_TRUE(answers(study_.file, {.person = other.id, .session = again.id})->empty());
  EXPECT_EQ(*sessions(study_.file, other.id), std::vector{others});
  const auto list = *sessionList(study_.file);
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[1].code, "calm-fox");
  EXPECT_EQ(list[1].answers, 1);
  EXPECT_EQ(list[1].strokes, 0);
}

TEST_F(Entries, ACorrectionTakesThePlaceOfARecordWithoutChangingIt) {
  const auto wrong = records_.answer(sessionId());
  auto right = records_.answer(sessionId());
  right.value = "small";
  right.entry.supersedes = wrong.entry.id;
  auto righter = right;
  righter.entry = records_.entry(sessionId());
  righter.entry.supersedes = right.entry.id;
  ASSERT_EQ(refusal(wrong), "");
  ASSERT_EQ(refusal(right), "");
  EXPECT_EQ(*answers(study_.file), std::vector{right});
  ASSERT_EQ(refusal(righter), "");
  EXPECT_EQ(*answers(study_.file), std::vector{righter});
  EXPECT_EQ(*answers(study_.file, {.history = true}), (std::vector{wrong, right, righter}));

  auto second = records_.answer(sessionId());
  second.entry.supersedes = wrong.entry.id;
  EXPECT_NE(refusal(second).find("corrected before"), std::string::npos);
  second.entry.supersedes = records_.id();
  EXPECT_NE(refusal(second), "");
}

TEST_F(Entries, ACorrectionIsOfTheSamePerson) {
  const auto other = records_.person("calm-fox");
  const auto session = records_.session(other.id);
  ASSERT_EQ(refusal(other), "");
  ASSERT_EQ(refusal(session), "");
  const auto answer = records_.answer(sessionId());
  ASSERT_EQ(refusal(answer), "");
  auto correction = records_.answer(session.id);
  correction.entry.supersedes = answer.entry.id;
  EXPECT_NE(refusal(correction).find("of the same person"), std::string::npos);
}

TEST_F(Entries, WhatIsNoNumberIsRefused) {
  auto judgement = records_.judgement(sessionId());
  judgement.commanded_n = kNan;
  EXPECT_NE(refusal(judgement).find("found nan, wanted a finite number"), std::string::npos);
  judgement = records_.judgement(sessionId());
  judgement.felt_n = kNan;  // would be stored as "not estimated"
  EXPECT_NE(refusal(judgement), "");
  judgement.felt_n = -kInfinity;
  EXPECT_NE(refusal(judgement), "");
  auto stroke = records_.stroke(sessionId());
  stroke.recording.channels[1].values[3] = kNan;
  EXPECT_NE(refusal(stroke).find("'force'"), std::string::npos);
  auto answer = records_.answer(sessionId());
  answer.value = "\xC3\x28";
  EXPECT_NE(refusal(answer).find("UTF-8"), std::string::npos);
  EXPECT_TRUE(judgements(study_.file)->empty());
  EXPECT_TRUE(strokes(study_.file)->empty());
  EXPECT_TRUE(checkStudy(study_.file)->empty());
}

TEST_F(Entries, WhatBreaksARuleIsRefused) {
  auto answer = records_.answer(sessionId());
  answer.value.clear();  // answered without an answer
  EXPECT_NE(refusal(answer).find("breaks a rule of the study file"), std::string::npos);
  answer = records_.answer(records_.id());  // of no session
  EXPECT_NE(refusal(answer), "");
  answer = records_.answer(sessionId());
  ASSERT_EQ(refusal(answer), "");
  EXPECT_NE(refusal(answer).find("there already"), std::string::npos);
  answer.entry.id = {};
  EXPECT_NE(refusal(answer).find("an id of zeros"), std::string::npos);
  auto rating = records_.rating(sessionId());
  rating.effort = 8;
  EXPECT_NE(refusal(rating), "");
  auto stroke = records_.stroke(sessionId());
  stroke.last = 21;  // of 20 samples
  EXPECT_NE(refusal(stroke).find("an end at sample 21"), std::string::npos);
  EXPECT_EQ(answers(study_.file)->size(), 1U);
}

TEST_F(Entries, HaveNoNamesThatASpreadsheetWouldRun) {
  auto answer = records_.answer(sessionId());
  answer.value = "=small";
  EXPECT_NE(refusal(answer).find("found '=small', wanted a name that does not begin with = + - @"), std::string::npos);
  answer.value = "-2";  // on a scale
  EXPECT_EQ(refusal(answer), "");
  auto stroke = records_.stroke(sessionId());
  stroke.level = "+slow";
  EXPECT_NE(refusal(stroke), "");
  auto judgement = records_.judgement(sessionId());
  judgement.term = "@small";
  EXPECT_NE(refusal(judgement), "");
  judgement = records_.judgement(sessionId());
  judgement.series = "\tup";
  EXPECT_NE(refusal(judgement), "");
  auto rule = records_.rule(sessionId());
  rule.rule.then = "-large";
  EXPECT_NE(refusal(rule), "");
  rule = records_.rule(sessionId());
  rule.rule.conditions.front().term = "=deep";
  EXPECT_NE(refusal(rule), "");
}

TEST_F(Entries, ABatchIsWrittenWholeOrNotAtAll) {
  {
    auto batch = Batch::begin(study_.file);
    ASSERT_TRUE(batch);
    EXPECT_FALSE(Batch::begin(study_.file));
    ASSERT_EQ(refusal(records_.answer(sessionId(), 1)), "");
  }
  EXPECT_TRUE(answers(study_.file)->empty());
  {
    auto batch = Batch::begin(study_.file);
    ASSERT_TRUE(batch);
    ASSERT_EQ(refusal(records_.answer(sessionId(), 1)), "");
    ASSERT_NE(refusal(records_.answer(records_.id(), 2)), "");
    EXPECT_NE(refusal(records_.answer(sessionId(), 3)).find("a batch in which a write failed"), std::string::npos);
    EXPECT_FALSE(batch->commit());
  }
  EXPECT_TRUE(answers(study_.file)->empty());
  {
    auto batch = Batch::begin(study_.file);
    ASSERT_TRUE(batch);
    for (int item = 1; item <= 5; ++item) ASSERT_EQ(refusal(records_.answer(sessionId(), item)), "");
    ASSERT_TRUE(batch->commit());
  }
  reopen();
  EXPECT_EQ(answers(study_.file)->size(), 5U);
}

TEST_F(Entries, StrokesAreListedWithoutTheirSamples) {
  const auto stroke = records_.stroke(sessionId(), 1500);
  ASSERT_EQ(refusal(stroke), "");
  auto expected = stroke;
  expected.recording = {};
  EXPECT_EQ(*strokes(study_.file, {}, Recordings::kLeaveOut), std::vector{expected});
  const auto none = recordingOf(study_.file, records_.id());
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message().find("found no stroke"), std::string::npos);
}

}  // namespace
}  // namespace tactus::store
