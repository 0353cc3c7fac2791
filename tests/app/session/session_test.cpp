#include "app/session/session.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <utility>

#include "core/base/random.h"
#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"

#include "tests/support/temp_folder.h"

namespace tactus::session {
namespace {

using experiments::ForceAnswer;
using Kind = study::ForceJudgement::Kind;
using Status = study::Answer::Status;

/// A session short enough to try every moment of it.
SessionSettings shortSession() {
  SessionSettings settings;
  settings.speed.strokes = 2;
  settings.speed.order = experiments::SpeedSettings::Order::kShuffled;
  settings.force.descending = true;
  settings.item_order = questionnaires::ItemOrder::kShuffled;
  return settings;
}

/// Time that advances by 7 ms with each look.
SessionTools steadyTools(std::uint64_t seed) {
  return {[moment = study::Moment{1'700'000'000'000, 0}]() mutable {
            moment.utc_ms += 7;
            moment.monotonic_ns += 7'000'000;
            return moment;
          },
          study::RecordIds(seed)};
}

/// A study with one person, and a person who does whatever the session asks for.
class SessionTest : public testing::Test {
 protected:
  void SetUp() override {
    auto created = store::StudyFile::create(path_, {ids_.next(), "test", 1, "test"});
    ASSERT_TRUE(created) << created.error().message();
    file_.emplace(*std::move(created));
    person_ = {ids_.next(), "amber-otter", false};
    ASSERT_TRUE(store::append(*file_, person_));
  }

  SessionStart start(SessionSettings settings = shortSession()) {
    SessionStart start;
    start.person = person_.id;
    start.consent_version = "2026-1";
    start.seed = 11;
    start.program = "test";
    start.settings = std::move(settings);
    return start;
  }

  void begin(const SessionStart& with) {
    auto begun = Session::begin(*file_, with, steadyTools(++tools_seed_));
    ASSERT_TRUE(begun) << begun.error().message();
    session_.emplace(*std::move(begun));
  }

  /// As after a crash: the file is closed and opened, the session read back.
  void restart() {
    const auto id = session_->record().id;
    session_.reset();
    file_.reset();
    auto file = store::StudyFile::open(path_);
    ASSERT_TRUE(file) << file.error().message();
    file_.emplace(*std::move(file));
    auto again = Session::resume(*file_, id, steadyTools(++tools_seed_));
    ASSERT_TRUE(again) << again.error().message();
    session_.emplace(*std::move(again));
  }

  /// Does what the session asks for next, not always well.
  void doNext(base::Random& random) {
    base::Result<void> done;
    switch (session_->part()) {
      case SessionPart::kProfile: {
        study::ProfileRecord profile;
        profile.years_experience = 12;
        profile.category = "expert";
        done = session_->tell(profile);
        break;
      }
      case SessionPart::kSpeed: {
        experiments::Stroke stroke{2, 8, 0.002, 0.007, 0, 60, experiments::StrokeVerdict::kAccepted};
        if (random.below(4) == 0) stroke.verdict = experiments::StrokeVerdict::kTooShort;
        study::Recording recording{1000, {{"depth", "mm", {0, 0, 5, 15, 30, 45, 55, 60, 60, 60}}}};
        done = session_->addStroke(stroke, recording, 0);
        break;
      }
      case SessionPart::kForce: {
        ForceAnswer answer;
        answer.forward_mm = random.below(5) == 0 ? 0 : 40;
        answer.forward_speed_mm_s = 60;
        answer.response_s = 1.5;
        answer.delivered = random.below(6) != 0;
        const auto plan = session_->force()->next();
        if (!plan.question.answers.empty()) {
          const bool enough = plan.step.force_n > 0.55;
          answer.kind = enough ? Kind::kBeyondPractice : Kind::kTerm;
          if (!enough) answer.term = "small";
        }
        done = session_->judge(answer);
        break;
      }
      case SessionPart::kForm: {
        const int which = random.below(10);
        if (which == 0) {
          done = session_->reply({Status::kSkipped, {}}, 2);
        } else if (which == 1) {
          done = session_->reply({Status::kCantTell, {}}, 2);
        } else {
          done = session_->reply({Status::kAnswered, "medium"}, 2);
        }
        break;
      }
      case SessionPart::kRating:
        done = session_->rate(2, 6);
        break;
      case SessionPart::kFinished:
      case SessionPart::kAborted:
        FAIL() << "nothing is left to do";
    }
    ASSERT_TRUE(done) << done.error().message();
  }

  /// Everything that a screen would show.
  std::string shown() const {
    std::string text(name(session_->part()));
    text += ' ' + std::to_string(session_->blocksDone());
    if (session_->part() == SessionPart::kSpeed) {
      const auto plan = session_->speed()->next();
      text += ' ' + plan.level + ' ' + std::to_string(plan.number) + ' ' + std::to_string(plan.attempt) +
              (plan.repeat_reason.empty() ? "" : " again");
    }
    if (session_->part() == SessionPart::kForce) {
      const auto plan = session_->force()->next();
      text += ' ' + plan.step.series + ' ' + std::to_string(plan.step.step) + ' ' + std::to_string(plan.attempt) + ' ' +
              std::to_string(plan.step.force_n);
    }
    if (session_->part() == SessionPart::kForm) {
      text += ' ' + std::to_string(session_->form()->page()->question->number) + ' ' +
              std::to_string(session_->form()->page()->position);
    }
    return text;
  }

  support::TempFolder folder_;
  std::string path_ = folder_.file("study.tactus");
  study::RecordIds ids_{99};
  study::Person person_;
  std::optional<store::StudyFile> file_;
  std::optional<Session> session_;
  std::uint64_t tools_seed_ = 100;
};

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

TEST_F(SessionTest, AProfileIsCorrectedByAFurtherRecord) {
  begin(start());
  study::ProfileRecord profile;
  profile.years_experience = 3;
  ASSERT_TRUE(session_->tell(profile));
  profile.years_experience = 13;
  session_->setEnteredBy(study::EnteredBy::kResearcher);
  ASSERT_TRUE(session_->tell(profile));
  ASSERT_NE(session_->profile(), nullptr);
  EXPECT_EQ(session_->profile()->years_experience, 13);
  EXPECT_EQ(session_->part(), SessionPart::kSpeed);
  EXPECT_EQ(store::profiles(*file_)->size(), 1U);
  const auto history = store::profiles(*file_, {{}, {}, true});
  ASSERT_EQ(history->size(), 2U);
  EXPECT_EQ(history->at(0).entry.entered_by, study::EnteredBy::kParticipant);
  EXPECT_EQ(history->at(1).entry.entered_by, study::EnteredBy::kResearcher);
}

TEST_F(SessionTest, ABandOfYearsIsKeptBesideItsMiddle) {
  begin(start());
  study::ProfileRecord profile;
  profile.comfort = "good";
  ASSERT_TRUE(session_->tell(profile, *experienceBandCalled("years_3")));
  EXPECT_EQ(session_->profile()->years_experience, 12.5);
  EXPECT_EQ(store::profiles(*file_)->front().comfort, "good");
  const auto events = store::events(*file_);
  EXPECT_TRUE(std::any_of(events->begin(), events->end(), [](const study::EventRecord& event) {
    return event.kind == "experience_band" && event.detail.find("years_3") != std::string::npos;
  }));
}

TEST_F(SessionTest, HowAnAnswerWasEnteredIsStoredWithIt) {
  begin(start());
  ASSERT_TRUE(session_->tell({}));
  ASSERT_TRUE(session_->skipBlock("short"));
  ForceAnswer answer;
  answer.forward_mm = 40;
  answer.forward_speed_mm_s = 60;
  answer.delivered_share = 1;
  while (session_->force()->next().step.series == "familiarisation") ASSERT_TRUE(session_->judge(answer));
  answer.kind = Kind::kTerm;
  answer.term = "small";
  answer.response_s = 1.2;
  const AnswerInput input{InputMeans::kDeviceButton, "large", 4};
  ASSERT_TRUE(session_->judge(answer, input));
  EXPECT_FALSE(session_->judge(answer, AnswerInput{InputMeans::kTouch, "large", 4}));
  const auto judged = store::judgements(*file_)->back();
  EXPECT_EQ(judged.delivered_share, 1);
  const auto events = store::events(*file_);
  const auto line = answerInputIn(events->back());
  ASSERT_TRUE(line && *line) << events->back().kind;
  EXPECT_EQ((*line)->record, judged.entry.id);
  EXPECT_EQ((*line)->input, input);
  const std::string before = shown();
  ASSERT_NO_FATAL_FAILURE(restart());
  EXPECT_EQ(shown(), before);
}

TEST_F(SessionTest, ACorrectedJudgementIsARecordOfItsOwnAndCountsInstead) {
  auto with = start();
  with.settings.blocks = {Block::kForce};
  with.settings.force.familiarisation_n = {};
  with.settings.force.ladder = {0.2, 0.4, 0.2};
  with.settings.force.descending = false;
  begin(with);
  ASSERT_TRUE(session_->tell({}));
  EXPECT_FALSE(session_->correctJudgement(Kind::kTerm, "small")) << "nothing was judged";
  ForceAnswer answer;
  answer.forward_mm = 40;
  answer.forward_speed_mm_s = 60;
  answer.response_s = 2;
  answer.kind = Kind::kBeyondPractice;
  ASSERT_TRUE(session_->judge(answer));
  EXPECT_EQ(session_->part(), SessionPart::kRating) << "beyond practice ends the ascending series";
  EXPECT_FALSE(session_->correctJudgement(Kind::kTerm, "no_such_term"));
  // A slip: she meant a word, so the series continues.
  ASSERT_TRUE(session_->correctJudgement(Kind::kTerm, "small", AnswerInput{InputMeans::kMouse, "", 0}));
  EXPECT_EQ(session_->part(), SessionPart::kForce);
  ASSERT_TRUE(session_->correctJudgement(Kind::kTerm, "medium"));
  const auto now = *store::judgements(*file_);
  ASSERT_EQ(now.size(), 1U);
  EXPECT_EQ(now[0].term, "medium");
  EXPECT_EQ(now[0].forward_mm, 40);
  EXPECT_EQ(now[0].response_s, 2);
  EXPECT_TRUE(now[0].scored);
  const auto all = *store::judgements(*file_, {{}, {}, true});
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].kind, Kind::kBeyondPractice);
  EXPECT_EQ(all[1].entry.supersedes, all[0].entry.id);
  EXPECT_EQ(all[2].entry.supersedes, all[1].entry.id);
  const std::string before = shown();
  ASSERT_NO_FATAL_FAILURE(restart());
  EXPECT_EQ(shown(), before);
  EXPECT_EQ(session_->force()->next().step.force_n, 0.4);
}

TEST_F(SessionTest, AnAnswerThatCameVerySoonOrVeryLateIsMarkedAndCounts) {
  auto with = start();
  with.settings.blocks = {Block::kForm};
  begin(with);
  ASSERT_TRUE(session_->tell({}));
  for (const double response_s : {0.29, 0.3, 30.0, 30.1}) {
    ASSERT_TRUE(session_->reply({Status::kAnswered, "medium"}, response_s));
  }
  const auto answers = *store::answers(*file_);
  ASSERT_EQ(answers.size(), 4U);
  std::vector<std::pair<study::RecordId, ResponseMark>> marked;
  const auto events = *store::events(*file_);
  for (const auto& event : events) {
    if (const auto line = *responseMarkIn(event)) marked.emplace_back(line->record, line->mark);
  }
  const std::vector<std::pair<study::RecordId, ResponseMark>> wanted = {{answers[0].entry.id, ResponseMark::kSoon},
                                                                        {answers[3].entry.id, ResponseMark::kLate}};
  EXPECT_EQ(marked, wanted);
}

TEST_F(SessionTest, NotesGoToTheLogAndSteerNothing) {
  begin(start());
  ASSERT_TRUE(session_->note(languageChosen("zh-Hant")));
  ASSERT_TRUE(session_->note({kForceOff, {}}));
  EXPECT_FALSE(session_->note({"aborted", {}}));
  EXPECT_FALSE(session_->note({"", {}}));
  EXPECT_FALSE(session_->note({"odd", "no JSON"}));
  EXPECT_EQ(session_->part(), SessionPart::kProfile);
  EXPECT_EQ(store::events(*file_)->size(), 3U);
  ASSERT_TRUE(session_->abort("stop"));
  EXPECT_TRUE(session_->note(researcherNote("felt dizzy"))) << "also after the end";
}

TEST_F(SessionTest, AStrokeTakenBackIsAskedForAgain) {
  auto settings = shortSession();
  settings.speed.practice = 0;
  begin(start(settings));
  base::Random random(4);
  ASSERT_NO_FATAL_FAILURE(doNext(random));
  while (session_->speed()->next().accepted < 2) ASSERT_NO_FATAL_FAILURE(doNext(random));
  const auto strokes = store::strokes(*file_);
  ASSERT_TRUE(strokes);
  const auto& last = strokes->back();
  ASSERT_TRUE(session_->rejectStroke(last.entry.id, "coughed"));
  EXPECT_EQ(session_->speed()->next().accepted, 1);
  EXPECT_EQ(session_->speed()->next().number, last.number);
  const std::string before = shown();
  ASSERT_NO_FATAL_FAILURE(restart());
  EXPECT_EQ(shown(), before);
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

TEST(SessionSettings, ComeBackAsTheyWere) {
  SessionSettings settings = shortSession();
  settings.blocks = {Block::kForm, Block::kSpeed};
  settings.speed.levels = {"slow", "fast"};
  settings.speed.stroke.shortest_mm = 12.25;
  settings.force.familiarisation_n = {0.1, 0.7};
  settings.force.device_friction_n = 0.26;
  settings.force.random_steps.highest_n = 0.9;
  settings.form = "usability-v1";
  const auto back = parseSessionSettings(toJson(settings));
  ASSERT_TRUE(back) << back.error().message();
  EXPECT_EQ(toJson(*back), toJson(settings));
  EXPECT_EQ(back->blocks, settings.blocks);
  EXPECT_EQ(back->speed.stroke.shortest_mm, 12.25);
  EXPECT_EQ(back->force.device_friction_n, 0.26);
}

TEST(SessionSettings, WhatIsMissingKeepsItsDefault) {
  const auto read = parseSessionSettings(R"({"speed": {"strokes": 7}})");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->speed.strokes, 7);
  EXPECT_EQ(read->speed.practice, experiments::SpeedSettings{}.practice);
  EXPECT_EQ(read->blocks, SessionSettings{}.blocks);
}

TEST(SessionSettings, WhatDoesNotFitIsRefusedWithItsPlace) {
  const auto refused = [](std::string_view text, std::string_view place) {
    const auto read = parseSessionSettings(text);
    ASSERT_FALSE(read) << text;
    EXPECT_EQ(read.error().place, place) << read.error().message();
  };
  refused("[]", "");
  refused(R"({"speed": 3})", "/speed");
  refused(R"({"speed": {"strokes": "four"}})", "/speed/strokes");
  refused(R"({"speed": {"levels": ["slow", 2]}})", "/speed/levels/1");
  refused(R"({"speed": {"order": "random"}})", "/speed/order");
  refused(R"({"force": {"random_steps": {"lowest_n": null}}})", "/force/random_steps/lowest_n");
  refused(R"({"blocks": ["speed", "dance"]})", "/blocks");
  refused(R"({"force": {"ascending": 1}})", "/force/ascending");
}

TEST(BlockSeed, IsAnotherForEachBlock) {
  EXPECT_NE(blockSeed(1, Block::kSpeed), blockSeed(1, Block::kForce));
  EXPECT_NE(blockSeed(1, Block::kSpeed), blockSeed(2, Block::kSpeed));
  EXPECT_EQ(blockSeed(1, Block::kForm), blockSeed(1, Block::kForm));
}

}  // namespace
}  // namespace tactus::session
