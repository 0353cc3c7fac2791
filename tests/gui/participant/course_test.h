// A course of the nurse's screens for tests: what a person does on them, in virtual time.
#pragma once

#include <QTemporaryDir>
#include <gtest/gtest.h>
#include <memory>
#include <vector>

#include "app/workbench/participant/participant_controller.h"
#include "core/store/entries.h"

#include "tests/gui/sample_study.h"
#include "tests/gui/stepped_feel.h"

namespace tactus::workbench {

inline ParticipantPlan shortPlan() {
  ParticipantPlan plan;
  plan.seed = 5;
  // The device in virtual time stands for one whose forces are felt; nothing is scored on the virtual one.
  plan.device = QStringLiteral("hid:stands-for-a-device");
  plan.settings.speed.levels = {"slow"};
  plan.settings.speed.practice = 1;
  plan.settings.speed.strokes = 2;
  plan.settings.force.familiarisation_n = {0.3};
  plan.settings.force.ladder = {0.2, 0.4, 0.2};
  return plan;
}

/// Is a screen of a nurse's whole session.
inline bool isOfANurse(const ScreenFacts& facts) {
  return facts.screen != ParticipantScreen::kScale && facts.screen != ParticipantScreen::kStopped;
}

/// One course in virtual time, on a study file of its own.
class CourseTest : public testing::Test {
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
    ASSERT_TRUE(tests::comesTrue([this] { return study->isOpen(); }));
    device = std::make_unique<DeviceSession>(with.settings());
    nurse = std::make_unique<ParticipantController>(*study, *device, plan, [this] { return now(); });
    QObject::connect(device.get(), &DeviceSession::began, [this] { device_since_ns = steps->nowNs(); });
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
  ParticipantScreen screen() const { return at().screen; }
  /// The rest that says that the practice of the forces is over.
  bool beginsToCount() const { return at().page.title.id == QLatin1String("cnt.title"); }

  void advance(int milliseconds) { steps->advance(*device, milliseconds); }
  // The view has painted, and nothing is pressed.
  void look() {
    nurse->painted(at().serial);
    advance(310);
  }
  bool stored() {
    return tests::comesTrue([this] { return !nurse->session().isSaving(); });
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
    ASSERT_TRUE(tests::comesTrue([this] { return !at().code.isEmpty(); }));
  }
  void consent() {
    newHere();
    next();
    ASSERT_EQ(screen(), ParticipantScreen::kConsent);
    next();
    ASSERT_EQ(screen(), ParticipantScreen::kAboutYou) << refused.toStdString();
  }
  void tellAboutHerself() {
    for (const char* id : {"years_3", "left", "yes", "haptic_0", "yes"}) answer(id);
  }
  void checkDevice() {
    ASSERT_EQ(screen(), ParticipantScreen::kDeviceCheck);
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
  // A short press of the device's first button, after it was open for a while.
  void tapButton() {
    std::vector<haptics::Sample> samples(500, device->latest());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      samples[i].time_ns = steps->nowNs() + static_cast<std::int64_t>(i) * 1'000'000;
      samples[i].buttons = i >= 350 && i < 450 ? 1 : 0;
    }
    emit device->sampled(samples);
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
  /// Forward under the force of the own model, until its words may be chosen.
  void pushOwnModel() {
    ASSERT_TRUE(tests::comesTrue([this] { return at().own.ready; }));
    look();
    EXPECT_FALSE(at().own.felt);
    steps->moveTo(*device, 0, 200);
    device->setHeld(true);
    advance(250);
    steps->moveTo(*device, 40, 60);
    EXPECT_TRUE(at().own.felt);
    device->setHeld(false);
    advance(20);
    steps->moveTo(*device, 0, 200);
  }
  void feel() {
    nurse->painted(at().serial);
    steps->moveTo(*device, 0, 200);
    for (int i = 0; i < 100 && at().force.phase != ForceState::Phase::kFeel; ++i) advance(100);
    ASSERT_EQ(at().force.phase, ForceState::Phase::kFeel);
    device->setHeld(true);
    advance(250);
    steps->moveTo(*device, 40, 60);
    device->setHeld(false);
    advance(20);
    ASSERT_EQ(at().force.phase, ForceState::Phase::kAnswer);
    steps->moveTo(*device, 0, 200);
  }
  void judge(const char* word) {
    feel();
    answer(word);
  }
  void doSpeed() {
    ASSERT_EQ(screen(), ParticipantScreen::kPractice);
    insert();
    ASSERT_EQ(screen(), ParticipantScreen::kSpeed)
        << static_cast<int>(at().speed.note) << ' ' << device->latest().position_mm;
    insert();
    insert();
    ASSERT_NO_FATAL_FAILURE(rate());
    ASSERT_EQ(screen(), ParticipantScreen::kRest);
    next();
  }
  // Effort, then comfort.
  void rate() {
    ASSERT_EQ(screen(), ParticipantScreen::kRating);
    answer("2");
    answer("6");
  }
  void doForce() {
    ASSERT_EQ(screen(), ParticipantScreen::kPractice);
    ASSERT_TRUE(at().feels_force);
    judge("medium");
    ASSERT_EQ(screen(), ParticipantScreen::kRest);
    ASSERT_TRUE(beginsToCount());
    next();
    ASSERT_EQ(screen(), ParticipantScreen::kForce);
    judge("small");
    judge("large");
    ASSERT_NO_FATAL_FAILURE(rate());
    ASSERT_EQ(screen(), ParticipantScreen::kRest);
    next();
  }
  void beginQuestions() {
    plan.settings.blocks = {session::Block::kForm};
    getUp();
    sitDown(time);
    consent();
    tellAboutHerself();
    ASSERT_EQ(screen(), ParticipantScreen::kGlossary);
    next();
    ASSERT_EQ(screen(), ParticipantScreen::kQuestion);
  }
  void beginForce() {
    plan.settings.blocks = {session::Block::kForce};
    plan.settings.force.familiarisation_n = {};
    getUp();
    sitDown(*steps);
    consent();
    tellAboutHerself();
    checkDevice();
    ASSERT_EQ(screen(), ParticipantScreen::kForce);
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
  std::int64_t device_since_ns = 0;  ///< start of the device's run
};

}  // namespace tactus::workbench
