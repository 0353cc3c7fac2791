#include "app/session/simulated_nurse.h"

#include <gtest/gtest.h>

#include "app/session/simulated_study.h"
#include "core/store/batch.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "questionnaires/form_file.h"

#include "tests/support/default_procedure.h"
#include "tests/support/temp_folder.h"

namespace tactus::session {
namespace {

using Status = study::Answer::Status;

/// A nurse with one speed and four noisy thresholds, to whom everything happens that can.
NurseTraits clumsyNurse() {
  NurseTraits nurse;
  nurse.profile.category = "expert";
  static const SimulatedLevel kLevel = simulatedLevel({"A", "medium", 106, 25}, 1);
  nurse.levels["medium"] = kLevel;
  nurse.responder = {"A", {0.2, 0.4, 0.6, 0.8}};
  nurse.responder.beyond_from_n = 0.9;
  nurse.responder.assimilation = 0.1;
  const auto form = support::ngtForceForm();
  for (const auto& item : form.items) {
    if (item.number % 7 == 0) continue;  // skipped
    const bool cant_tell = item.number % 5 == 0;
    nurse.answers.push_back({"A", "ngt-force-v1", item.number, cant_tell ? "" : "medium",
                             cant_tell ? Status::kCantTell : Status::kAnswered});
  }
  nurse.stops_early = 0.5;
  nurse.holds_still = 0.5;
  nurse.second_thoughts = 0.5;
  return nurse;
}

class SimulatedNurseTest : public testing::Test {
 protected:
  void SetUp() override {
    auto created = store::StudyFile::create(folder_.file("a.tactus"), {ids_.next(), "test", 1, "test"});
    ASSERT_TRUE(created) << created.error().message();
    file_.emplace(*std::move(created));
    person_ = {ids_.next(), "A", true};
    ASSERT_TRUE(store::append(*file_, person_));
  }

  Session begin() {
    SessionStart start;
    start.person = person_.id;
    start.consent_version = "simulated";
    start.seed = 5;
    start.settings.speed.levels = {"medium"};
    start.settings.item_order = questionnaires::ItemOrder::kShuffled;
    auto session = Session::begin(*file_, start, clock_.tools(++tools_seed_));
    EXPECT_TRUE(session) << session.error().message();
    return *std::move(session);
  }

  support::TempFolder folder_;
  study::RecordIds ids_{1};
  std::optional<store::StudyFile> file_;
  study::Person person_;
  SimulatedClock clock_{1'700'000'000'000};
  std::uint64_t tools_seed_ = 10;
};

TEST_F(SimulatedNurseTest, DoesAllThatASessionAsksFor) {
  auto batch = store::Batch::begin(*file_);
  auto session = begin();
  SimulatedNurse nurse(clumsyNurse(), 7, [this](double seconds) { clock_.pass(seconds); });
  const auto done = nurse.finish(session);
  ASSERT_TRUE(done) << done.error().message();
  EXPECT_EQ(session.part(), SessionPart::kFinished);
  EXPECT_FALSE(nurse.doNext(session));

  int accepted = 0, too_short = 0;
  const auto strokes = store::strokes(*file_).value();
  for (const auto& stroke : strokes) {
    accepted += stroke.verdict == "accepted" ? 1 : 0;
    too_short += stroke.verdict == "too_short" ? 1 : 0;
    EXPECT_EQ(stroke.entry.entered_by, study::EnteredBy::kProgram);
  }
  EXPECT_EQ(accepted, 5);  // one for practice
  EXPECT_GT(too_short, 0);
  int still = 0;
  const auto judgements = store::judgements(*file_).value();
  for (const auto& judgement : judgements) {
    const bool moved = judgement.forward_mm >= 10;
    still += moved ? 0 : 1;
    if (!moved) {
      EXPECT_LT(judgement.forward_mm, 1);
    }
    if (judgement.series == "ascending") {
      EXPECT_EQ(judgement.scored, moved) << judgement.step;
    }
  }
  EXPECT_GT(still, 0);
}

TEST_F(SimulatedNurseTest, EndsWithTheAnswersItMeantToGive) {
  auto batch = store::Batch::begin(*file_);
  auto session = begin();
  SimulatedNurse nurse(clumsyNurse(), 7);
  ASSERT_TRUE(nurse.finish(session));
  const auto meant = clumsyNurse().answers;
  std::size_t given = 0;
  const auto answers = store::answers(*file_).value();
  for (const auto& answer : answers) {
    const auto it = std::find_if(meant.begin(), meant.end(), [&](const auto& one) { return one.item == answer.item; });
    EXPECT_EQ(answer.status, it == meant.end() ? Status::kSkipped : it->status) << answer.item;
    EXPECT_EQ(answer.value, it == meant.end() ? "" : it->term) << answer.item;
    ++given;
  }
  EXPECT_EQ(given, 45U);
  EXPECT_GT(store::answers(*file_, {{}, {}, true})->size(), 50U);  // half of about 30 were another choice at first
}

// What is done depends on the step, not on what the program remembers.
TEST_F(SimulatedNurseTest, GoesOnAfterARestartAsItWouldHave) {
  auto batch = store::Batch::begin(*file_);
  auto straight = begin();
  SimulatedNurse nurse(clumsyNurse(), 7);
  ASSERT_TRUE(nurse.finish(straight));

  auto session = begin();
  const auto id = session.record().id;
  for (int step = 0; session.part() != SessionPart::kFinished; ++step) {
    ASSERT_LT(step, 300);
    if (step % 5 == 4) session = *Session::resume(*file_, id, clock_.tools(++tools_seed_));
    const auto judged = store::judgements(*file_, {{}, id, true});
    SimulatedNurse fresh(clumsyNurse(), 7, {}, *judged);
    const auto done = fresh.doNext(session);
    ASSERT_TRUE(done) << done.error().message();
  }
  const auto same = [](auto one, auto other) {
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      one[i].entry = {};
      other[i].entry = {};
      EXPECT_EQ(one[i], other[i]) << i;
    }
  };
  const store::Selection first{{}, straight.record().id, true};
  const store::Selection second{{}, id, true};
  same(store::strokes(*file_, first).value(), store::strokes(*file_, second).value());
  same(store::judgements(*file_, first).value(), store::judgements(*file_, second).value());
  same(store::answers(*file_, first).value(), store::answers(*file_, second).value());
  same(store::ratings(*file_, first).value(), store::ratings(*file_, second).value());
}

TEST_F(SimulatedNurseTest, ASpeedWithoutStrokesIsRefused) {
  auto session = begin();
  auto traits = clumsyNurse();
  traits.levels.clear();
  SimulatedNurse nurse(traits, 7);
  ASSERT_TRUE(nurse.doNext(session));  // the profile
  EXPECT_FALSE(nurse.doNext(session));
  EXPECT_TRUE(store::strokes(*file_)->empty());
}

}  // namespace
}  // namespace tactus::session
