// Whole sessions: begun, left, continued, withdrawn.
#include <algorithm>
#include <atomic>
#include <gtest/gtest.h>
#include <memory>

#include "core/store/model_versions.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"

#include "tests/gui/participant/course_test.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;
using Screen = ParticipantScreen;

using ParticipantControllerTest = CourseTest;

TEST_F(ParticipantControllerTest, AWholeSessionIsInTheFile) {
  EXPECT_EQ(screen(), Screen::kWelcome);
  consent();
  tellAboutHerself();
  EXPECT_TRUE(at().left_handed);
  checkDevice();
  doSpeed();
  doForce();
  ASSERT_EQ(screen(), Screen::kGlossary);
  next();
  int rests = 0;
  for (int question = 0; question < 45; ++question) {
    if (screen() == Screen::kRest) {
      ++rests;
      EXPECT_EQ(at().question.position % 15, 0);
      next();
    }
    ASSERT_EQ(screen(), Screen::kQuestion) << question;
    EXPECT_TRUE(at().question.chosen.isEmpty()) << "nothing is preselected";
    EXPECT_FALSE(at().can_go_on);
    answer(question % 7 == 0 ? "cant_tell" : "medium");
  }
  EXPECT_EQ(rests, 2);
  ASSERT_EQ(screen(), Screen::kReview);
  EXPECT_EQ(at().review.answers.size(), 45U);
  EXPECT_EQ(at().review.gaps, 0);
  EXPECT_FALSE(at().review.sealed);
  next();
  ASSERT_NO_FATAL_FAILURE(rate());
  ASSERT_EQ(screen(), Screen::kReview);
  EXPECT_TRUE(at().review.sealed) << "and she is told";
  next();
  ASSERT_EQ(screen(), Screen::kOwnModel);
  ASSERT_TRUE(comesTrue([this] { return at().own.ready || !at().own.unavailable.isEmpty(); }));
  ASSERT_TRUE(at().own.ready) << at().own.unavailable.toStdString();
  const int regions = at().own.count;
  EXPECT_GE(regions, 5);
  for (int region = 1; region <= regions; ++region) {
    ASSERT_EQ(at().own.number, region);
    look();
    if (region == 2) nurse->mark();
    if (region == 3) tapButton();
    choose("lighter");
    EXPECT_FALSE(at().can_go_on) << "before it was felt";
    pushOwnModel();
    answer(region == 1 ? "lighter" : "right");
  }
  ASSERT_EQ(screen(), Screen::kThanks);
  EXPECT_GT(at().thanks.curve.size(), 100U);
  EXPECT_EQ(device->state(), DeviceSession::State::kStopped);
  EXPECT_TRUE(refused.isEmpty()) << refused.toStdString();
  next();
  EXPECT_EQ(screen(), Screen::kWelcome);
  EXPECT_TRUE(at().code.isEmpty()) << "the next person does not land in her session";
  getUp();

  const auto file = tests::lookInto(path);
  EXPECT_TRUE(store::checkStudy(file)->empty());
  const store::Selection all{{}, {}, true};
  const auto strokes = *store::strokes(file, all, store::Recordings::kLeaveOut);
  ASSERT_EQ(strokes.size(), 3U);
  EXPECT_TRUE(strokes[0].practice);
  EXPECT_EQ(strokes[2].verdict, "accepted");
  const auto judgements = *store::judgements(file, all);
  ASSERT_EQ(judgements.size(), 3U);
  EXPECT_EQ(judgements[1].term, "small");
  EXPECT_TRUE(judgements[1].scored);
  EXPECT_EQ(judgements[2].commanded_n, 0.4);
  EXPECT_GE(judgements[2].delivered_share.value_or(0), experiments::kLeastShare);
  EXPECT_EQ(store::answers(file, all)->size(), 45U);
  EXPECT_EQ((*store::profiles(file))[0].years_experience, 12.5);
  const auto ratings = *store::ratings(file);
  ASSERT_EQ(ratings.size(), 3U);
  EXPECT_EQ(ratings[1].block, "force");
  EXPECT_EQ(ratings[1].effort, 2);
  EXPECT_EQ(ratings[1].comfort, 6);
  const auto versions = *store::modelVersions(file);
  ASSERT_EQ(versions.size(), 1U);
  EXPECT_EQ(versions[0].label, session::kOwnModelLabel);
  int verdicts = 0;
  int marks = 0;
  const auto events = *store::events(file, all);
  for (const auto& event : events) {
    const auto line = *session::ownModelIn(event);
    if (!line) continue;
    EXPECT_FALSE(line->place.region.empty());
    EXPECT_EQ(line->place.model_version, versions[0].id);
    ++(line->verdict ? verdicts : marks);
  }
  EXPECT_EQ(verdicts, regions);
  EXPECT_EQ(marks, 2);
  // Felt with the head up, as the picture beside it shows: the middle of what is fully small, 0 to 15. Medium
  // lubrication is fully so from 0.4 to 0.6.
  const auto own = ownModel(file, versions[0].author);
  ASSERT_TRUE(own.has_value());
  EXPECT_EQ(own->conditions, (haptics::Conditions{{"lubrication", 0.5}, {"neck_flexion", 7.5}}));
}

TEST_F(ParticipantControllerTest, StoppedForTodayShePicksUpWhereSheWas) {
  beginQuestions();
  answer("small");
  answer("large");
  const QString code = at().code;
  nurse->forceOff();
  look();
  nurse->callResearcher();
  EXPECT_EQ(at().overlay, ForceOffOverlay::kCalled);
  look();
  nurse->stopForToday();
  ASSERT_TRUE(comesTrue([this] { return screen() == Screen::kStopped; }));
  EXPECT_EQ(at().stop, StopReason::kForToday);
  EXPECT_EQ(at().code, code);
  getUp();

  sitDown(time);
  look();
  nurse->enterCode(QStringLiteral("no-such"));
  ASSERT_TRUE(comesTrue([this] { return at().welcome.code_unknown; }));
  EXPECT_TRUE(at().welcome.meant.isEmpty()) << "far from every code of the study";
  nurse->enterCode(code.chopped(1));
  ASSERT_TRUE(comesTrue([&] { return at().welcome.meant == code; })) << "one letter is missing";
  QString typed = code;
  nurse->enterCode(typed.replace(QLatin1Char('-'), QLatin1Char(' ')).toUpper());
  ASSERT_TRUE(comesTrue([&] { return at().code == code; }));
  EXPECT_EQ(at().welcome.step, WelcomeState::Step::kWelcomeBack);
  EXPECT_EQ(at().welcome.kept_answers, 2);
  next();
  ASSERT_TRUE(stored());
  ASSERT_EQ(screen(), Screen::kGlossary);
  EXPECT_FALSE(at().paused);
  next();
  EXPECT_EQ(screen(), Screen::kQuestion);
  EXPECT_EQ(at().question.position, 3);
}

// As after a crash: nothing but the file is left.
TEST_F(ParticipantControllerTest, ItGoesOnAtTheRightPlaceAfterEachScreen) {
  const auto come_back = [this](const QString& code) {
    getUp();
    sitDown(time);
    look();
    nurse->enterCode(code);
    ASSERT_TRUE(comesTrue([&] { return at().code == code; }));
    look();
    nurse->next();
    EXPECT_EQ(screen(), Screen::kWelcome) << "until the session is read, and no consent in between";
    ASSERT_TRUE(stored());
  };
  consent();
  const QString code = at().code;
  come_back(code);
  ASSERT_EQ(screen(), Screen::kAboutYou);
  tellAboutHerself();
  come_back(code);
  checkDevice();
  ASSERT_EQ(screen(), Screen::kPractice);
  insert();
  insert();
  EXPECT_EQ(at().speed.recorded, 1);
  come_back(code);
  checkDevice();
  ASSERT_EQ(screen(), Screen::kSpeed);
  EXPECT_EQ(at().speed.recorded, 1);
  insert();
  come_back(code);
  ASSERT_NO_FATAL_FAILURE(rate());
  come_back(code);
  checkDevice();
  ASSERT_TRUE(at().feels_force);
  judge("medium");
  next();
  judge("small");
  come_back(code);
  checkDevice();
  ASSERT_EQ(screen(), Screen::kForce);
  judge("large");
  ASSERT_EQ(screen(), Screen::kRating);
  choose("not_say");
  next();
  ASSERT_EQ(screen(), Screen::kRest) << "who does not say the effort is not asked for the comfort";
  next();
  ASSERT_EQ(screen(), Screen::kGlossary);
  next();
  answer("small");
  come_back(code);
  ASSERT_EQ(screen(), Screen::kGlossary);
  next();
  EXPECT_EQ(at().question.position, 2);
  EXPECT_TRUE(refused.isEmpty()) << refused.toStdString();
  getUp();
  EXPECT_EQ(judgementsInFile().size(), 3U);
  EXPECT_EQ(answersInFile().size(), 1U);
}

TEST_F(ParticipantControllerTest, ThePartsComeInTheOrderOfTheProtocol) {
  plan.settings.blocks = {session::Block::kForce, session::Block::kSpeed};
  getUp();
  sitDown(time);
  consent();
  tellAboutHerself();
  checkDevice();
  ASSERT_EQ(screen(), Screen::kPractice);
  EXPECT_TRUE(at().feels_force);
  judge("medium");
  ASSERT_TRUE(beginsToCount());
  next();
  ASSERT_EQ(screen(), Screen::kForce);
  EXPECT_EQ(at().part, 1);
  EXPECT_EQ(at().parts, 2);
  judge("small");
  judge("large");
  ASSERT_NO_FATAL_FAILURE(rate());
  ASSERT_EQ(screen(), Screen::kRest);
  next();
  ASSERT_EQ(screen(), Screen::kPractice);
  EXPECT_FALSE(at().feels_force);
  insert();
  ASSERT_EQ(screen(), Screen::kSpeed);
  EXPECT_EQ(at().part, 2);
}

TEST_F(ParticipantControllerTest, WithdrawingDeletesEverything) {
  beginQuestions();
  answer("small");
  nurse->forceOff();
  look();
  nurse->askWithdraw();
  EXPECT_EQ(at().overlay, ForceOffOverlay::kWithdraw);
  look();
  nurse->keepData();
  EXPECT_EQ(at().overlay, ForceOffOverlay::kForceOff);
  look();
  nurse->askWithdraw();
  look();
  nurse->withdraw();
  ASSERT_TRUE(comesTrue([this] { return screen() == Screen::kStopped; }));
  EXPECT_EQ(at().stop, StopReason::kWithdrawn);
  getUp();
  EXPECT_TRUE(answersInFile().empty());
  EXPECT_TRUE(store::persons(tests::lookInto(path))->empty());
}

TEST_F(ParticipantControllerTest, WithoutConsentNothingIsStored) {
  newHere();
  next();
  look();
  nurse->decline();
  EXPECT_EQ(screen(), Screen::kStopped);
  EXPECT_EQ(at().stop, StopReason::kNoConsent);
  next();
  EXPECT_EQ(screen(), Screen::kWelcome);
  getUp();
  EXPECT_TRUE(store::persons(tests::lookInto(path))->empty());
}

TEST_F(ParticipantControllerTest, ATeacherAnswersTheUsabilityFormInASessionOfItsOwn) {
  look();
  nurse->teacherHere();
  ASSERT_TRUE(comesTrue([this] { return !at().code.isEmpty(); }));
  const QString code = at().code;
  next();
  ASSERT_EQ(screen(), Screen::kConsent);
  EXPECT_TRUE(at().consent.usability);
  next();
  for (int item = 1; item <= 4; ++item) {
    ASSERT_EQ(screen(), Screen::kScale) << refused.toStdString();
    EXPECT_EQ(at().page.sentence.id, QStringLiteral("u.%1").arg(item));
    EXPECT_EQ(at().page.title.values.front(), QString::number(item));
    EXPECT_TRUE(at().page.chosen.isEmpty());
    EXPECT_FALSE(at().can_go_on);
    choose("8");
    EXPECT_TRUE(at().page.chosen.isEmpty()) << "there are seven points";
    answer(std::to_string(item).c_str());
  }
  look();
  nurse->back();
  ASSERT_TRUE(stored());
  EXPECT_EQ(at().page.chosen, QStringLiteral("4"));
  answer("7");
  // The program ends; she goes on with her code.
  getUp();
  sitDown(time);
  look();
  nurse->enterCode(code);
  ASSERT_TRUE(comesTrue([&] { return at().code == code; }));
  next();
  ASSERT_TRUE(stored());
  ASSERT_EQ(screen(), Screen::kScale);
  EXPECT_EQ(at().page.title.values.front(), QStringLiteral("5"));
  answer("5");
  answer("6");
  ASSERT_TRUE(stored());
  ASSERT_EQ(screen(), Screen::kThanks);
  EXPECT_TRUE(at().thanks.curve.empty());
  getUp();
  const auto file = tests::lookInto(path);
  const auto sessions = *store::sessions(file);
  ASSERT_EQ(sessions.size(), 1U);
  EXPECT_EQ(sessions[0].kind, study::SessionKind::kUsability);
  const auto answers = *store::answers(file);
  ASSERT_EQ(answers.size(), 6U);
  const std::vector<std::string> wanted = {"1", "2", "3", "7", "5", "6"};
  for (const auto& one : answers) {
    EXPECT_EQ(one.form, "usability-v1");
    EXPECT_EQ(one.value, wanted[static_cast<std::size_t>(one.item) - 1]);
  }
  EXPECT_EQ(store::answers(file, {{}, {}, true})->size(), 7U) << "the corrected one is kept";
}

TEST_F(ParticipantControllerTest, TheResearcherBeginsTheUsabilityFormBeforeAnythingIsPainted) {
  nurse->sitDownAsTeacher();
  ASSERT_TRUE(comesTrue([this] { return !at().code.isEmpty(); }));
  next();
  ASSERT_EQ(screen(), Screen::kConsent);
  EXPECT_TRUE(at().consent.usability);
}

}  // namespace
}  // namespace tactus::workbench
