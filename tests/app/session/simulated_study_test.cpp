#include "app/session/simulated_study.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>

#include "app/session/study_protocol.h"
#include "app/session/study_view.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"
#include "core/study/csv_tables.h"
#include "experiments/published_tables.h"
#include "experiments/stroke_speeds.h"

#include "tests/support/temp_folder.h"

namespace tactus::session {
namespace {

/// The study of one seed, made once for all tests.
class SimulatedStudy : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new support::TempFolder;
    auto made = makeSimulatedNgtStudy(folder_->file("study.tactus"), 3, "ngt-a2-shifted", "test");
    ASSERT_TRUE(made) << made.error().message();
    file_ = new store::StudyFile(*std::move(made));
    auto view = studyForElicitation(*file_);
    ASSERT_TRUE(view) << view.error().message();
    view_ = new StudyView(*std::move(view));
  }
  static void TearDownTestSuite() {
    delete view_;
    delete file_;
    delete folder_;
  }

  static support::TempFolder* folder_;
  static store::StudyFile* file_;
  static StudyView* view_;
};

support::TempFolder* SimulatedStudy::folder_ = nullptr;
store::StudyFile* SimulatedStudy::file_ = nullptr;
StudyView* SimulatedStudy::view_ = nullptr;

TEST_F(SimulatedStudy, SaysThatItIsSimulated) {
  EXPECT_NE(view_->study.name.find("simulated"), std::string::npos);
  ASSERT_EQ(view_->study.participants.size(), 4U);
  for (const auto& participant : view_->study.participants) {
    EXPECT_TRUE(participant.simulated);
    EXPECT_FALSE(participant.years_experience.has_value());  // the paper says "more than 10" only
  }
  EXPECT_EQ(store::studyInfo(*file_)->simulated_persons, 4);
  const auto strokes = store::strokes(*file_, {}, store::Recordings::kLeaveOut).value();
  for (const auto& stroke : strokes) {
    EXPECT_EQ(stroke.entry.entered_by, study::EnteredBy::kProgram);
  }
}

TEST_F(SimulatedStudy, IsWholeAndItsSessionsAreFinished) {
  EXPECT_EQ(store::checkStudy(*file_).value(), std::vector<std::string>{});
  EXPECT_EQ(view_->notes, std::vector<std::string>{});
  const auto sessions = store::sessions(*file_);
  ASSERT_EQ(sessions->size(), 4U);
  for (const auto& session : *sessions) {
    const auto events = store::events(*file_, {{}, session.id, false});
    EXPECT_EQ(events->back().detail, R"({"stage":"finished"})");
    EXPECT_EQ(session.consent_version, "simulated");
  }
}

TEST_F(SimulatedStudy, HasTheSpeedsOfTable1) {
  const auto table = experiments::publishedSpeeds();
  const auto summaries = experiments::summarizeSpeeds(view_->study.speeds);
  ASSERT_EQ(summaries.size(), table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    EXPECT_EQ(summaries[i].participant, table[i].participant);
    EXPECT_EQ(summaries[i].level, table[i].level);
    EXPECT_EQ(summaries[i].strokes, 4U);
    EXPECT_NEAR(summaries[i].mean_mm_s, table[i].mean_mm_s, 0.05);  // half of the table's last digit
    EXPECT_NEAR(summaries[i].sd_mm_s, table[i].sd_mm_s, 0.05);
  }
}

TEST_F(SimulatedStudy, HasTheVotesOfTable2) {
  const auto terms = experiments::publishedVoteTerms();
  std::map<std::pair<int, std::string>, int> votes;
  for (const auto& judgement : view_->study.judgements) {
    EXPECT_EQ(judgement.series, "ascending");
    EXPECT_NEAR(judgement.force_n, 0.1 * judgement.step, 1e-12);
    if (judgement.kind == study::ForceJudgement::Kind::kTerm) ++votes[{judgement.step, judgement.term}];
    // "the upper bound of insertion force experienced" is 1.1 N; the series ends at the first force beyond it.
    EXPECT_EQ(judgement.kind == study::ForceJudgement::Kind::kBeyondPractice, judgement.step == 12);
    EXPECT_LE(judgement.step, 12);
  }
  const auto table = experiments::publishedVotes();
  for (std::size_t row = 0; row < table.size(); ++row) {
    for (std::size_t term = 0; term < terms.size(); ++term) {
      EXPECT_EQ((votes[{static_cast<int>(row) + 1, terms[term]}]), table[row].votes[term]) << row << ' ' << terms[term];
    }
  }
}

TEST_F(SimulatedStudy, S4GivesRulesAndTheOthersAnswers) {
  std::map<std::string, std::set<int>> answered;
  for (const auto& answer : view_->study.answers) {
    EXPECT_EQ(answer.status, study::Answer::Status::kAnswered);
    answered[answer.participant].insert(answer.item);
  }
  ASSERT_EQ(answered.size(), 3U);
  for (const char* code : {"S1", "S2", "S3"}) EXPECT_EQ(answered[code].size(), 45U);
  EXPECT_EQ(view_->study.answers.size(), 135U);
  EXPECT_EQ(view_->study.rules.size(), 45U);
  for (const auto& rule : view_->study.rules) {
    EXPECT_EQ(rule.participant, "S4");
    EXPECT_EQ(rule.form, "ngt-a2-shifted");
  }
}

TEST_F(SimulatedStudy, HoldsWhatGoesWrongInARealOne) {
  std::set<std::string> verdicts;
  const auto strokes = store::strokes(*file_, {}, store::Recordings::kLeaveOut).value();
  for (const auto& stroke : strokes) {
    verdicts.insert(stroke.verdict);
  }
  EXPECT_EQ(verdicts, (std::set<std::string>{"accepted", "too_short"}));
  const auto judgements = store::judgements(*file_);
  EXPECT_TRUE(std::any_of(judgements->begin(), judgements->end(), [](const study::JudgementRecord& record) {
    return record.series == "ascending" && !record.scored;
  }));
  EXPECT_GT(store::answers(*file_, {{}, {}, true})->size(), 135U);  // corrected ones
}

TEST_F(SimulatedStudy, FollowsFromItsArguments) {
  const auto again = makeSimulatedNgtStudy(folder_->file("again.tactus"), 3, "ngt-a2-shifted", "test");
  ASSERT_TRUE(again) << again.error().message();
  const store::Selection all{{}, {}, true};
  EXPECT_EQ(store::persons(*again).value(), store::persons(*file_).value());
  EXPECT_EQ(store::sessions(*again).value(), store::sessions(*file_).value());
  EXPECT_EQ(store::events(*again, all).value(), store::events(*file_, all).value());
  EXPECT_EQ(store::strokes(*again, all).value(), store::strokes(*file_, all).value());
  EXPECT_EQ(store::judgements(*again, all).value(), store::judgements(*file_, all).value());
  EXPECT_EQ(store::answers(*again, all).value(), store::answers(*file_, all).value());
  EXPECT_EQ(store::ratings(*again, all).value(), store::ratings(*file_, all).value());
  EXPECT_EQ(store::rules(*again, all).value(), store::rules(*file_, all).value());
}

TEST_F(SimulatedStudy, SurvivesItsTables) {
  const std::vector<std::string> inputs = {"lubrication", "neck_flexion", "depth", "speed"};
  const std::string tables = folder_->file("tables");
  ASSERT_TRUE(study::writeStudyFolder(view_->study, inputs, tables));
  auto read = study::readStudyFolder(tables, inputs);
  ASSERT_TRUE(read) << read.error().message();
  read->study.name = view_->study.name;
  EXPECT_EQ(read->study, view_->study);
}

TEST(SimulatedStudyRefuses, AnUnknownReadingAndAFileThatIsThere) {
  const support::TempFolder folder;
  EXPECT_FALSE(makeSimulatedNgtStudy(folder.file("a.tactus"), 1, "another"));
  EXPECT_TRUE(folder.isEmpty());
}

constexpr std::int64_t kNowUtcMs = 1'795'000'000'000;

// Beside a person who is there already, and in the protocol that the study has.
TEST(SimulatedGroups, DoWholeSessionsAndSayThatTheyAreSimulated) {
  const support::TempFolder folder;
  auto file = store::StudyFile::create(folder.file("a.tactus"), {study::RecordIds(3).next(), "ward", 1, "test"});
  ASSERT_TRUE(file);
  ASSERT_TRUE(store::append(*file, study::Person{study::RecordIds(4).next(), "amber-otter", false}));
  StudyProtocol protocol;
  protocol.settings.speed.strokes = 2;
  protocol.consent_version = "1";
  protocol.consent["en"] = "Whose study it is.";
  SessionTools tools = systemTools();
  ASSERT_TRUE(setProtocol(*file, protocol, "", "", tools));
  const auto codes = addSimulatedNurses(*file, {3, 0.5, 7}, kNowUtcMs, "test");
  ASSERT_TRUE(codes) << codes.error().message();
  EXPECT_EQ(codes->size(), 3U);
  const auto view = studyForElicitation(*file);
  ASSERT_TRUE(view) << view.error().message();
  ASSERT_EQ(view->study.participants.size(), 4U);
  for (const auto& participant : view->study.participants) {
    EXPECT_EQ(participant.simulated, participant.code != "amber-otter") << participant.code;
  }
  EXPECT_EQ(view->study.answers.size(), 3 * 45U);
  std::set<std::pair<std::string, int>> slow;
  for (const auto& sample : view->study.speeds) {
    if (sample.level == "slow") slow.emplace(sample.participant, sample.stroke);
  }
  EXPECT_EQ(slow.size(), 3 * 2U) << "the protocol's strokes";
  const auto sessions = store::sessions(*file);
  ASSERT_TRUE(sessions);
  for (const auto& session : *sessions) {
    EXPECT_LT(session.started.utc_ms, kNowUtcMs);
    EXPECT_GT(session.started.utc_ms, kNowUtcMs - 4 * 3'600'000);
    EXPECT_TRUE(session.protocol.has_value());
  }
}

TEST(SimulatedGroups, OfNumbersOutOfRangeAreRefusedAndAddNobody) {
  const support::TempFolder folder;
  auto file = store::StudyFile::create(folder.file("a.tactus"), {study::RecordIds(3).next(), "ward", 1, "test"});
  ASSERT_TRUE(file);
  for (const SimulatedGroup& wrong : {SimulatedGroup{0, 0.5, 1}, SimulatedGroup{51, 0.5, 1}, SimulatedGroup{2, -0.1, 1},
                                      SimulatedGroup{2, std::nan(""), 1}, SimulatedGroup{2, 0.5, 0}}) {
    EXPECT_FALSE(addSimulatedNurses(*file, wrong, kNowUtcMs, "test"));
  }
  EXPECT_TRUE(store::persons(*file)->empty());
  const auto none = addSimulatedNurses(*file, {2, 0.5, 1}, kNowUtcMs, "test", [] { return false; });
  ASSERT_TRUE(none);
  EXPECT_TRUE(none->empty());
}

}  // namespace
}  // namespace tactus::session
