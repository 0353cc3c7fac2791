#include "app/workbench/study/connection/session_proxy.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <gtest/gtest.h>
#include <memory>
#include <semaphore>
#include <sys/resource.h>

#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using session::SessionPart;
using tests::comesTrue;
using Status = study::Answer::Status;

questionnaires::Reply term(const char* id) { return {Status::kAnswered, id}; }

class SessionProxyTest : public testing::Test {
 protected:
  void SetUp() override {
    tests::makeStudyFile(path);
    openStudy();
  }
  void openStudy() {
    study = std::make_unique<StudyConnection>();
    proxy = std::make_unique<SessionProxy>(*study, nullptr, [this] { return now; });
    QObject::connect(proxy.get(), &SessionProxy::refused, [this](const QString& sentence) { refused = sentence; });
    study->open(path);
    ASSERT_TRUE(comesTrue([this] { return study->isOpen(); }));
  }
  void end() {
    proxy.reset();
    study.reset();
  }

  session::SessionStart start(std::vector<session::Block> blocks) {
    session::SessionStart out;
    out.person = person.id;
    out.consent_version = "2026-1";
    out.seed = 5;
    out.program = "test";
    out.settings.blocks = std::move(blocks);
    out.settings.speed.levels = {"slow"};
    out.settings.speed.practice = 0;
    out.settings.speed.strokes = 2;
    out.settings.force.familiarisation_n = {};
    out.settings.force.ladder = {0.1, 0.2, 0.1};
    return out;
  }
  // Begins with a new person who tells of themselves.
  void begin(std::vector<session::Block> blocks) {
    proxy->begin(start(std::move(blocks)), person);
    ASSERT_TRUE(answered()) << refused.toStdString();
    ASSERT_NE(proxy->snapshot(), nullptr) << refused.toStdString();
    ASSERT_TRUE(proxy->tell(step(), {}));
    ASSERT_TRUE(answered());
  }
  bool answered() {
    return comesTrue([this] { return !proxy->isSaving(); });
  }
  SessionStep step() const { return proxy->snapshot()->step; }
  SessionPart part() const { return proxy->snapshot()->part; }
  int item() const { return proxy->snapshot()->page ? proxy->snapshot()->page->item : 0; }
  bool replied(const char* id) { return proxy->reply(step(), term(id), 1.5) && answered(); }
  // Until it is released, nothing is written.
  std::shared_ptr<std::binary_semaphore> hangDisk() {
    const auto disk = std::make_shared<std::binary_semaphore>(0);
    study->order([disk](store::StudyFile&, study::RecordIds&) -> base::Result<void> {
      disk->acquire();
      return {};
    });
    return disk;
  }
  std::vector<study::AnswerRecord> answersInFile() { return *store::answers(tests::lookInto(path), {{}, {}, true}); }

  tests::ModelFolder folder;
  QString path = folder.path(QStringLiteral("session.tactus"));
  study::Moment now{1'700'000'000'000, 5'000'000'000};
  study::Person person{study::RecordIds(3).next(), "amber-otter", false};
  std::unique_ptr<StudyConnection> study;
  std::unique_ptr<SessionProxy> proxy;
  QString refused;
};

TEST_F(SessionProxyTest, GoesThroughAllPartsOfASession) {
  begin({session::Block::kSpeed, session::Block::kForce, session::Block::kForm});
  EXPECT_EQ(part(), SessionPart::kSpeed);
  EXPECT_TRUE(proxy->snapshot()->profile);
  for (const int number : {1, 2}) {
    ASSERT_EQ(proxy->snapshot()->speed->number, number);
    experiments::Stroke stroke{2, 8, 0.002, 0.007, 0, 60, experiments::StrokeVerdict::kAccepted};
    const study::Recording recording{1000, {{"depth", "mm", {0, 0, 5, 15, 30, 45, 55, 60, 60, 60}}}};
    ASSERT_TRUE(proxy->addStroke(step(), {stroke, recording, 0}));
    ASSERT_TRUE(answered());
  }
  EXPECT_EQ(part(), SessionPart::kRating);
  EXPECT_EQ(proxy->snapshot()->block, session::Block::kSpeed);
  ASSERT_TRUE(proxy->rate(step(), 2, 6));
  ASSERT_TRUE(answered());
  EXPECT_EQ(proxy->snapshot()->blocks_done, 1U);
  for (const double force_n : {0.1, 0.2}) {
    ASSERT_EQ(part(), SessionPart::kForce);
    EXPECT_EQ(proxy->snapshot()->force->step.force_n, force_n);
    experiments::ForceAnswer answer{study::ForceJudgement::Kind::kTerm, "small", 0, 40, 60, 1.5, true};
    ASSERT_TRUE(proxy->judge(step(), answer));
    ASSERT_TRUE(answered());
  }
  ASSERT_TRUE(proxy->rate(step(), 2, 6));
  ASSERT_TRUE(answered());
  ASSERT_EQ(part(), SessionPart::kForm);
  EXPECT_EQ(proxy->snapshot()->page->count, 45U);
  for (int i = 0; i < 45; ++i) ASSERT_TRUE(replied("large")) << i;
  EXPECT_EQ(proxy->snapshot()->progress.answered, 45U);
  ASSERT_TRUE(proxy->rate(step(), 2, 6));
  ASSERT_TRUE(answered());
  EXPECT_EQ(part(), SessionPart::kFinished);
  EXPECT_TRUE(refused.isEmpty()) << refused.toStdString();
  end();
  EXPECT_TRUE(store::checkStudy(tests::lookInto(path))->empty());
  EXPECT_EQ(answersInFile().size(), 45U);
}

TEST_F(SessionProxyTest, ADoubleClickNeverAnswersTheNextQuestion) {
  begin({session::Block::kForm});
  const SessionStep seen = step();
  EXPECT_TRUE(proxy->reply(seen, term("small"), 1));
  EXPECT_FALSE(proxy->reply(seen, term("small"), 1));  // while the first is being stored
  ASSERT_TRUE(answered());
  EXPECT_FALSE(proxy->reply(seen, term("small"), 1));  // the screen still showed the first question
  EXPECT_FALSE(proxy->isSaving());
  EXPECT_EQ(item(), 2);
  end();
  ASSERT_EQ(answersInFile().size(), 1U);
  EXPECT_EQ(answersInFile()[0].item, 1);
}

TEST_F(SessionProxyTest, TheNextQuestionOpensOnTheCommitAndARecordBearsTheTimeOfTheCall) {
  begin({session::Block::kForm});
  const auto disk = hangDisk();
  now.utc_ms += 10'000;
  const std::int64_t click_ms = now.utc_ms;
  ASSERT_TRUE(proxy->reply(step(), term("small"), 1));
  now.utc_ms += 60'000;
  ASSERT_TRUE(comesTrue([this] { return proxy->isSlow(); }));
  EXPECT_EQ(item(), 1);
  EXPECT_TRUE(proxy->isSaving());
  disk->release();
  ASSERT_TRUE(answered());
  EXPECT_EQ(item(), 2);
  EXPECT_EQ(proxy->snapshot()->replies[0].reply->value, "small");
  end();
  EXPECT_EQ(answersInFile()[0].entry.when.utc_ms, click_ms);
}

TEST_F(SessionProxyTest, WhatTheDiskRefusesIsVisibleAndStoredOnce) {
  begin({session::Block::kForm});
  auto full = std::make_shared<std::atomic<bool>>(true);
  study->order([full](store::StudyFile&, study::RecordIds&) -> base::Result<void> {
    if (*full) return base::fail(base::ErrorCode::kIo, "disk", "no space left", "free space");
    return {};
  });
  ASSERT_TRUE(proxy->reply(step(), term("small"), 1));
  ASSERT_TRUE(comesTrue([this] { return !proxy->failure().isEmpty(); }));
  EXPECT_TRUE(proxy->failure().contains(QStringLiteral("no space left"))) << proxy->failure().toStdString();
  EXPECT_EQ(item(), 1);
  *full = false;
  study->storeNow();
  ASSERT_TRUE(answered());
  EXPECT_TRUE(proxy->failure().isEmpty());
  EXPECT_EQ(item(), 2);
  EXPECT_TRUE(refused.isEmpty()) << refused.toStdString();
  end();
  EXPECT_EQ(answersInFile().size(), 1U);
}

TEST_F(SessionProxyTest, AFullDiskIsToldAndTheAnswerIsStoredOnceThereIsRoom) {
  begin({session::Block::kForm});
  // Nothing can be written beyond the first 1024 bytes of a file: as a full disk, for the journal.
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit full{1024, limit.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &full), 0);
  const bool taken = proxy->reply(step(), term("small"), 1);
  const bool told = comesTrue([this] { return !proxy->failure().isEmpty(); });
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  EXPECT_TRUE(taken && told);
  EXPECT_EQ(item(), 1);
  study->storeNow();
  ASSERT_TRUE(answered());
  EXPECT_EQ(item(), 2);
  EXPECT_TRUE(refused.isEmpty()) << refused.toStdString();
  end();
  EXPECT_EQ(answersInFile().size(), 1U);
  EXPECT_TRUE(store::checkStudy(tests::lookInto(path))->empty());
}

TEST_F(SessionProxyTest, AWrongCallIsASentenceAndChangesNothing) {
  begin({session::Block::kForm});
  const auto before = proxy->snapshot();
  ASSERT_TRUE(proxy->rate(step(), 2, 6));
  ASSERT_TRUE(answered());
  EXPECT_TRUE(refused.contains(QStringLiteral("a rating"))) << refused.toStdString();
  EXPECT_EQ(proxy->snapshot(), before);
  ASSERT_TRUE(proxy->reply(step(), term("enormous"), 1));
  ASSERT_TRUE(answered());
  EXPECT_TRUE(refused.contains(QStringLiteral("enormous"))) << refused.toStdString();
  EXPECT_TRUE(replied("small"));
  EXPECT_EQ(item(), 2);
}

TEST_F(SessionProxyTest, InstructionsWaitForTheirTurnAndKeepTheStep) {
  begin({session::Block::kForm});
  const auto disk = hangDisk();
  const SessionStep seen = step();
  ASSERT_TRUE(proxy->reply(seen, term("small"), 1));
  proxy->pause("force off");
  disk->release();
  ASSERT_TRUE(answered());
  EXPECT_TRUE(proxy->snapshot()->paused);
  EXPECT_EQ(item(), 2);
  EXPECT_EQ(step(), seen + 1);
  proxy->unpause();
  ASSERT_TRUE(answered());
  EXPECT_FALSE(proxy->snapshot()->paused);
  EXPECT_EQ(step(), seen + 1);
  proxy->unpause();
  ASSERT_TRUE(answered());
  EXPECT_TRUE(refused.contains(QStringLiteral("the end of a pause"))) << refused.toStdString();
}

TEST_F(SessionProxyTest, AnEventIsNoAnswerAndHoldsNoneUp) {
  begin({session::Block::kForm});
  const auto disk = hangDisk();
  proxy->note(session::textSizeChosen(125));
  EXPECT_TRUE(proxy->isSaving());
  EXPECT_FALSE(proxy->isMovingOn());
  EXPECT_TRUE(proxy->reply(step(), term("small"), 1));
  EXPECT_TRUE(proxy->isMovingOn());
  disk->release();
  ASSERT_TRUE(answered());
  EXPECT_EQ(item(), 2);
  proxy->note({"aborted", "{}"});  // a kind that steers the session
  ASSERT_TRUE(answered());
  EXPECT_FALSE(refused.isEmpty());
  end();
  const auto events = *store::events(tests::lookInto(path), {{}, {}, true});
  const std::string kind = session::textSizeChosen(125).kind;
  EXPECT_EQ(std::count_if(events.begin(), events.end(), [&](const auto& one) { return one.kind == kind; }), 1);
}

TEST_F(SessionProxyTest, ABlockIsClosedWithoutARating) {
  begin({session::Block::kForm});
  for (int i = 0; i < 45; ++i) ASSERT_TRUE(replied("large")) << i;
  ASSERT_EQ(part(), SessionPart::kRating);
  ASSERT_TRUE(proxy->goTo(step(), 7) && answered());
  EXPECT_EQ(item(), 7);
  ASSERT_TRUE(proxy->goOn(step()) && answered());
  ASSERT_EQ(part(), SessionPart::kRating);
  ASSERT_TRUE(proxy->closeBlock(step()) && answered());
  EXPECT_EQ(part(), SessionPart::kFinished);
  const auto session = proxy->snapshot()->record->id;
  end();
  openStudy();
  proxy->resume(session);
  ASSERT_TRUE(answered());
  EXPECT_EQ(part(), SessionPart::kFinished);
}

TEST_F(SessionProxyTest, BackAndForwardShowWhatWasAnswered) {
  begin({session::Block::kForm});
  ASSERT_TRUE(replied("small") && replied("large"));
  ASSERT_TRUE(proxy->back(step()) && answered());
  EXPECT_EQ(item(), 2);
  EXPECT_EQ(proxy->snapshot()->page->reply->value, "large");
  ASSERT_TRUE(replied("medium"));
  EXPECT_EQ(item(), 3);
  EXPECT_EQ(proxy->snapshot()->replies[1].reply->value, "medium");
  EXPECT_TRUE(proxy->snapshot()->replies[2].isOpen());
  EXPECT_EQ(proxy->snapshot()->progress.answered, 2U);
}

TEST_F(SessionProxyTest, ASessionThatCannotBeginIsASentence) {
  auto without_consent = start({session::Block::kForm});
  without_consent.consent_version.clear();
  proxy->begin(without_consent, person);
  ASSERT_TRUE(answered());
  EXPECT_TRUE(refused.contains(QStringLiteral("no consent"))) << refused.toStdString();
  EXPECT_EQ(proxy->snapshot(), nullptr);
  proxy->resume(study::RecordIds(99).next());
  ASSERT_TRUE(answered());
  EXPECT_TRUE(refused.contains(QStringLiteral("a session of this study"))) << refused.toStdString();
  refused.clear();
  proxy->pause("nothing to pause");
  ASSERT_TRUE(answered());
  EXPECT_FALSE(refused.isEmpty());
  // The person came with the session, and went with it.
  end();
  EXPECT_TRUE(store::persons(tests::lookInto(path))->empty());
}

TEST_F(SessionProxyTest, ClosingTheStudyWaitsForTheLastAnswerAndEndsTheSession) {
  begin({session::Block::kForm});
  const auto session = proxy->snapshot()->record->id;
  const auto disk = hangDisk();
  ASSERT_TRUE(proxy->reply(step(), term("small"), 1));
  study->close();
  disk->release();
  ASSERT_TRUE(comesTrue([this] { return !study->isOpen(); }));
  EXPECT_EQ(proxy->snapshot(), nullptr);
  EXPECT_FALSE(proxy->isSaving());
  EXPECT_EQ(answersInFile().size(), 1U);
  proxy->resume(session);
  EXPECT_FALSE(refused.isEmpty());  // no study is open

  openStudy();
  proxy->resume(session);
  ASSERT_TRUE(answered());
  ASSERT_NE(proxy->snapshot(), nullptr) << refused.toStdString();
  EXPECT_EQ(item(), 2);
}

TEST_F(SessionProxyTest, AnotherStudyEndsTheSessionBeforeItsFileGoes) {
  const QString other = folder.path(QStringLiteral("other.tactus"));
  tests::makeStudyFile(other);
  begin({session::Block::kForm});
  ASSERT_TRUE(proxy->reply(step(), term("small"), 1));
  study->open(other);
  ASSERT_TRUE(comesTrue([&] { return study->path() == other; }));
  EXPECT_EQ(proxy->snapshot(), nullptr);
  EXPECT_EQ(answersInFile().size(), 1U);
  end();
  EXPECT_TRUE(store::sessions(tests::lookInto(other))->empty());
}

}  // namespace
}  // namespace tactus::workbench
