#include "app/session/study_import.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>

#include "app/session/simulated_strokes.h"
#include "app/session/study_source.h"
#include "app/session/study_view.h"
#include "core/base/random.h"
#include "core/store/entries.h"
#include "core/store/merge.h"
#include "core/store/person_codes.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"
#include "core/store/study_records.h"
#include "core/store/withdrawal.h"
#include "experiments/speed_from_positions.h"

#include "tests/support/temp_folder.h"

namespace tactus::session {
namespace {

/// A small study with every kind of row; another for each seed.
study::Study smallStudy(std::uint64_t seed) {
  base::Random random(seed);
  study::Study study;
  for (const char* code : {"amber-otter", "copper-finch", "quiet-maple"}) {
    study::Participant participant;
    participant.code = code;
    participant.years_experience = random.below(30);
    participant.category = "expert";
    participant.handedness = "left";
    if (random.below(2) == 0) participant.weight = random.uniform(0, 3);
    study.participants.push_back(participant);
    for (const char* level : {"slow", "fast"}) {
      for (int stroke = 1; stroke <= 2; ++stroke) {
        for (int i = 0; i < 3 + random.below(4); ++i) {
          study::SpeedSample sample;
          sample.participant = code;
          sample.level = level;
          sample.stroke = stroke;
          sample.time_s = 0.01 * i;
          sample.depth_mm = random.uniform(0, 60);
          sample.speed_mm_s = random.uniform(10, 300);
          study.speeds.push_back(sample);
        }
      }
    }
    using JudgedAs = study::ForceJudgement::Kind;
    for (int step = 1; step <= 5; ++step) {
      study::ForceJudgement judgement;
      judgement.participant = code;
      judgement.series = "ascending";
      judgement.step = step;
      judgement.force_n = 0.1 * step;
      judgement.kind = step < 5 ? JudgedAs::kTerm : JudgedAs::kBeyondPractice;
      if (step < 5) judgement.term = random.below(2) == 0 ? "small" : "large";
      study.judgements.push_back(judgement);
    }
    for (int item = 1; item <= 4; ++item) {
      study::Answer answer;
      answer.participant = code;
      answer.form = "ngt-force-v1";
      answer.item = item;
      answer.status = random.below(3) == 0 ? study::Answer::Status::kCantTell : study::Answer::Status::kAnswered;
      if (answer.status == study::Answer::Status::kAnswered) answer.term = "medium";
      study.answers.push_back(answer);
    }
  }
  study::GivenRule rule;
  rule.participant = "quiet-maple";
  rule.conditions = {{"lubrication", "well"}, {"depth", "nasal_cavity"}};
  rule.then = "small";
  rule.weight = 0.5;
  study.rules.push_back(rule);
  return study;
}

/// The same rows, whatever the name of the study.
void expectSameRows(const study::Study& a, const study::Study& b) {
  EXPECT_TRUE(a.participants == b.participants);
  EXPECT_TRUE(a.speeds == b.speeds);
  EXPECT_TRUE(a.judgements == b.judgements);
  EXPECT_TRUE(a.answers == b.answers);
  EXPECT_TRUE(a.rules == b.rules);
}

class StudyImportTest : public testing::Test {
 protected:
  store::StudyFile create(const std::string& name) {
    auto file = store::StudyFile::create(folder_.file(name), {ids_.next(), name, 1, "test"});
    EXPECT_TRUE(file) << file.error().message();
    return *std::move(file);
  }
  support::TempFolder folder_;
  study::RecordIds ids_{1};
};

TEST_F(StudyImportTest, EveryRowComesBack) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    auto file = create(std::to_string(seed) + ".tactus");
    const auto study = smallStudy(seed);
    const auto imported = importTables(study, file);
    ASSERT_TRUE(imported) << imported.error().message();
    EXPECT_EQ(imported->persons, 3U);
    EXPECT_EQ(imported->sessions, 3U);
    const auto view = studyForElicitation(file);
    ASSERT_TRUE(view) << view.error().message();
    EXPECT_TRUE(view->notes.empty());
    expectSameRows(view->study, study);
    EXPECT_TRUE(store::checkStudy(file)->empty());
  }
}

TEST_F(StudyImportTest, TheSameRowsAreNeverAddedTwice) {
  auto file = create("a.tactus");
  ASSERT_TRUE(importTables(smallStudy(1), file));
  const auto before = store::studyInfo(file);
  const auto again = importTables(smallStudy(1), file);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->persons + again->sessions + again->records, 0U);
  EXPECT_EQ(again->notes.size(), 3U);
  EXPECT_EQ(store::studyInfo(file)->counts, before->counts);
}

TEST_F(StudyImportTest, ChangedRowsCountInsteadOfTheEarlierOnes) {
  auto file = create("a.tactus");
  ASSERT_TRUE(importTables(smallStudy(1), file));
  ASSERT_TRUE(importTables(smallStudy(2), file));
  const auto view = studyForElicitation(file);
  ASSERT_TRUE(view);
  expectSameRows(view->study, smallStudy(2));
  EXPECT_FALSE(view->notes.empty());  // that there are two sessions is said
  EXPECT_EQ(store::sessions(file)->size(), 6U);
}

TEST_F(StudyImportTest, WhatWasImportedLastCounts) {
  auto file = create("a.tactus");
  std::int64_t utc_ms = 1'770'000'000'000;
  for (const std::uint64_t seed : {1U, 2U, 1U, 2U, 1U}) {
    // The clock is set back each time.
    utc_ms -= 86'400'000;
    const auto imported = importTables(smallStudy(seed), file, {"tables", "", utc_ms});
    ASSERT_TRUE(imported) << imported.error().message();
    EXPECT_EQ(imported->sessions, 3U);
    expectSameRows(studyForElicitation(file)->study, smallStudy(seed));
  }
  // The latest rows again are nothing new, whenever that is.
  const auto again = importTables(smallStudy(1), file, {"tables", "", utc_ms + 5});
  ASSERT_TRUE(again);
  EXPECT_EQ(again->sessions, 0U);
  EXPECT_TRUE(store::checkStudy(file)->empty());
}

TEST_F(StudyImportTest, RecordsHaveTheTimeOfTheImportAndTheStudyRemembersIt) {
  auto file = create("a.tactus");
  constexpr std::int64_t kNow = 1'770'000'000'123;
  const std::string hash(64, 'a');
  const auto imported = importTables(smallStudy(1), file, {"ward 7", hash, kNow});
  ASSERT_TRUE(imported);
  const auto sessions = store::sessions(file);
  for (const auto& session : *sessions) EXPECT_EQ(session.started.utc_ms, kNow);
  const auto answers = store::answers(file);
  for (const auto& answer : *answers) EXPECT_EQ(answer.entry.when.utc_ms, kNow);
  const auto strokes = store::strokes(file);
  for (const auto& stroke : *strokes) EXPECT_EQ(stroke.entry.when.utc_ms, kNow);
  const auto log = store::importLog(file);
  ASSERT_TRUE(log);
  ASSERT_EQ(log->size(), 1U);
  EXPECT_EQ(log->front().utc_ms, kNow);
  EXPECT_EQ(log->front().kind, "tables");
  EXPECT_EQ(log->front().source, "ward 7");
  EXPECT_EQ(log->front().sha256, hash);
  EXPECT_EQ(log->front().detail,
            "{\"persons\":3,\"records\":" + std::to_string(imported->records) + ",\"sessions\":3}");
  ASSERT_TRUE(importTables(smallStudy(1), file, {"ward 7", hash, kNow + 1}));
  EXPECT_EQ(store::importLog(file)->size(), 1U) << "nothing was new";
}

TEST_F(StudyImportTest, TheSameCodesAndRowsAtTwoSitesAreOtherPersons) {
  const auto at = [this](const std::string& name, std::uint64_t seed) {
    auto file = create(name);
    ASSERT_TRUE(importTables(smallStudy(seed), file) && file.close());
  };
  at("north.tactus", 1);
  at("south.tactus", 1);  // even the rows are the same
  at("west.tactus", 2);
  const auto merged = [&](const std::string& into, const std::string& from) {
    auto file = store::StudyFile::open(folder_.file(into));
    const auto merge = store::mergeStudy(*file, folder_.file(from), ids_.next(), 1);
    EXPECT_TRUE(merge) << merge.error().message();
    EXPECT_TRUE(file->close());
    return merge ? *merge : store::Merge{};
  };
  const auto south = merged("north.tactus", "south.tactus");
  EXPECT_EQ(south.conflicts.size(), 3U);
  const auto west = merged("north.tactus", "west.tactus");
  ASSERT_EQ(west.conflicts.size(), 3U);
  EXPECT_NE(west.conflicts[0].find("3 persons have the code 'amber-otter'"), std::string::npos) << west.conflicts[0];
  EXPECT_TRUE(merged("north.tactus", "south.tactus").added.empty());

  auto file = store::StudyFile::open(folder_.file("north.tactus"));
  EXPECT_EQ(store::persons(*file)->size(), 9U);
  EXPECT_EQ(store::sessions(*file)->size(), 9U);
  const auto view = studyForElicitation(*file);
  ASSERT_FALSE(view);
  EXPECT_NE(view.error().message().find("found 3 persons with the code 'amber-otter' (ids "), std::string::npos);
  EXPECT_NE(view.error().message().find("wanted a code of its own for each person: tactus study recode "),
            std::string::npos)
      << view.error().message();
  EXPECT_FALSE(importTables(smallStudy(3), *file));  // whose they are cannot be told

  // Two of each three get other codes, and the data of no two are mixed.
  std::map<std::string, int> seen;
  const auto everybody = store::persons(*file);
  for (const auto& person : *everybody) {
    const int number = ++seen[person.code];
    if (number == 1) continue;
    ASSERT_TRUE(store::recode(*file, person.id, person.code + "-" + std::to_string(number), ids_.next(), 10));
  }
  const auto after = studyForElicitation(*file);
  ASSERT_TRUE(after) << after.error().message();
  EXPECT_EQ(after->study.participants.size(), 9U);
  EXPECT_EQ(after->study.answers.size(), 3 * smallStudy(1).answers.size());
}

TEST_F(StudyImportTest, RowsThatAreThereAreFoundUnderAnotherCode) {
  auto file = create("a.tactus");
  ASSERT_TRUE(importTables(smallStudy(1), file));
  const auto person = store::findPerson(file, "amber-otter");
  ASSERT_TRUE(store::recode(file, (*person)->id, "misty-lake", ids_.next(), 10));
  const auto again = importTables(smallStudy(1), file);
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(again->persons + again->sessions + again->records, 0U);
  EXPECT_EQ(store::persons(file)->size(), 3U);
}

TEST_F(StudyImportTest, WhoWithdrewDoesNotComeBack) {
  auto file = create("a.tactus");
  ASSERT_TRUE(importTables(smallStudy(1), file));
  const auto person = store::findPerson(file, "amber-otter");
  ASSERT_TRUE(person && *person);
  ASSERT_TRUE(store::withdraw(file, (*person)->id, 1'780'000'000'000));
  for (const std::uint64_t seed : {1, 2}) {
    const auto again = importTables(smallStudy(seed), file);
    ASSERT_FALSE(again);
    EXPECT_NE(
        again.error().message().find("found the code 'amber-otter' of a participant who withdrew on "
                                     "2026-05-28T20:26:40Z, wanted a person who has not taken back their consent"),
        std::string::npos)
        << again.error().message();
  }
  EXPECT_FALSE(*store::findPerson(file, "amber-otter"));
  EXPECT_EQ(store::persons(file)->size(), 2U);  // and the refusal added nothing
}

TEST_F(StudyImportTest, SimulatedAndRealRowsNeverMix) {
  auto file = create("a.tactus");
  ASSERT_TRUE(importTables(smallStudy(1), file));
  auto simulated = smallStudy(2);
  for (auto& participant : simulated.participants) participant.simulated = true;
  const auto mixed = importTables(simulated, file);
  ASSERT_FALSE(mixed);
  EXPECT_NE(mixed.error().message().find("amber-otter"), std::string::npos) << mixed.error().message();
}

TEST_F(StudyImportTest, AWholeStudyGoesThroughTheFileUnchanged) {
  auto file = create("a.tactus");
  // The strokes of one nurse are enough; those of four take seconds.
  auto study = smallStudy(6);
  int number = 0;
  const auto level = simulatedLevel({"amber-otter", "medium", 106, 25}, 1);
  for (const auto& stream : level.strokes) {
    const auto motion = experiments::speedFromPositions(stream.time_s, stream.depth_mm);
    ASSERT_TRUE(motion);
    ++number;
    for (const auto& at : motion->samples) {
      study.speeds.push_back({"amber-otter", "medium", number, at.time_s, at.depth_mm, at.speed_mm_s});
    }
  }
  std::stable_sort(study.speeds.begin(), study.speeds.end(),
                   [](const auto& a, const auto& b) { return a.participant < b.participant; });
  ASSERT_TRUE(importTables(study, file));
  const auto view = studyForElicitation(file);
  ASSERT_TRUE(view);
  expectSameRows(view->study, study);
}

}  // namespace
}  // namespace tactus::session
