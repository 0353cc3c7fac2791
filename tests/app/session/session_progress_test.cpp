#include <gtest/gtest.h>
#include <optional>
#include <utility>

#include "app/session/session_state.h"
#include "core/store/entries.h"
#include "core/store/persons.h"

#include "tests/support/temp_folder.h"

namespace tactus::session {
namespace {

using Kind = study::ForceJudgement::Kind;
using Status = study::Answer::Status;

class SessionProgressTest : public testing::Test {
 protected:
  void SetUp() override {
    auto created = store::StudyFile::create(folder_.file("study.tactus"), {ids_.next(), "test", 1, "test"});
    ASSERT_TRUE(created) << created.error().message();
    file_.emplace(*std::move(created));
    SessionStart start;
    start.person = ids_.next();
    ASSERT_TRUE(store::append(*file_, study::Person{start.person, "amber-otter", false}));
    start.consent_version = "1";
    start.settings.speed.levels = {"slow", "fast"};
    start.settings.speed.practice = 1;
    start.settings.speed.strokes = 2;
    start.settings.force.familiarisation_n = {0.3};
    start.settings.force.ladder = {0.2, 1.0, 0.2};
    auto begun = Session::begin(*file_, start, {[this] { return study::Moment{++utc_ms_, utc_ms_}; }, ids_});
    ASSERT_TRUE(begun) << begun.error().message();
    session_.emplace(*std::move(begun));
  }

  SessionProgress progress() {
    const auto found = sessionProgress(*file_, session_->record());
    EXPECT_TRUE(found) << found.error().message();
    return found.value_or(SessionProgress());
  }
  void stroke(experiments::StrokeVerdict verdict = experiments::StrokeVerdict::kAccepted) {
    const experiments::Stroke stroke{2, 8, 0.002, 0.007, 0, 60, verdict};
    const study::Recording recording{1000, {{"depth", "mm", {0, 0, 5, 15, 30, 45, 55, 60, 60, 60}}}};
    ASSERT_TRUE(session_->addStroke(stroke, recording, 0));
  }
  void judge(Kind kind, const char* term = "") {
    experiments::ForceAnswer answer{kind, term};
    answer.forward_mm = 40;
    answer.forward_speed_mm_s = 60;
    const auto done = session_->judge(answer);
    ASSERT_TRUE(done) << done.error().message();
  }

  support::TempFolder folder_;
  study::RecordIds ids_{5};
  std::int64_t utc_ms_ = 1'700'000'000'000;
  std::optional<store::StudyFile> file_;
  std::optional<Session> session_;
};

TEST_F(SessionProgressTest, CountsWhatIsDoneOfWhatIsPlanned) {
  SessionProgress now = progress();
  EXPECT_EQ(now.part, SessionPart::kProfile);
  EXPECT_FALSE(now.has_profile);
  EXPECT_EQ(now.speed, (Share{0, 4}));     // two levels, two each
  EXPECT_EQ(now.practice, (Share{0, 3}));  // one for each level, one force
  EXPECT_EQ(now.force, (Share{0, 5}));     // 0.2 to 1.0 N
  EXPECT_EQ(now.form, (Share{0, 45}));

  ASSERT_TRUE(session_->tell({}));
  stroke();  // practice of the first level
  stroke(experiments::StrokeVerdict::kTooShort);
  stroke();
  now = progress();
  EXPECT_EQ(now.part, SessionPart::kSpeed);
  EXPECT_EQ(now.practice, (Share{1, 3}));
  EXPECT_EQ(now.speed, (Share{1, 4}));

  for (int i = 0; i < 4; ++i) stroke();  // the second one, and the three of the other level
  ASSERT_TRUE(session_->closeBlock());
  judge(Kind::kNoAnswer);  // practice
  judge(Kind::kTerm, "small");
  judge(Kind::kBeyondPractice);  // ends the series after two of its forces
  now = progress();
  EXPECT_EQ(now.practice, (Share{3, 3}));
  EXPECT_EQ(now.force, (Share{2, 2}));
  EXPECT_EQ(now.part, SessionPart::kRating);
  EXPECT_EQ(now.block, Block::kForce);
}

TEST_F(SessionProgressTest, FollowsRepliesThatAreTakenBackAndTheSeal) {
  ASSERT_TRUE(session_->tell({}));
  ASSERT_TRUE(session_->skipBlock("no device"));
  ASSERT_TRUE(session_->skipBlock("no device"));
  ASSERT_TRUE(session_->reply({Status::kAnswered, "small"}, 2));
  ASSERT_TRUE(session_->reply({Status::kCantTell, {}}, 2));
  EXPECT_EQ(progress().form, (Share{2, 45}));
  session_->back();
  ASSERT_TRUE(session_->reply({Status::kCleared, {}}, 2));
  SessionProgress now = progress();
  EXPECT_EQ(now.form, (Share{1, 45}));
  EXPECT_FALSE(now.sealed);
  EXPECT_EQ(now.skipped, (std::set{Block::kSpeed, Block::kForce}));

  for (int i = 0; i < 44; ++i) ASSERT_TRUE(session_->reply({Status::kAnswered, "small"}, 2)) << i;
  ASSERT_TRUE(session_->closeBlock());
  now = progress();
  EXPECT_TRUE(now.sealed);
  EXPECT_EQ(now.part, SessionPart::kFinished);
}

TEST_F(SessionProgressTest, LeavesNoTraceInTheLog) {
  ASSERT_TRUE(session_->note(ownModelVerdict({{}, "oropharynx", {}, {}}, OwnModelVerdict::kHeavier)));
  const auto before = store::events(*file_);
  const SessionProgress now = progress();
  EXPECT_EQ(now.own_model_verdicts, 1);
  EXPECT_EQ(now.last_utc_ms, utc_ms_);
  EXPECT_EQ(store::events(*file_)->size(), before->size());
}

}  // namespace
}  // namespace tactus::session
