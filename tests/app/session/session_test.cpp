// The course of a session: its order, its interruptions, its end.
#include <set>

#include "tests/app/session/session_fixture.h"

namespace tactus::session {
namespace {

using Status = study::Answer::Status;

TEST_F(SessionTest, GoesThroughItsStagesInOrder) {
  begin(start());
  base::Random random(1);
  std::vector<std::string> stages;
  for (int step = 0; session_->part() != SessionPart::kFinished; ++step) {
    ASSERT_LT(step, 300);
    const std::string now(name(session_->part()));
    if (stages.empty() || stages.back() != now) stages.push_back(now);
    ASSERT_NO_FATAL_FAILURE(doNext(random));
  }
  EXPECT_EQ(stages, (std::vector<std::string>{"profile", "speed", "rating", "force", "rating", "form", "rating"}));
  EXPECT_EQ(session_->blocksDone(), 3U);
  EXPECT_FALSE(session_->block());

  const auto events = store::events(*file_);
  ASSERT_TRUE(events);
  std::vector<std::string> entered;
  for (const auto& event : *events) {
    if (event.kind == "stage_entered") entered.push_back(event.detail);
  }
  EXPECT_EQ(entered.size(), 7U);  // each stage but the first, and the end
  EXPECT_EQ(entered.back(), R"({"stage":"finished"})");
}

// The promise: what was acknowledged is there, and the session continues where it stood, in the same order.
TEST_F(SessionTest, GoesOnAfterARestartAtAnyMoment) {
  begin(start());
  base::Random random(2);
  for (int step = 0; session_->part() != SessionPart::kFinished; ++step) {
    ASSERT_LT(step, 300);
    ASSERT_NO_FATAL_FAILURE(doNext(random));
    if (session_->part() == SessionPart::kFinished) break;
    if (random.below(3) != 0) continue;
    const std::string before = shown();
    ASSERT_NO_FATAL_FAILURE(restart());
    EXPECT_EQ(shown(), before) << "after step " << step;
  }
  const auto answers = store::answers(*file_);
  ASSERT_TRUE(answers);
  EXPECT_EQ(answers->size(), 45U);
}

TEST_F(SessionTest, ARestartChangesNothingOfWhatComesNext) {
  const auto run = [&](bool with_restarts) {
    std::vector<std::string> seen;
    base::Random random(3);
    while (session_->part() != SessionPart::kFinished) {
      seen.push_back(shown());
      doNext(random);
      if (with_restarts && seen.size() % 9 == 0) restart();
    }
    return seen;
  };
  begin(start());
  const auto straight = run(false);
  begin(start());
  EXPECT_EQ(run(true), straight);
}

// Six persons take the six orders of three speeds; a rehearsal between them takes none from them, and a session keeps
// its own after a restart.
TEST_F(SessionTest, SessionsTakeTheRowsOfTheLatinSquareInTurn) {
  auto settings = shortSession();
  settings.speed.order = experiments::SpeedSettings::Order::kLatinSquare;
  std::set<std::vector<std::string>> orders;
  for (int i = 0; i < 6; ++i) {
    const study::Person person{ids_.next(), "person-" + std::to_string(i), false};
    const study::Person simulated{ids_.next(), "simulated-" + std::to_string(i), true};
    ASSERT_TRUE(store::append(*file_, person) && store::append(*file_, simulated));
    auto with = start(settings);
    with.person = simulated.id;
    begin(with);
    with.person = person.id;
    begin(with);
    const auto order = session_->speed()->levels();
    restart();
    EXPECT_EQ(session_->speed()->levels(), order);
    orders.insert(order);
  }
  EXPECT_EQ(orders.size(), 6U);
}

TEST_F(SessionTest, NothingBeginsWithoutConsentOrWithNonsense) {
  auto without = start();
  without.consent_version.clear();
  EXPECT_FALSE(Session::begin(*file_, without, steadyTools(1)));
  auto stranger = start();
  stranger.person = ids_.next();
  EXPECT_FALSE(Session::begin(*file_, stranger, steadyTools(1)));
  auto language = start();
  language.language = "xx";
  EXPECT_FALSE(Session::begin(*file_, language, steadyTools(1)));
  auto settings = start();
  settings.settings.blocks = {Block::kForm, Block::kForm};
  EXPECT_FALSE(Session::begin(*file_, settings, steadyTools(1)));
  settings = start();
  settings.settings.speed.strokes = 0;
  EXPECT_FALSE(Session::begin(*file_, settings, steadyTools(1)));
  EXPECT_TRUE(store::sessions(*file_)->empty());  // and nothing is left of the attempts
  EXPECT_FALSE(Session::resume(*file_, ids_.next(), steadyTools(1)));
}

TEST_F(SessionTest, ABeginningThatFailsLeavesNoSession) {
  begin(start());
  ASSERT_TRUE(session_->tell({}));
  // The ids of the first session were 1: itself, 2: its first event, 3: the profile, 4: the event after it. A second
  // one that gets number 3 gives number 4 to its first event, which is there already.
  SessionTools tools = steadyTools(tools_seed_);
  tools.ids.next();
  tools.ids.next();
  const auto refused = Session::begin(*file_, start(), tools);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("there already"), std::string::npos) << refused.error().message();
  EXPECT_EQ(store::sessions(*file_)->size(), 1U);
  begin(start());
  EXPECT_EQ(store::sessions(*file_)->size(), 2U);
}

TEST_F(SessionTest, WhatTheStageDoesNotAskForIsRefused) {
  begin(start());
  EXPECT_FALSE(session_->rate(1, 1));
  EXPECT_FALSE(session_->judge({}));
  EXPECT_FALSE(session_->reply({Status::kAnswered, "medium"}, 1));
  EXPECT_FALSE(session_->addStroke({}, {}, 0));
  EXPECT_FALSE(session_->unpause());
  EXPECT_FALSE(session_->rejectStroke(ids_.next(), "no such"));
  EXPECT_EQ(store::events(*file_)->size(), 1U);  // `began`, and nothing else
}

TEST_F(SessionTest, ABlockCanBeLeftOut) {
  begin(start());
  ASSERT_TRUE(session_->tell({}));
  ASSERT_TRUE(session_->skipBlock("the device is broken"));
  EXPECT_EQ(session_->block(), Block::kForce);
  ASSERT_TRUE(session_->skipBlock("the device is broken"));
  EXPECT_EQ(session_->part(), SessionPart::kForm);
  ASSERT_NO_FATAL_FAILURE(restart());
  EXPECT_EQ(session_->part(), SessionPart::kForm);
  EXPECT_EQ(session_->blocksDone(), 2U);
}

TEST_F(SessionTest, ABlockIsClosedWithoutARatingAndStaysClosed) {
  auto settings = shortSession();
  settings.blocks = {Block::kForce, Block::kForm};
  begin(start(settings));
  EXPECT_FALSE(session_->closeBlock()) << "it is not done";
  base::Random random(3);
  while (session_->part() != SessionPart::kRating) doNext(random);
  ASSERT_TRUE(session_->closeBlock());
  EXPECT_EQ(session_->part(), SessionPart::kForm);
  EXPECT_EQ(session_->blocksDone(), 1U);
  restart();
  EXPECT_EQ(session_->part(), SessionPart::kForm);
  EXPECT_TRUE(store::ratings(*file_, {{}, session_->record().id, true})->empty());
}

TEST_F(SessionTest, PausesAndEndsAreKept) {
  begin(start());
  ASSERT_TRUE(session_->pause("telephone"));
  EXPECT_TRUE(session_->isPaused());
  EXPECT_FALSE(session_->pause("again"));
  ASSERT_NO_FATAL_FAILURE(restart());
  EXPECT_TRUE(session_->isPaused());
  ASSERT_TRUE(session_->unpause());
  ASSERT_TRUE(session_->pause("a reason \xE4 in Latin-1"));  // is stored with U+FFFD in place of the byte
  ASSERT_TRUE(session_->unpause());
  ASSERT_TRUE(session_->abort("fire drill"));
  EXPECT_EQ(session_->part(), SessionPart::kAborted);
  ASSERT_NO_FATAL_FAILURE(restart());
  EXPECT_EQ(session_->part(), SessionPart::kAborted);
  EXPECT_FALSE(session_->tell({}));
  EXPECT_FALSE(session_->skipBlock(""));
  EXPECT_FALSE(session_->abort(""));
}

TEST_F(SessionTest, UsabilityIsASessionOfItsOwn) {
  auto with = start(usabilitySession());
  with.kind = study::SessionKind::kUsability;
  begin(with);
  ASSERT_TRUE(session_->tell({}));
  EXPECT_EQ(session_->part(), SessionPart::kForm);
  EXPECT_EQ(session_->speed(), nullptr);
  EXPECT_EQ(session_->force(), nullptr);
  for (int item = 0; item < 6; ++item) ASSERT_TRUE(session_->reply({Status::kAnswered, "6"}, 1));
  EXPECT_FALSE(session_->reply({Status::kAnswered, "6"}, 1));
  session_->back();  // before the rating an answer can be changed
  EXPECT_EQ(session_->part(), SessionPart::kForm);
  ASSERT_TRUE(session_->reply({Status::kAnswered, "7"}, 1));
  EXPECT_FALSE(session_->rate(0, 4));
  EXPECT_FALSE(session_->rate(4, 8));
  ASSERT_TRUE(session_->rate(1, 7));
  EXPECT_EQ(session_->part(), SessionPart::kFinished);
}

TEST_F(SessionTest, RecordsOfASimulatedPersonSaySo) {
  const study::Person nurse{ids_.next(), "copper-finch", true};
  ASSERT_TRUE(store::append(*file_, nurse));
  auto with = start();
  with.person = nurse.id;
  begin(with);
  ASSERT_TRUE(session_->tell({}));
  EXPECT_EQ(store::profiles(*file_)->back().entry.entered_by, study::EnteredBy::kProgram);
}

// Every step comes once and is stored; the session ends, and nothing of it counts.
TEST_F(SessionTest, OnADeviceWithoutForceNothingIsScored) {
  for (const bool accepted : {false, true}) {
    SCOPED_TRACE(accepted);
    auto with = start();
    with.device = "virtual";
    with.settings.blocks = {Block::kSpeed, Block::kForce};
    with.settings.virtual_strokes = accepted ? VirtualStrokes::kAccepted : VirtualStrokes::kPractice;
    begin(with);
    base::Random random(3);
    for (int step = 0; step < 300 && session_->part() != SessionPart::kFinished; ++step) {
      doNext(random);
      if (step % 9 == 0) restart();
    }
    ASSERT_EQ(session_->part(), SessionPart::kFinished);
    const store::Selection own{{}, session_->record().id, true};
    const auto judgements = store::judgements(*file_, own).value();
    EXPECT_GT(judgements.size(), 5U);
    for (const auto& one : judgements) {
      EXPECT_FALSE(one.scored);
      EXPECT_EQ(one.delivered_share, 0);
      EXPECT_FALSE(one.felt_n);
      EXPECT_EQ(one.attempt, 1);
    }
    const auto strokes = store::strokes(*file_, own, store::Recordings::kLeaveOut).value();
    EXPECT_GT(strokes.size(), 5U);
    EXPECT_EQ(std::all_of(strokes.begin(), strokes.end(), [](const auto& one) { return one.practice; }), !accepted);
  }
}

}  // namespace
}  // namespace tactus::session
