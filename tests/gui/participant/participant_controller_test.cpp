#include "app/workbench/participant/participant_controller.h"

#include <QTemporaryDir>
#include <algorithm>
#include <atomic>
#include <gtest/gtest.h>
#include <memory>

#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"

#include "tests/gui/sample_study.h"
#include "tests/gui/stepped_feel.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;
using Screen = ParticipantScreen;
using Stage = ForceState::Stage;

ParticipantPlan shortPlan() {
  ParticipantPlan plan;
  plan.seed = 5;
  plan.settings.speed.levels = {"slow"};
  plan.settings.speed.practice = 1;
  plan.settings.speed.strokes = 2;
  plan.settings.force.familiarisation_n = {0.3};
  plan.settings.force.ladder = {0.2, 0.4, 0.2};
  return plan;
}

class ParticipantControllerTest : public testing::Test {
 protected:
  void SetUp() override {
    tests::makeStudyFile(path);
    sitDown(time);
  }
  // As after the start of the program.
  void sitDown(tests::SteppedFeel& with) {
    steps = &with;
    study = std::make_unique<StudyConnection>();
    study->open(path);
    ASSERT_TRUE(comesTrue([this] { return study->isOpen(); }));
    device = std::make_unique<DeviceSession>(with.settings());
    nurse = std::make_unique<ParticipantController>(*study, *device, plan, [this] { return now(); });
    QObject::connect(nurse.get(), &ParticipantController::refused,
                     [this](const QString& sentence) { refused = sentence; });
  }
  void getUp() {
    nurse.reset();
    device.reset();
    study.reset();
  }
  study::Moment now() const { return {1'700'000'000'000 + steps->nowNs() / 1'000'000, steps->nowNs()}; }
  const ParticipantState& at() const { return nurse->state(); }
  Screen screen() const { return at().screen; }

  void advance(int milliseconds) { steps->advance(*device, milliseconds); }
  // The view has painted, and nothing is pressed.
  void look() {
    nurse->painted(at().serial);
    advance(310);
  }
  bool stored() {
    return comesTrue([this] { return !nurse->session().isSaving(); });
  }
  void next() {
    look();
    nurse->next();
    ASSERT_TRUE(stored()) << refused.toStdString();
  }
  void choose(const char* id) {
    look();
    nurse->choose(QLatin1String(id));
  }
  void answer(const char* id) {
    choose(id);
    ASSERT_TRUE(at().can_go_on) << id;
    next();
  }
  void newHere() {
    look();
    nurse->newHere();
    ASSERT_TRUE(comesTrue([this] { return !at().code.isEmpty(); }));
  }
  void consent() {
    newHere();
    next();
    ASSERT_EQ(screen(), Screen::kConsent);
    next();
    ASSERT_EQ(screen(), Screen::kAboutYou) << refused.toStdString();
  }
  void tellAboutHerself() {
    for (const char* id : {"years_3", "left", "yes", "haptic_0", "yes"}) answer(id);
  }
  void checkDevice() {
    ASSERT_EQ(screen(), Screen::kDeviceCheck);
    look();
    device->setHeld(true);
    advance(1200);
    ASSERT_EQ(at().device, DeviceStep::kPush);
    steps->moveTo(*device, 30, 60);
    ASSERT_EQ(at().device, DeviceStep::kRelease);
    device->setHeld(false);
    advance(50);
    ASSERT_EQ(at().device, DeviceStep::kReady);
    steps->moveTo(*device, 0, 200);
    next();
  }
  // From the start, once the screen is settled.
  void insert(double to_mm = 70) {
    look();
    steps->moveTo(*device, 0, 200);
    advance(400);
    steps->moveTo(*device, to_mm, 60);
    advance(1000);  // the end of a stroke is known once the hand has rested
    ASSERT_TRUE(stored());
  }
  void feel() {
    nurse->painted(at().serial);
    steps->moveTo(*device, 0, 200);
    for (int i = 0; i < 100 && at().force.stage != Stage::kFeel; ++i) advance(100);
    ASSERT_EQ(at().force.stage, Stage::kFeel);
    device->setHeld(true);
    advance(250);
    steps->moveTo(*device, 40, 60);
    device->setHeld(false);
    advance(20);
    ASSERT_EQ(at().force.stage, Stage::kAnswer);
    steps->moveTo(*device, 0, 200);
  }
  void judge(const char* word) {
    feel();
    answer(word);
  }
  void doSpeed() {
    ASSERT_EQ(screen(), Screen::kPractice);
    insert();
    ASSERT_EQ(screen(), Screen::kSpeed) << static_cast<int>(at().speed.note) << ' ' << device->latest().position_mm;
    insert();
    insert();
    ASSERT_EQ(screen(), Screen::kRest);
    next();
  }
  void doForce() {
    ASSERT_EQ(screen(), Screen::kPractice);
    ASSERT_TRUE(at().feels_force);
    feel();
    next();
    ASSERT_EQ(screen(), Screen::kForce);
    judge("small");
    judge("large");
    ASSERT_EQ(screen(), Screen::kRest);
    next();
  }
  void beginQuestions() {
    plan.settings.blocks = {session::Block::kForm};
    getUp();
    sitDown(time);
    consent();
    tellAboutHerself();
    ASSERT_EQ(screen(), Screen::kGlossary);
    next();
    ASSERT_EQ(screen(), Screen::kQuestion);
  }
  void beginForce() {
    plan.settings.blocks = {session::Block::kForce};
    plan.settings.force.familiarisation_n = {};
    getUp();
    sitDown(*steps);
    consent();
    tellAboutHerself();
    checkDevice();
    ASSERT_EQ(screen(), Screen::kForce);
  }
  std::vector<study::AnswerRecord> answersInFile() { return *store::answers(tests::lookInto(path), {{}, {}, true}); }
  std::vector<study::JudgementRecord> judgementsInFile() {
    return *store::judgements(tests::lookInto(path), {{}, {}, true});
  }

  QTemporaryDir folder;
  QString path = folder.filePath(QStringLiteral("nurses.tactus"));
  ParticipantPlan plan = shortPlan();
  tests::SteppedFeel time;
  tests::SteppedFeel* steps = &time;
  std::unique_ptr<StudyConnection> study;
  std::unique_ptr<DeviceSession> device;
  std::unique_ptr<ParticipantController> nurse;
  QString refused;
};

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
  int verdicts = 0;
  int marks = 0;
  const auto events = *store::events(file, all);
  for (const auto& event : events) {
    const auto line = *session::ownModelIn(event);
    if (!line) continue;
    EXPECT_FALSE(line->place.region.empty());
    ++(line->verdict ? verdicts : marks);
  }
  EXPECT_EQ(verdicts, regions);
  EXPECT_EQ(marks, 1);
}

TEST_F(ParticipantControllerTest, NothingThatWasPressedBeforeAnswersTheNextScreen) {
  beginQuestions();
  // A double click: the second one comes before the next question is painted.
  choose("small");
  nurse->next();
  nurse->next();
  ASSERT_TRUE(stored());
  EXPECT_EQ(at().question.position, 2);
  nurse->choose(QStringLiteral("large"));
  EXPECT_TRUE(at().question.chosen.isEmpty());
  // Within 300 ms of the first frame.
  nurse->painted(at().serial);
  advance(290);
  nurse->choose(QStringLiteral("large"));
  EXPECT_TRUE(at().question.chosen.isEmpty());
  // A frame of the screen before is not this one's.
  advance(20);
  nurse->choose(QStringLiteral("large"));
  EXPECT_EQ(at().question.chosen, QStringLiteral("large"));
  // Enter is held: it confirms this question, not the next.
  nurse->setInputHeld(true);
  nurse->next();
  ASSERT_TRUE(stored());
  look();
  nurse->choose(QStringLiteral("large"));
  EXPECT_TRUE(at().question.chosen.isEmpty());
  nurse->setInputHeld(false);
  advance(310);
  nurse->choose(QStringLiteral("large"));
  EXPECT_EQ(at().question.chosen, QStringLiteral("large"));
  getUp();
  EXPECT_EQ(answersInFile().size(), 2U);
}

TEST_F(ParticipantControllerTest, TheTimeOfAnAnswerCountsFromTheFirstFrame) {
  beginQuestions();
  advance(5000);  // a slow machine: not painted yet
  nurse->painted(at().serial);
  advance(2000);
  nurse->choose(QStringLiteral("small"));
  advance(500);
  nurse->next();
  ASSERT_TRUE(stored());
  getUp();
  EXPECT_NEAR(answersInFile()[0].response_s, 2.5, 1e-9);  // both times are whole milliseconds
}

TEST_F(ParticipantControllerTest, BackShowsTheAnswerAndAChangeIsANewRecord) {
  beginQuestions();
  answer("small");
  answer("large");
  look();
  nurse->back();
  ASSERT_TRUE(stored());
  EXPECT_EQ(at().question.position, 2);
  EXPECT_EQ(at().question.chosen, QStringLiteral("large"));
  next();  // unchanged: no record
  EXPECT_EQ(at().question.position, 3);
  look();
  nurse->back();
  ASSERT_TRUE(stored());
  answer("medium");
  EXPECT_EQ(at().question.position, 3);
  getUp();
  const auto answers = answersInFile();
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_EQ(answers[2].entry.supersedes, answers[1].entry.id);
}

TEST_F(ParticipantControllerTest, ACellOfTheReviewIsChangedAndLeadsBack) {
  beginQuestions();
  for (int question = 0; question < 45; ++question) {
    if (screen() == Screen::kRest) next();
    answer("medium");
  }
  ASSERT_EQ(screen(), Screen::kReview);
  look();
  nurse->changeItem(7);
  ASSERT_TRUE(stored());
  ASSERT_EQ(screen(), Screen::kQuestion);
  EXPECT_EQ(at().question.item, 7);
  EXPECT_TRUE(at().question.from_review);
  answer("very_large");
  ASSERT_EQ(screen(), Screen::kReview);
  EXPECT_EQ(at().review.answers[6].word, QStringLiteral("very_large"));
  look();
  nurse->changeItem(3);
  ASSERT_TRUE(stored());
  next();  // as it was
  ASSERT_EQ(screen(), Screen::kReview);
  getUp();
  EXPECT_EQ(answersInFile().size(), 46U);
}

TEST_F(ParticipantControllerTest, ForceOffIsAtOnceAndTheStepComesAgain) {
  beginForce();
  nurse->painted(at().serial);
  advance(2300);
  device->setHeld(true);
  advance(300);
  ASSERT_GT(device->latest().force_n, 0.15);
  nurse->forceOff();
  EXPECT_EQ(at().overlay, ForceOffOverlay::kForceOff);
  advance(60);
  EXPECT_EQ(device->latest().force_n, 0);
  device->setHeld(false);
  nurse->next();
  nurse->resume();  // the key that stopped the force is no answer to the overlay
  EXPECT_EQ(at().overlay, ForceOffOverlay::kForceOff);
  ASSERT_TRUE(stored());
  look();
  nurse->resume();
  ASSERT_TRUE(stored());
  EXPECT_EQ(at().overlay, ForceOffOverlay::kNone);
  EXPECT_EQ(screen(), Screen::kForce);
  steps->moveTo(*device, 0, 200);
  judge("small");
  getUp();
  const auto judgements = judgementsInFile();
  ASSERT_EQ(judgements.size(), 1U);
  EXPECT_EQ(judgements[0].attempt, 1);
  EXPECT_TRUE(judgements[0].scored);
}

TEST_F(ParticipantControllerTest, ThePauseOfTheResearcherTakesTheForceAway) {
  beginForce();
  nurse->painted(at().serial);
  advance(2300);
  device->setHeld(true);
  advance(300);
  ASSERT_GT(device->latest().force_n, 0.15);
  nurse->session().pause("the phone rings");
  ASSERT_TRUE(stored());
  EXPECT_TRUE(at().paused);
  advance(60);
  EXPECT_EQ(device->latest().force_n, 0);
  device->setHeld(false);
  look();
  nurse->next();
  EXPECT_FALSE(at().can_go_on);
  nurse->session().unpause();
  ASSERT_TRUE(stored());
  EXPECT_FALSE(at().paused);
  judge("small");
  getUp();
  EXPECT_EQ(judgementsInFile().size(), 1U);
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
  ASSERT_EQ(screen(), Screen::kRest) << "the block is not closed yet";
  next();
  checkDevice();
  ASSERT_TRUE(at().feels_force);
  feel();
  next();
  judge("small");
  come_back(code);
  checkDevice();
  ASSERT_EQ(screen(), Screen::kForce);
  judge("large");
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

TEST_F(ParticipantControllerTest, AnUnpluggedDeviceIsToldAndItsStepComesAgain) {
  haptics::VirtualDeviceSettings settings;
  // The second start of the device finds it as new.
  settings.faults = {{haptics::InjectedFault::kUnplugged, 12, 1e6}};
  tests::SteppedFeel faulty(settings);
  steps = &faulty;
  beginForce();
  nurse->painted(at().serial);
  device->setHeld(true);
  for (int i = 0; i < 200 && screen() == Screen::kForce; ++i) advance(100);
  ASSERT_EQ(screen(), Screen::kDeviceCheck);
  EXPECT_EQ(at().device, DeviceStep::kWrong);
  EXPECT_EQ(device->latest().force_n, 0);
  device->setHeld(false);
  device->stop();
  next();
  ASSERT_EQ(device->state(), DeviceSession::State::kRunning);
  steps->moveTo(*device, 0, 200);
  checkDevice();
  judge("small");
  getUp();
  ASSERT_EQ(judgementsInFile().size(), 1U);
}

TEST_F(ParticipantControllerTest, AFullDiskIsSaidAndNothingIsAnsweredMeanwhile) {
  beginQuestions();
  const auto full = std::make_shared<std::atomic<bool>>(true);
  study->order([full](store::StudyFile&, study::RecordIds&) -> base::Result<void> {
    if (*full) return base::fail(base::ErrorCode::kIo, "disk", "no space left", "free space");
    return {};
  });
  choose("small");
  nurse->next();
  ASSERT_TRUE(comesTrue([this] { return at().failed; }));
  EXPECT_EQ(at().question.position, 1);
  EXPECT_FALSE(at().can_go_on);
  *full = false;
  study->storeNow();
  ASSERT_TRUE(stored());
  EXPECT_FALSE(at().failed);
  EXPECT_EQ(at().question.position, 2);
}

TEST_F(ParticipantControllerTest, TheButtonOfTheDeviceLightsWordsFromAnyEnd) {
  beginForce();
  feel();
  look();
  nurse->lightNext();
  const QString first = at().force.lit;
  EXPECT_FALSE(first.isEmpty());
  EXPECT_TRUE(at().force.chosen.isEmpty()) << "lit is not chosen";
  for (std::size_t i = 0; i < 7; ++i) nurse->lightNext();  // five words and two more answers
  EXPECT_EQ(at().force.lit, first);
  nurse->chooseLit();
  EXPECT_EQ(at().force.chosen, first);
  next();
  getUp();
  ASSERT_EQ(judgementsInFile().size(), 1U);
  const auto events = *store::events(tests::lookInto(path), {{}, {}, true});
  const auto by_button = [](const auto& event) {
    const auto line = *session::answerInputIn(event);
    return line && line->input.means == session::InputMeans::kDeviceButton && line->input.presses == 8;
  };
  EXPECT_EQ(std::count_if(events.begin(), events.end(), by_button), 1);
}

}  // namespace
}  // namespace tactus::workbench
