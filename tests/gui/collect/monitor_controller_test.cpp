#include "app/workbench/collect/monitor_controller.h"

#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "core/store/entries.h"
#include "core/store/persons.h"

#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;
using NoteKind = MonitorLine::Kind;

class MonitorControllerTest : public testing::Test {
 protected:
  void SetUp() override {
    tests::makeStudyFile(path, [this](store::StudyFile& file, study::RecordIds& ids) {
      start.person = ids.next();
      ASSERT_TRUE(store::append(file, study::Person{start.person, "amber-crow", false}));
    });
    study.open(path);
    ASSERT_TRUE(comesTrue([this] { return study.isOpen(); }));
    start.consent_version = "1";
    start.settings.blocks = {session::Block::kForce, session::Block::kForm};
    start.settings.force.familiarisation_n.clear();
    start.settings.force.ladder = {0.2, 0.4, 0.2};
    proxy.begin(start);
    settle();
    ASSERT_NE(proxy.snapshot(), nullptr);
    proxy.tell(proxy.snapshot()->step, {});
    settle();
  }
  void settle() {
    ASSERT_TRUE(comesTrue([this] { return !proxy.isSaving(); }));
  }
  bool says(NoteKind kind, const char* text) {
    return comesTrue([&] {
      const auto& lines = monitor.lines();
      return std::any_of(lines.begin(), lines.end(), [&](const MonitorLine& line) {
        return line.kind == kind && line.text == QString::fromUtf8(text);
      });
    });
  }

  QTemporaryDir folder;
  QString path = folder.filePath(QStringLiteral("study.tactus"));
  session::SessionStart start;
  std::int64_t now_ms = 1'700'000'000'000;
  StudyConnection study;
  SessionProxy proxy{study, nullptr, [this] { return study::Moment{now_ms, now_ms * 1'000'000}; }};
  MonitorController monitor{proxy, study, [this] { return now_ms; }};
};

TEST_F(MonitorControllerTest, TellsTheJudgementsAsTheyAreStored) {
  experiments::ForceAnswer answer{study::ForceJudgement::Kind::kTerm, "very_small"};
  answer.forward_mm = 40;
  answer.forward_speed_mm_s = 60;
  answer.delivered_share = 0.82;  // 18 % were missing
  ASSERT_TRUE(proxy.judge(proxy.snapshot()->step, answer));
  EXPECT_TRUE(says(NoteKind::kUnscored, "0.2 N: very small, not scored: only 82 % of the force was delivered"));
  answer.delivered_share = 1;
  settle();
  ASSERT_TRUE(proxy.judge(proxy.snapshot()->step, answer));
  EXPECT_TRUE(says(NoteKind::kAnswer, "0.2 N: very small"));
}

TEST_F(MonitorControllerTest, CountsTheQuestionsAndTellsTheReplies) {
  proxy.skipBlock("no device");
  settle();
  ASSERT_TRUE(proxy.reply(proxy.snapshot()->step, {study::Answer::Status::kAnswered, "very_large"}, 2));
  settle();
  EXPECT_TRUE(says(NoteKind::kAnswer, "Question 1: very large"));
  ASSERT_TRUE(proxy.reply(proxy.snapshot()->step, {study::Answer::Status::kCantTell, {}}, 2));
  settle();
  EXPECT_TRUE(says(NoteKind::kAnswer, "Question 2: can't tell"));
  EXPECT_EQ(monitor.share(), (session::Share{2, 45}));
}

TEST_F(MonitorControllerTest, PausesAndGoesOn) {
  EXPECT_TRUE(monitor.canPause());
  monitor.pause();
  settle();
  EXPECT_TRUE(monitor.isPaused());
  EXPECT_FALSE(monitor.canPause());
  monitor.goOn();
  settle();
  EXPECT_FALSE(monitor.isPaused());
  EXPECT_TRUE(says(NoteKind::kStage, "Goes on"));
  // A pause of the participant's own is not the researcher's to end.
  proxy.pause(session::kForceOff);
  settle();
  EXPECT_FALSE(monitor.isPaused());
  EXPECT_FALSE(monitor.canPause());
}

TEST_F(MonitorControllerTest, KeepsNotesWithTheirTimeInTheLog) {
  now_ms += 5000;
  monitor.note(QStringLiteral("  talked with a colleague "));
  monitor.note(QStringLiteral("   "));
  settle();
  ASSERT_EQ(monitor.lines().back().kind, NoteKind::kNote);
  study.close();
  ASSERT_TRUE(comesTrue([this] { return !study.isOpen(); }));
  const auto events = store::events(tests::lookInto(path));
  ASSERT_TRUE(events);
  const auto& last = events->back();
  EXPECT_EQ(last.kind, session::researcherNote("x").kind);
  EXPECT_NE(last.detail.find("talked with a colleague"), std::string::npos);
  EXPECT_EQ(last.entry.when.utc_ms, now_ms);
}

TEST_F(MonitorControllerTest, SaysThatTheParticipantCalled) {
  NurseView view;
  view.screen = QStringLiteral("Forces");
  monitor.show(view);
  view.called = true;
  monitor.show(view);
  EXPECT_TRUE(says(NoteKind::kCall, "The participant has called you"));
}

TEST(ForceTrace, KeepsTheLastSecondsOfOneRun) {
  ForceTrace trace;
  std::vector<haptics::Sample> samples(20'000);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].time_ns = static_cast<std::int64_t>(i) * 1'000'000;  // 1 kHz
    samples[i].source_force_n = 1.5;
    samples[i].force_n = i < 15'000 ? 1.5 : 0.9;
  }
  trace.add(samples);
  EXPECT_EQ(trace.points().size(), 2401U);  // 12 s, one point each 5 ms, both ends
  EXPECT_EQ(trace.newest()->delivered_n, 0.9);
  EXPECT_TRUE(trace.isCut());
  samples.resize(1);
  samples[0].time_ns = 0;  // another run of the device
  trace.add(samples);
  EXPECT_EQ(trace.points().size(), 1U);
  EXPECT_FALSE(trace.isCut());
}

}  // namespace
}  // namespace tactus::workbench
