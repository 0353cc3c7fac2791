// Whole sessions on the screens by the keyboard alone and by touch alone, as events of the window; and the way out.
#include "app/workbench/take_part.h"

#include <QAbstractButton>
#include <QGuiApplication>
#include <QLineEdit>
#include <QScreen>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>
#include <memory>

#include "app/workbench/device/virtual_time.h"
#include "core/store/entries.h"
#include "core/store/research_key.h"

#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;
using Screen = ParticipantScreen;
using session::InputMeans;

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
    plan.settings.force.ladder = {0.2, 0.4, 0.2};
    study->open(path);
    ASSERT_TRUE(comesTrue([this] { return study->isOpen(); }));
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
    EXPECT_TRUE(comesTrue([this] { return !part->course().session().isSaving(); }));
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
      case Screen::kWelcome:
        goOn();
        // The study's thread draws her code, in real time.
        ASSERT_TRUE(comesTrue([this] { return !at().code.isEmpty(); }));
        return;
      case Screen::kAboutYou: {
        if (at().can_go_on) return goOn();
        const char* answer = at().about.question == AboutYouState::Question::kYears  ? "you.years_3"
                             : at().about.question == AboutYouState::Question::kHand ? "you.hand_left"
                                                                                     : "you.not_say";
        return choose(say(answer), Qt::Key_unknown);
      }
      case Screen::kDeviceCheck:
        return at().device == DeviceStep::kReady ? goOn() : push(true);
      case Screen::kSpeed:
        return push(false);
      case Screen::kPractice:
      case Screen::kForce:
        if (!at().feels_force) return push(false);
        if (at().force.stage == ForceState::Stage::kPause) return pass(500);
        if (at().force.stage == ForceState::Stage::kFeel) return push(true);
        if (at().force.asks && at().force.chosen.isEmpty()) return choose(say("w.small"), Qt::Key_2);
        return goOn();
      case Screen::kRating:
        return at().can_go_on ? goOn() : choose(QStringLiteral("3"), Qt::Key_3);
      case Screen::kQuestion:
        return at().can_go_on ? goOn() : choose(say("w.medium"), Qt::Key_3);
      case Screen::kOwnModel:
        // Her model is built by another thread, in real time.
        ASSERT_TRUE(comesTrue([this] { return at().own.ready; }));
        return at().can_go_on ? goOn() : choose(say("own.right"), Qt::Key_2);
      default:
        return goOn();
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
  void expectAll(InputMeans means) {
    TearDown();
    study = std::make_unique<StudyConnection>();
    const auto file = tests::lookInto(path);
    EXPECT_EQ(store::strokes(file, {{}, {}, true}, store::Recordings::kLeaveOut)->size(), 3U);
    const auto judgements = *store::judgements(file);
    ASSERT_EQ(judgements.size(), 3U);
    EXPECT_TRUE(judgements[1].scored);
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
    EXPECT_EQ(by_means, 47) << "two forces and 45 questions";
  }

  QTemporaryDir folder;
  QString path = folder.filePath(QStringLiteral("nurses.tactus"));
  ParticipantPlan plan;
  VirtualTime time;
  std::unique_ptr<StudyConnection> study = std::make_unique<StudyConnection>();
  std::unique_ptr<DeviceSession> device = std::make_unique<DeviceSession>(time.access());
  std::unique_ptr<TakePart> part;
  bool left = false;
  bool finished = false;
};

class KeyboardSession : public TakePartTest {
 protected:
  // The digit of the screen, or Tab to the cards, the arrows to one of them, and Space.
  void choose(const QString& text, Qt::Key key) override {
    if (key != Qt::Key_unknown) return QTest::keyClick(window(), key);
    const auto focused = [] { return qobject_cast<QAbstractButton*>(QApplication::focusWidget()); };
    while (focused() == nullptr || !focused()->isCheckable()) QTest::keyClick(window(), Qt::Key_Tab);
    // Among the cards the arrows move, without choosing.
    for (const Qt::Key arrow :
         {Qt::Key_Right, Qt::Key_Right, Qt::Key_Right, Qt::Key_Down, Qt::Key_Left, Qt::Key_Left}) {
      if (focused()->text() == text) break;
      QTest::keyClick(window(), arrow);
    }
    ASSERT_EQ(focused()->text(), text);
    QTest::keyClick(window(), Qt::Key_Space);
  }
  void goOn() override {
    part->window().screen()->setFocus();  // as she finds it; a card keeps Enter for itself
    QTest::keyClick(window(), Qt::Key_Return);
  }
  void push(bool until_still) override {
    QTest::keyPress(window(), Qt::Key_Space);
    pass(until_still ? 1300 : 200);
    const bool forward = device->targetMm() < 60;
    for (int i = 0; i < 16 && forward; ++i) {
      QTest::keyClick(window(), Qt::Key_Right);
      pass(48);
    }
    pass(900);
    QTest::keyRelease(window(), Qt::Key_Space);
    for (int i = 0; i < 40 && device->targetMm() > 0; ++i) {
      QTest::keyClick(window(), Qt::Key_Left);
      pass(16);
    }
    pass(300);
  }
};

class TouchSession : public TakePartTest {
 protected:
  void tap(const QAbstractButton& on) {
    const QPoint middle = on.mapTo(&part->window(), on.rect().center());
    QTest::touchEvent(window(), finger_).press(0, middle);
    QTest::touchEvent(window(), finger_).release(0, middle);
  }
  void choose(const QString& text, Qt::Key /*key*/) override {
    const QAbstractButton* card = button(text);
    ASSERT_NE(card, nullptr) << text.toStdString();
    tap(*card);
  }
  void goOn() override {
    for (const char* id :
         {"code.new", "con.agree", "nav.confirm", "nav.seal", "nav.continue", "nav.next", "thx.done"}) {
      if (const QAbstractButton* found = button(say(id))) return tap(*found);
    }
    FAIL() << static_cast<int>(at().screen);
  }
  void push(bool until_still) override {
    QPoint at_px(part->window().width() / 8, part->window().height() * 3 / 4);
    while (qobject_cast<QAbstractButton*>(part->window().childAt(at_px)) != nullptr) at_px.ry() += 8;
    QTest::touchEvent(window(), finger_).press(0, at_px);
    pass(until_still ? 1300 : 300);
    for (int mm = 4; mm <= 60; mm += 4) {
      QTest::touchEvent(window(), finger_).move(0, at_px + QPoint(part->look().mm(mm), 0));
      pass(48);
    }
    pass(900);
    QTest::touchEvent(window(), finger_).release(0, at_px + QPoint(part->look().mm(60), 0));
    pass(500);
  }

 private:
  QPointingDevice* finger_ = QTest::createTouchDevice();
};

TEST_F(KeyboardSession, IsWholeAndInTheFile) {
  ASSERT_NO_FATAL_FAILURE(begin());
  ASSERT_NO_FATAL_FAILURE(doAll());
  expectAll(InputMeans::kKeyboard);
}

TEST_F(TouchSession, IsWholeAndInTheFile) {
  ASSERT_NO_FATAL_FAILURE(begin());
  ASSERT_NO_FATAL_FAILURE(doAll());
  expectAll(InputMeans::kTouch);
}

TEST_F(TakePartTest, TheResearcherLeavesWithThePassphraseOfTheStudyOnly) {
  ASSERT_NO_FATAL_FAILURE(begin(true));
  settle();
  QTest::keyClick(window(), Qt::Key_Escape);
  ASSERT_EQ(at().overlay, ForceOffOverlay::kForceOff);
  settle();
  QAbstractButton* leave = button(say("leave.button"));
  ASSERT_NE(leave, nullptr);
  QTest::mouseClick(window(), Qt::LeftButton, {}, leave->mapTo(&part->window(), leave->rect().center()));
  settle();
  ASSERT_NE(qobject_cast<QLineEdit*>(QApplication::focusWidget()), nullptr);
  QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("open says me"));
  QTest::keyClick(window(), Qt::Key_Return);
  const auto refused = [this] {
    const auto labels = part->window().findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [this](const QLabel* label) {
      return label->isVisible() && label->text() == say("leave.wrong");
    });
  };
  ASSERT_TRUE(comesTrue(refused));
  EXPECT_FALSE(left);
  QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("open sesame"));
  QTest::keyClick(window(), Qt::Key_Return);
  EXPECT_TRUE(comesTrue([this] { return left; }));
  EXPECT_FALSE(part->window().isVisible());
}

}  // namespace
}  // namespace tactus::workbench
