// The nurse's screens on the course: what a person does with the mouse or the keyboard ends in the study file.
#include "app/workbench/participant/participant_views.h"

#include <QAbstractButton>
#include <QKeyEvent>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>
#include <memory>

#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/participant_controller.h"
#include "app/workbench/participant/participant_window.h"
#include "app/workbench/participant/screens/panels.h"
#include "app/workbench/participant/screens/question_screens.h"
#include "core/store/entries.h"
#include "core/store/sessions.h"

#include "tests/gui/sample_study.h"
#include "tests/gui/stepped_feel.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;
using Screen = ParticipantScreen;

class ParticipantViewsTest : public testing::Test {
 protected:
  void SetUp() override {
    tests::makeStudyFile(path);
    look.setScreen(96, {1280, 720});
    plan.seed = 5;
    plan.settings.blocks = {session::Block::kForm};
    study = std::make_unique<StudyConnection>();
    study->open(path);
    ASSERT_TRUE(comesTrue([this] { return study->isOpen(); }));
    device = std::make_unique<DeviceSession>(time.settings());
    course = std::make_unique<ParticipantController>(*study, *device, plan, [this] { return now(); });
    window = std::make_unique<ParticipantWindow>(look, [this] { course->forceOff(); });
    views = std::make_unique<ParticipantViews>(*course, look, *window);
    window->resize(1280, 720);
    window->show();
  }
  void TearDown() override { getUp(); }
  // The program ends, so that the file can be looked into.
  void getUp() {
    views.reset();
    if (window) window->leave();
    window.reset();
    course.reset();
    device.reset();
    study.reset();
  }

  study::Moment now() const { return {1'700'000'000'000 + time.nowNs() / 1'000'000, time.nowNs()}; }
  const ParticipantState& at() const { return course->state(); }

  // The first frame is painted, and 300 ms have passed.
  void settle() {
    for (int i = 0; i < 4; ++i) QCoreApplication::processEvents();
    time.pass(310);
  }
  QAbstractButton* button(const QString& text) {
    for (QAbstractButton* each : window->findChildren<QAbstractButton*>()) {
      if (each->isVisible() && each->isEnabled() && each->text() == text) return each;
    }
    return nullptr;
  }
  void click(const char* text) {
    settle();
    QAbstractButton* found = button(QString::fromUtf8(text));
    ASSERT_NE(found, nullptr) << text;
    QTest::mouseClick(found, Qt::LeftButton);
    ASSERT_TRUE(comesTrue([this] { return !course->session().isSaving(); }));
  }
  void press(Qt::Key key) {
    settle();
    QTest::keyClick(window->screen(), key);
    ASSERT_TRUE(comesTrue([this] { return !course->session().isSaving(); }));
  }
  void comeToTheQuestions() {
    click("I am new here");
    ASSERT_TRUE(comesTrue([this] { return !at().code.isEmpty(); }));
    click("Next");
    while (button(QStringLiteral("Next"))) click("Next");  // pages of the consent
    click("I have read this and want to take part");
    ASSERT_EQ(at().screen, Screen::kAboutYou);
    for (const char* answer : {"10 to 14", "Left", "Yes", "Never", "I would rather not say"}) {
      click(answer);
      click("Next");
    }
    ASSERT_EQ(at().screen, Screen::kGlossary);
    while (at().screen == Screen::kGlossary) click("Next");
    ASSERT_EQ(at().screen, Screen::kQuestion);
  }
  std::vector<study::AnswerRecord> answersInFile() {
    getUp();
    return *store::answers(tests::lookInto(path), {{}, {}, true});
  }

  QTemporaryDir folder;
  QString path = folder.filePath(QStringLiteral("nurses.tactus"));
  ParticipantPlan plan;
  tests::SteppedFeel time;
  nurse::Look look;
  std::unique_ptr<StudyConnection> study;
  std::unique_ptr<DeviceSession> device;
  std::unique_ptr<ParticipantController> course;
  std::unique_ptr<ParticipantWindow> window;
  std::unique_ptr<ParticipantViews> views;
};

TEST_F(ParticipantViewsTest, QuestionsAreAnsweredByMouseAndByKeys) {
  comeToTheQuestions();
  click("Large");
  click("Confirm");
  EXPECT_EQ(at().question.position, 2);
  press(Qt::Key_1);
  EXPECT_EQ(at().question.chosen, "very_small");
  press(Qt::Key_0);
  EXPECT_EQ(at().question.chosen, "cant_tell");
  press(Qt::Key_Return);
  EXPECT_EQ(at().question.position, 3);
  press(Qt::Key_Backspace);
  EXPECT_EQ(at().question.position, 2);
  const auto answers = answersInFile();
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0].value, "large");
  EXPECT_EQ(answers[1].status, study::Answer::Status::kCantTell);
}

TEST_F(ParticipantViewsTest, AKeyHeldInAnotherWindowIsNotHers) {
  comeToTheQuestions();
  QWidget monitor;  // the researcher's; not shown, because that would take the focus from her window
  QLineEdit note(&monitor);
  QKeyEvent held(QEvent::KeyPress, Qt::Key_A, Qt::NoModifier);
  QCoreApplication::sendEvent(&note, &held);
  for (const int next : {2, 3}) {
    click("Large");
    click("Confirm");
    EXPECT_EQ(at().question.position, next);
  }
  EXPECT_EQ(answersInFile().size(), 2U);
}

TEST_F(ParticipantViewsTest, ADoubleClickDoesNotAnswerTheNextQuestion) {
  comeToTheQuestions();
  click("Small");
  settle();
  QAbstractButton* confirm = button(QStringLiteral("Confirm"));
  ASSERT_NE(confirm, nullptr);
  QTest::mouseClick(confirm, Qt::LeftButton);
  QTest::mouseDClick(confirm, Qt::LeftButton);
  ASSERT_TRUE(comesTrue([this] { return !course->session().isSaving(); }));
  EXPECT_EQ(at().question.position, 2);
  EXPECT_EQ(at().question.chosen, QString());
  EXPECT_EQ(answersInFile().size(), 1U);
}

TEST_F(ParticipantViewsTest, TheLanguageChangesOnTheSpotAndKeepsTheChoice) {
  click("繁體中文");
  EXPECT_EQ(at().language, "zh-Hant");
  EXPECT_NE(button(QStringLiteral("我是第一次參加")), nullptr);
  click("English");
  comeToTheQuestions();
  click("Medium");
  course->setLanguage(QStringLiteral("zh-Hans"));
  EXPECT_EQ(window->screen()->findChild<nurse::Choices*>()->chosen(), "medium");
  EXPECT_NE(button(QStringLiteral("确认")), nullptr);
  EXPECT_TRUE(answersInFile().empty());
}

// A language without a consent text of the study is none of the study.
TEST_F(ParticipantViewsTest, TheStudysLanguagesAloneAreOffered) {
  const auto sit = [this](std::vector<QString> languages) {
    views.reset();
    window->leave();
    window.reset();
    course.reset();
    plan.languages = std::move(languages);
    course = std::make_unique<ParticipantController>(*study, *device, plan, [this] { return now(); });
    window = std::make_unique<ParticipantWindow>(look, [this] { course->forceOff(); });
    views = std::make_unique<ParticipantViews>(*course, look, *window);
    window->resize(1280, 720);
    window->show();
    settle();
  };
  sit({QStringLiteral("zh-Hant"), QStringLiteral("en")});
  EXPECT_EQ(at().language, QStringLiteral("zh-Hant"));
  EXPECT_EQ(look.language(), nurse::Language::kTraditionalChinese);
  EXPECT_EQ(button(QStringLiteral("简体中文")), nullptr);
  ASSERT_NE(button(QStringLiteral("English")), nullptr);
  course->setLanguage(QStringLiteral("zh-Hans"));
  EXPECT_EQ(at().language, QStringLiteral("zh-Hant"));
  click("English");
  EXPECT_EQ(at().language, QStringLiteral("en"));
  sit({QStringLiteral("en")});
  EXPECT_EQ(button(QStringLiteral("English")), nullptr) << "with one alone there is nothing to choose";
  EXPECT_NE(button(QStringLiteral("I am new here")), nullptr);
}

TEST_F(ParticipantViewsTest, ForceOffCoversTheScreenAndStopKeepsTheAnswers) {
  comeToTheQuestions();
  click("Small");
  click("Confirm");
  course->forceOff();
  EXPECT_TRUE(window->isCovered());
  click("Call the researcher");
  EXPECT_EQ(at().overlay, ForceOffOverlay::kCalled);
  EXPECT_EQ(button(QStringLiteral("Call the researcher")), nullptr);
  click("Continue");
  EXPECT_FALSE(window->isCovered());
  EXPECT_EQ(at().question.position, 2);
  course->forceOff();
  click("Withdraw and delete my data");
  EXPECT_EQ(at().overlay, ForceOffOverlay::kWithdraw);
  click("Keep my data");
  click("Stop for today");
  ASSERT_TRUE(comesTrue([this] { return at().screen == Screen::kStopped; }));
  EXPECT_FALSE(window->isCovered());
  EXPECT_EQ(answersInFile().size(), 1U);
}

TEST_F(ParticipantViewsTest, AllQuestionsThenTheReviewChangesOneAnswer) {
  comeToTheQuestions();
  for (int question = 0; question < 45; ++question) {
    if (at().screen == Screen::kRest) click("Continue");
    ASSERT_EQ(at().screen, Screen::kQuestion) << question;
    press(Qt::Key_3);
    press(Qt::Key_Return);
  }
  ASSERT_EQ(at().screen, Screen::kReview);
  settle();
  click("Medium");  // the first cell
  ASSERT_EQ(at().screen, Screen::kQuestion);
  press(Qt::Key_5);
  press(Qt::Key_Return);
  ASSERT_EQ(at().screen, Screen::kReview);
  click("Next");
  click("Next");
  click("Finish and lock my answers");
  ASSERT_EQ(at().screen, Screen::kRating);
  press(Qt::Key_3);
  press(Qt::Key_Return);
  click("I would rather not say");
  click("Confirm");
  ASSERT_EQ(at().screen, Screen::kReview);
  EXPECT_EQ(button(QStringLiteral("Finish and lock my answers")), nullptr);
  click("Next");
  EXPECT_EQ(at().screen, Screen::kDeviceCheck);
  const auto answers = answersInFile();
  EXPECT_EQ(
      std::count_if(answers.begin(), answers.end(), [](const auto& answer) { return answer.value == "very_large"; }),
      1);
}

}  // namespace
}  // namespace tactus::workbench
