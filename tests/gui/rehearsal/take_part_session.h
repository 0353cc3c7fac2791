// One participant on the screens of "Take part", in virtual time on the virtual device; by which means is up to a test.
#pragma once

#include <QAbstractButton>
#include <QGuiApplication>
#include <QScreen>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>
#include <memory>

#include "app/workbench/device/virtual_time.h"
#include "app/workbench/session/take_part.h"
#include "core/store/entries.h"
#include "core/store/research_key.h"

#include "tests/gui/sample_study.h"

namespace tactus::workbench {

class TakePartTest : public testing::Test {
 protected:
  void begin(bool with_key = false) {
    tests::makeStudyFile(path, [with_key](store::StudyFile& file, study::RecordIds&) {
      if (!with_key) return;
      ASSERT_TRUE(store::setResearchKey(file, "open sesame", 0));
    });
    plan.seed = 5;
    plan.settings.speed.levels = {"slow"};
    plan.settings.speed.practice = 1;
    plan.settings.speed.strokes = 2;
    plan.settings.force.familiarisation_n = {0.3};
    plan.settings.force.ladder = {0.2, largest_n, 0.2};
    study->open(path);
    ASSERT_TRUE(tests::comesTrue([this] { return study->isOpen(); }));
    part = std::make_unique<TakePart>(*study, *device, plan, [this] { return now(); });
    QObject::connect(&part->course(), &ParticipantController::refused,
                     [](const QString& sentence) { ADD_FAILURE() << sentence.toStdString(); });
    QObject::connect(part.get(), &TakePart::left, [this] { left = true; });
    QObject::connect(part.get(), &TakePart::finished, [this] { finished = true; });
    part->begin(*QGuiApplication::primaryScreen());
    ASSERT_TRUE(QTest::qWaitForWindowActive(&part->window()));
  }
  void TearDown() override {
    if (part) part->window().leave();
    part.reset();
    device.reset();
    study.reset();
  }

  study::Moment now() const { return {1'700'000'000'000 + time.nowNs() / 1'000'000, time.nowNs()}; }
  const ParticipantState& at() const { return part->course().state(); }
  QWindow* window() const { return part->window().windowHandle(); }
  void pass(int milliseconds) {
    for (int ms = 0; ms < milliseconds; ms += VirtualTime::kBeat) {
      time.advance(*device, VirtualTime::kBeat);
      QCoreApplication::processEvents();
    }
  }
  // Everything is painted and stored, and 300 ms have passed.
  void settle() {
    EXPECT_TRUE(tests::comesTrue([this] { return !part->course().session().isSaving(); }));
    for (int i = 0; i < 4; ++i) QCoreApplication::processEvents();
    pass(330);
  }
  QAbstractButton* button(const QString& text) const {
    for (QAbstractButton* each : part->window().findChildren<QAbstractButton*>()) {
      if (each->isVisible() && each->isEnabled() && each->text() == text) return each;
    }
    return nullptr;
  }
  QString say(const char* id) const { return part->look().say(nurse::phrase(QString::fromLatin1(id))); }

  // The ways of one means of input.
  virtual void choose(const QString& /*text*/, Qt::Key /*key*/) {}
  virtual void goOn() {}
  virtual void push(bool /*until_still*/) {}

  // One thing that the screen asks for.
  void doIt() {
    settle();
    switch (at().screen) {
      case ParticipantScreen::kWelcome:
        goOn();
        // The study's thread draws her code, in real time.
        ASSERT_TRUE(tests::comesTrue([this] { return !at().code.isEmpty(); }));
        return;
      case ParticipantScreen::kAboutYou: {
        if (at().can_go_on) return goOn();
        const char* answer = at().about.question == AboutYouState::Question::kYears  ? "you.years_3"
                             : at().about.question == AboutYouState::Question::kHand ? "you.hand_left"
                                                                                     : "you.not_say";
        return choose(say(answer), Qt::Key_unknown);
      }
      case ParticipantScreen::kDeviceCheck: return at().device == DeviceStep::kReady ? goOn() : push(true);
      case ParticipantScreen::kSpeed: return push(false);
      case ParticipantScreen::kPractice:
      case ParticipantScreen::kForce:
        if (!at().feels_force) return push(false);
        if (at().force.phase == ForceState::Phase::kPause) return pass(500);
        if (at().force.phase == ForceState::Phase::kFeel) return push(true);
        if (at().force.chosen.isEmpty()) return choose(say("w.small"), Qt::Key_2);
        return goOn();
      case ParticipantScreen::kRating: return at().can_go_on ? goOn() : choose(QStringLiteral("3"), Qt::Key_3);
      case ParticipantScreen::kQuestion: return at().can_go_on ? goOn() : choose(say("w.medium"), Qt::Key_3);
      case ParticipantScreen::kOwnModel:
        // Her model is built by another thread, in real time.
        ASSERT_TRUE(tests::comesTrue([this] { return at().own.ready; }));
        if (!at().own.felt) return push(false);
        return at().can_go_on ? goOn() : choose(say("own.right"), Qt::Key_2);
      default: {
        const PageState& page = at().page;
        const bool asks = !page.cards.empty() && page.chosen.isEmpty();
        return asks ? choose(part->look().say(page.cards.front().word), Qt::Key_unknown) : goOn();
      }
    }
  }
  void doAll() {
    for (int steps = 0; steps < 250 && !finished; ++steps) {
      ASSERT_NO_FATAL_FAILURE(doIt());
      ASSERT_NE(at().overlay, ForceOffOverlay::kForceOff);
    }
    ASSERT_TRUE(finished) << static_cast<int>(at().screen);
    settle();
  }
  // All of it is there, and says by what means it came.
  void expectAll(session::InputMeans means) {
    TearDown();
    study = std::make_unique<StudyConnection>();
    const auto file = tests::lookInto(path);
    EXPECT_EQ(store::strokes(file, {{}, {}, true}, store::Recordings::kLeaveOut)->size(), 2U);
    const auto judgements = *store::judgements(file);
    ASSERT_EQ(judgements.size(), 3U);
    EXPECT_FALSE(judgements[1].scored) << "the virtual device gives no force";
    EXPECT_EQ(judgements[2].term, "small");
    const auto answers = *store::answers(file);
    EXPECT_EQ(answers.size(), 45U);
    EXPECT_EQ(store::ratings(file)->size(), 3U);
    int by_means = 0;
    const auto events = *store::events(file);
    for (const auto& event : events) {
      const auto line = *session::answerInputIn(event);
      if (line && line->input.means == means) ++by_means;
    }
    EXPECT_EQ(by_means, 48) << "three forces, one of them practice, and 45 questions";
  }

  QTemporaryDir folder;
  QString path = folder.filePath(QStringLiteral("nurses.tactus"));
  ParticipantPlan plan;
  double largest_n = 0.4;  ///< of the forces
  VirtualTime time;
  std::unique_ptr<StudyConnection> study = std::make_unique<StudyConnection>();
  std::unique_ptr<DeviceSession> device = std::make_unique<DeviceSession>(time.access());
  std::unique_ptr<TakePart> part;
  bool left = false;
  bool finished = false;
};

}  // namespace tactus::workbench
