#include "app/workbench/collect/study_overview.h"

#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/workbench/study/connection/study_contents.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sealed_references.h"
#include "core/store/sessions.h"

#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using session::Block;
using session::SessionProgress;
using session::Share;
using Word = StepWord;

StepWord wordOf(const std::array<StepState, kCollectSteps>& steps, CollectStep step) {
  return steps[static_cast<std::size_t>(step)].word;
}

TEST(StepsOf, ANewSession) {
  SessionProgress progress;
  progress.practice = {0, 6};
  progress.speed = Share{0, 12};
  progress.force = Share{0, 17};
  progress.form = Share{0, 45};
  const auto steps = stepsOf(progress);
  EXPECT_EQ(wordOf(steps, CollectStep::kConsent), Word::kDone);
  EXPECT_EQ(wordOf(steps, CollectStep::kDeviceCheck), Word::kOpen);
  EXPECT_EQ(wordOf(steps, CollectStep::kSpeed), Word::kOpen);
  EXPECT_EQ(nextOf(steps), CollectStep::kDeviceCheck);
}

TEST(StepsOf, ASessionInTheMiddle) {
  SessionProgress progress;
  progress.part = session::SessionPart::kForce;
  progress.practice = {6, 6};
  progress.speed = Share{12, 12};
  progress.force = Share{5, 17};
  progress.form = Share{0, 45};
  const auto steps = stepsOf(progress);
  EXPECT_EQ(wordOf(steps, CollectStep::kDeviceCheck), Word::kDone);
  EXPECT_EQ(wordOf(steps, CollectStep::kSpeed), Word::kDone);
  EXPECT_EQ(steps[static_cast<std::size_t>(CollectStep::kForces)], (StepState{Word::kPartly, {5, 17}}));
  EXPECT_EQ(wordOf(steps, CollectStep::kReview), Word::kOpen);
  EXPECT_EQ(nextOf(steps), CollectStep::kForces);
}

// The questions first, then the forces: what is next follows the protocol, not the columns.
TEST(StepsOf, PartsInAnotherOrder) {
  SessionProgress progress;
  progress.practice = {0, 3};
  progress.force = Share{0, 17};
  progress.form = Share{12, 45};
  EXPECT_EQ(nextOf(stepsOf(progress), Block::kForm), CollectStep::kQuestions);
  progress.form = Share{45, 45};
  EXPECT_EQ(nextOf(stepsOf(progress), Block::kForm), CollectStep::kReview);
  progress.sealed = true;
  EXPECT_EQ(nextOf(stepsOf(progress), Block::kForce), CollectStep::kDeviceCheck);
  progress.practice = {3, 3};
  EXPECT_EQ(nextOf(stepsOf(progress), Block::kForce), CollectStep::kForces);
}

// Questions alone, or a session whose movements were left out: nothing asks for a device but the own model.
TEST(StepsOf, PartsThatAreNotThereOrLeftOut) {
  SessionProgress questions;
  questions.form = Share{45, 45};
  questions.sealed = true;
  auto steps = stepsOf(questions);
  EXPECT_EQ(wordOf(steps, CollectStep::kDeviceCheck), Word::kNotPart);
  EXPECT_EQ(wordOf(steps, CollectStep::kPractice), Word::kNotPart);
  EXPECT_EQ(wordOf(steps, CollectStep::kReview), Word::kDone);
  EXPECT_EQ(nextOf(steps), CollectStep::kOwnModel);

  SessionProgress left_out = questions;
  left_out.practice = {0, 4};
  left_out.speed = Share{0, 12};
  left_out.force = Share{0, 17};
  left_out.skipped = {Block::kSpeed, Block::kForce};
  steps = stepsOf(left_out);
  EXPECT_EQ(wordOf(steps, CollectStep::kSpeed), Word::kSkipped);
  EXPECT_EQ(wordOf(steps, CollectStep::kDeviceCheck), Word::kSkipped);
  EXPECT_EQ(nextOf(steps), CollectStep::kOwnModel);
}

class ReadOverview : public testing::Test {
 protected:
  StudyOverview read() {
    const auto overview = readOverview(tests::lookInto(path));
    EXPECT_TRUE(overview) << overview.error().message();
    return overview.value_or(StudyOverview());
  }

  QTemporaryDir folder;
  QString path = folder.filePath(QStringLiteral("study.tactus"));
};

TEST_F(ReadOverview, SomebodyWhoHasOnlyACode) {
  tests::makeStudyFile(path, [](store::StudyFile& file, study::RecordIds& ids) {
    ASSERT_TRUE(store::append(file, study::Person{ids.next(), "velvet-otter", false}));
  });
  const StudyOverview overview = read();
  ASSERT_EQ(overview.rows.size(), 1U);
  const ParticipantRow& row = overview.rows.front();
  EXPECT_EQ(row.code, QStringLiteral("velvet-otter"));
  EXPECT_EQ(row.last_seen_ms, 0);
  EXPECT_EQ(row.next, CollectStep::kConsent);
  EXPECT_EQ(row.at(CollectStep::kUsability).word, Word::kNotPart);
  EXPECT_EQ(overview.protocol.version, 0);
  EXPECT_FALSE(overview.has_key);
}

TEST_F(ReadOverview, ResearchersAndSealsAreNoParticipants) {
  tests::makeStudyFile(path, [](store::StudyFile& file, study::RecordIds& ids) {
    const std::pair<const char*, const char*> people[] = {
        {"calm-fox", kResearcherCategory}, {"quiet-sea", store::kSealCategory}, {"velvet-otter", "expert"}};
    for (const auto& [code, category] : people) {
      const study::Person person{ids.next(), code, false};
      study::SessionRecord session;
      session.id = ids.next();
      session.person = person.id;
      session.kind = study::SessionKind::kUsability;
      study::ProfileRecord profile;
      profile.entry = {ids.next(), session.id, {}, study::EnteredBy::kResearcher, std::nullopt, {}};
      profile.category = category;
      ASSERT_TRUE(store::append(file, person));
      ASSERT_TRUE(store::append(file, session));
      ASSERT_TRUE(store::append(file, profile));
    }
  });
  const StudyOverview overview = read();
  ASSERT_EQ(overview.rows.size(), 1U);
  EXPECT_EQ(overview.rows.front().code, QStringLiteral("velvet-otter"));
  // Nobody feels a model under the code of a seal.
  const auto people = readPeople(tests::lookInto(path));
  ASSERT_TRUE(people);
  ASSERT_EQ(people->size(), 2U);
  EXPECT_TRUE(people->front().researcher);
}

TEST_F(ReadOverview, ASessionIsCountedAndItsLanguageAndTimeAreShown) {
  tests::makeStudyFile(path, [](store::StudyFile& file, study::RecordIds& ids) {
    const study::Person person{ids.next(), "amber-crow", true};
    ASSERT_TRUE(store::append(file, person));
    session::SessionStart start;
    start.person = person.id;
    start.consent_version = "1";
    start.language = "zh-Hant";
    start.settings.blocks = {Block::kForm};
    auto begun = session::Session::begin(file, start,
                                         {[] {
                                            return study::Moment{1'700'000'000'000, 0};
                                          },
                                          study::RecordIds(3)});
    ASSERT_TRUE(begun) << begun.error().message();
    ASSERT_TRUE(begun->tell({}));
    for (int i = 0; i < 7; ++i) ASSERT_TRUE(begun->reply({study::Answer::Status::kAnswered, "small"}, 1));
  });
  const ParticipantRow row = read().rows.front();
  EXPECT_TRUE(row.simulated);
  EXPECT_EQ(row.language, QStringLiteral("zh-Hant"));
  EXPECT_EQ(row.last_seen_ms, 1'700'000'000'000);
  EXPECT_EQ(row.at(CollectStep::kQuestions), (StepState{Word::kPartly, {7, 45}}));
  EXPECT_EQ(row.at(CollectStep::kSpeed).word, Word::kNotPart);
  EXPECT_EQ(row.next, CollectStep::kQuestions);
}

TEST_F(ReadOverview, AnEndedSessionIsSaidAndOneThatCannotBeReadKeepsTheRow) {
  tests::makeStudyFile(path, [](store::StudyFile& file, study::RecordIds& ids) {
    const study::Person person{ids.next(), "amber-crow", false};
    ASSERT_TRUE(store::append(file, person));
    session::SessionStart start;
    start.person = person.id;
    start.consent_version = "1";
    auto begun = session::Session::begin(file, start, session::systemTools());
    ASSERT_TRUE(begun);
    ASSERT_TRUE(begun->abort("alarm"));
    // A session without settings, as no program of ours makes one.
    tests::addVisit(file, ids, "blue-fox", false);
  });
  const StudyOverview overview = read();
  ASSERT_EQ(overview.rows.size(), 2U);
  EXPECT_TRUE(overview.rows[0].stopped);
  EXPECT_FALSE(overview.rows[1].trouble.isEmpty());
}

}  // namespace
}  // namespace tactus::workbench
