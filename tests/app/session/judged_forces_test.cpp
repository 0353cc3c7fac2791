#include "app/session/judged_forces.h"

#include <gtest/gtest.h>

#include "core/store/entries.h"
#include "core/store/sessions.h"

#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::session {
namespace {

using Judged = study::ForceJudgement::Kind;

class JudgedForcesTest : public testing::Test {
 protected:
  study::JudgementRecord judged(const study::RecordId& session, int step, const std::string& term) {
    auto record = records_.judgement(session);
    record.step = step;
    record.attempt = 1;
    record.commanded_n = 0.1 * step;
    record.term = term;
    record.scored = true;
    record.catch_trial = false;
    EXPECT_TRUE(append(study_.file, record));
    return record;
  }

  study::JudgementRecord corrected(study::JudgementRecord record, const JudgedWord& word) {
    record.entry.supersedes = record.entry.id;
    record.entry.id = records_.id();
    record.kind = word.kind;
    record.term = word.term;
    EXPECT_TRUE(append(study_.file, record));
    return record;
  }

  std::vector<JudgedForce> read() const {
    const auto view = studyForElicitation(study_.file);
    EXPECT_TRUE(view);
    auto judged = judgedForces(study_.file, *view);
    EXPECT_TRUE(judged);
    return judged ? *std::move(judged) : std::vector<JudgedForce>();
  }

  support::TempFolder folder_;
  store::SampleRecords records_;
  store::OpenStudy study_ = store::makeStudy(folder_.file("a.tactus"), records_);
};

TEST_F(JudgedForcesTest, ACorrectionStandsInThePlaceOfTheJudgementWithTheWordsBeforeIt) {
  const auto first = judged(study_.session.id, 1, "large");
  const auto second = judged(study_.session.id, 2, "small");
  const auto made = corrected(first, {Judged::kTerm, "very_small"});
  corrected(made, {Judged::kNotFelt, ""});
  const auto all = read();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].record.step, 1);
  EXPECT_EQ(all[0].record.kind, Judged::kNotFelt);
  EXPECT_EQ(all[0].before, (std::vector<JudgedWord>{{Judged::kTerm, "large"}, {Judged::kTerm, "very_small"}}));
  EXPECT_TRUE(all[0].counts);
  EXPECT_EQ(all[0].participant, study_.person.code);
  EXPECT_EQ(all[1].record, second);
  EXPECT_TRUE(all[1].before.empty());
}

TEST_F(JudgedForcesTest, WhatElicitationLeavesOutIsThereButDoesNotCount) {
  judged(study_.session.id, 1, "small");
  auto blank = records_.judgement(study_.session.id);
  blank.series = "random";
  blank.commanded_n = 0;
  ASSERT_TRUE(append(study_.file, blank));
  const auto all = read();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_TRUE(all[0].counts);
  EXPECT_FALSE(all[1].counts);
}

TEST_F(JudgedForcesTest, ASessionWithoutACountedJudgementIsLeftOut) {
  judged(study_.session.id, 1, "small");
  judged(study_.session.id, 2, "small");
  const auto later = records_.session(study_.person.id);
  ASSERT_TRUE(append(study_.file, later));
  judged(later.id, 1, "large");  // fewer judgements than the first session, and no plan of either can be read
  const auto all = read();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].record.entry.session, study_.session.id);
}

}  // namespace
}  // namespace tactus::session
