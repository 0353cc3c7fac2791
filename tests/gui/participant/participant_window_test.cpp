#include "app/workbench/participant/participant_window.h"

#include <QDialog>
#include <QGuiApplication>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QShortcut>
#include <QTest>
#include <gtest/gtest.h>
#include <vector>

#include "app/workbench/participant/kit/button.h"
#include "app/workbench/participant/kit/look.h"

namespace tactus::workbench {
namespace {

class ParticipantWindowTest : public testing::Test {
 protected:
  void SetUp() override {
    QObject::connect(&window, &ParticipantWindow::forceOff, &window, [this](ForceOffCause cause) {
      // The force is gone before anybody is asked anything.
      EXPECT_GT(offs, told);
      told = offs;
      causes.push_back(cause);
    });
    window.setScreen(new QLineEdit);
    window.showOn(*QGuiApplication::primaryScreen());
    QCoreApplication::processEvents();
  }
  void TearDown() override { window.leave(); }

  // As the desktop sends it: a dialog before the window keeps it away, unlike a click on the widget.
  void pressOnScreen(const QWidget& widget) {
    QTest::mousePress(window.windowHandle(), Qt::LeftButton, {}, widget.mapTo(&window, widget.rect().center()));
  }

  int offs = 0;
  int told = 0;
  std::vector<ForceOffCause> causes;
  nurse::Look look;
  ParticipantWindow window{look, [this] { ++offs; }};
};

TEST_F(ParticipantWindowTest, FillsItsScreen) {
  EXPECT_EQ(window.geometry(), QGuiApplication::primaryScreen()->geometry());
  EXPECT_EQ(window.screen()->geometry(), window.rect());
  EXPECT_TRUE(window.rect().contains(window.forceOffButton().geometry()));
}

TEST_F(ParticipantWindowTest, TheButtonActsOnThePressAlsoAboveACover) {
  pressOnScreen(window.forceOffButton());
  EXPECT_EQ(causes, std::vector{ForceOffCause::kButton});
  QTest::mouseRelease(window.windowHandle(), Qt::LeftButton, {}, QPoint(1, 1));
  EXPECT_EQ(offs, 1);
  window.cover(new QWidget);
  pressOnScreen(window.forceOffButton());
  EXPECT_EQ(offs, 2);
}

TEST_F(ParticipantWindowTest, ACoverTakesTheKeysFromTheScreen) {
  window.activateWindow();
  QWidget* const screen = window.screen();
  EXPECT_TRUE(screen->isEnabled());
  auto* question = new QPushButton;
  window.cover(question);
  EXPECT_FALSE(screen->isEnabled());
  EXPECT_EQ(question->geometry(), window.rect());
  // A screen that comes while the question stands waits below it.
  window.setScreen(new QLineEdit);
  EXPECT_FALSE(window.screen()->isEnabled());
  window.uncover();
  EXPECT_FALSE(window.isCovered());
  EXPECT_TRUE(window.screen()->isEnabled());
}

TEST_F(ParticipantWindowTest, AQuestionForTheResearcherLiesAboveTheCover) {
  auto* cover = new QPushButton;
  window.cover(cover);
  auto* question = new QLineEdit;
  window.askResearcher(question);
  EXPECT_FALSE(cover->isEnabled());
  EXPECT_TRUE(question->isEnabled());
  pressOnScreen(window.forceOffButton());
  EXPECT_EQ(offs, 1);
  // What the course puts over the screen meanwhile waits below the question.
  window.uncover();
  EXPECT_FALSE(window.screen()->isEnabled());
  window.endQuestion();
  EXPECT_TRUE(window.screen()->isEnabled());
}

TEST_F(ParticipantWindowTest, EscTakesTheForceAwayFromEveryPlace) {
  QTest::keyClick(window.screen(), Qt::Key_Escape);
  EXPECT_EQ(causes, std::vector{ForceOffCause::kEscape});
  EXPECT_TRUE(window.isVisible());
  // Others that want the key do not get it.
  int others = 0;
  const QShortcut shortcut(QKeySequence(Qt::Key_Escape), &window, [&] { ++others; });
  QTest::keyClick(window.windowHandle(), Qt::Key_Escape);
  QDialog dialog(&window);
  dialog.setModal(true);
  dialog.show();
  QTest::keyClick(&dialog, Qt::Key_Escape);
  EXPECT_EQ(offs, 3);
  EXPECT_EQ(others, 0);
  EXPECT_TRUE(dialog.isVisible());
}

TEST_F(ParticipantWindowTest, AHeldEscAsksOnce) {
  QTest::keyPress(window.screen(), Qt::Key_Escape);
  for (int i = 0; i < 3; ++i) {
    QKeyEvent again(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier, QString(), true);
    QCoreApplication::sendEvent(window.screen(), &again);
  }
  QTest::keyRelease(window.screen(), Qt::Key_Escape);
  EXPECT_EQ(offs, 1);
}

TEST_F(ParticipantWindowTest, ClosingAsksInsteadOfClosing) {
  EXPECT_FALSE(window.close());
  EXPECT_TRUE(window.isVisible());
  EXPECT_EQ(causes, std::vector{ForceOffCause::kClosing});
}

TEST_F(ParticipantWindowTest, WithoutTheKeyboardThereIsNoForce) {
  QEvent deactivated(QEvent::WindowDeactivate);
  QCoreApplication::sendEvent(&window, &deactivated);
  EXPECT_EQ(causes, std::vector{ForceOffCause::kDeactivated});
  emit qGuiApp->screenRemoved(QGuiApplication::primaryScreen());
  EXPECT_EQ(causes.back(), ForceOffCause::kScreenGone);
}

TEST_F(ParticipantWindowTest, LeavingAsksNothingAndGivesEscBack) {
  window.leave();
  EXPECT_FALSE(window.isVisible());
  EXPECT_TRUE(causes.empty());
  const int before = offs;
  EXPECT_GT(before, 0);
  QLineEdit elsewhere;
  QTest::keyClick(&elsewhere, Qt::Key_Escape);
  EXPECT_EQ(offs, before);
}

}  // namespace
}  // namespace tactus::workbench
