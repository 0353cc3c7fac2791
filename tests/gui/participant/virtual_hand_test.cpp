
#include <QGuiApplication>
#include <QPushButton>
#include <QScreen>
#include <QTest>
#include <gtest/gtest.h>

#include "app/workbench/device/device_session.h"
#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/participant_window.h"

namespace tactus::workbench {
namespace {

class VirtualHandTest : public testing::Test {
 protected:
  void SetUp() override {
    window.setScreen(screen);
    window.showOn(*QGuiApplication::primaryScreen());
    device.start(QStringLiteral("virtual"));
    ASSERT_TRUE(device.isHandLive());
    hand.setWanted(true);
  }
  void TearDown() override { window.leave(); }

  void press(const QPoint& at) { QTest::mousePress(window.windowHandle(), Qt::LeftButton, {}, at); }
  void move(const QPoint& to) { QTest::mouseMove(window.windowHandle(), to); }
  void release(const QPoint& at) { QTest::mouseRelease(window.windowHandle(), Qt::LeftButton, {}, at); }

  nurse::Look look;
  DeviceSession device;
  ParticipantWindow window{look, [] {}};
  QWidget* screen = new QWidget;
  QPushButton* button = new QPushButton(screen);
  VirtualHand hand{window, look, device};
};

TEST_F(VirtualHandTest, ADragOverTheFreeAreaMovesTheHandleAndLettingGoTakesItBack) {
  button->hide();
  const QPoint start(100, 400);
  press(start);
  move(start + QPoint(look.mm(60), 0));
  EXPECT_NEAR(device.targetMm(), 60, 0.5);  // whole pixels, about 4 for a mm
  move(start + QPoint(look.mm(20), 0));
  EXPECT_NEAR(device.targetMm(), 20, 0.5);
  release(start);
  EXPECT_EQ(device.targetMm(), 0);
}

TEST_F(VirtualHandTest, APressOnAButtonIsTheButtons) {
  button->setGeometry(50, 50, 200, 200);
  int clicks = 0;
  QObject::connect(button, &QPushButton::clicked, &window, [&clicks] { ++clicks; });
  press({100, 100});
  move({150, 100});
  EXPECT_EQ(device.targetMm(), 0);
  release({150, 100});
  EXPECT_EQ(clicks, 1);
}

TEST_F(VirtualHandTest, ArrowsMoveAndSpaceHoldsWithoutPressingAButton) {
  button->setFocus();
  int clicks = 0;
  QObject::connect(button, &QPushButton::clicked, &window, [&clicks] { ++clicks; });
  for (int i = 0; i < 5; ++i) QTest::keyClick(button, Qt::Key_Right);
  EXPECT_EQ(device.targetMm(), 20);
  QTest::keyClick(button, Qt::Key_Left);
  EXPECT_EQ(device.targetMm(), 16);
  QTest::keyClick(button, Qt::Key_Space);
  EXPECT_EQ(clicks, 0);
  // The way ends somewhere.
  for (int i = 0; i < 100; ++i) QTest::keyClick(button, Qt::Key_Right);
  EXPECT_EQ(device.targetMm(), 150);
}

TEST_F(VirtualHandTest, WhereNobodyAsksForTheHandTheKeysAreTheScreens) {
  hand.setWanted(false);
  button->setFocus();
  int clicks = 0;
  QObject::connect(button, &QPushButton::clicked, &window, [&clicks] { ++clicks; });
  QTest::keyClick(button, Qt::Key_Space);
  QTest::keyClick(button, Qt::Key_Right);
  EXPECT_EQ(clicks, 1);
  EXPECT_EQ(device.targetMm(), 0);
}

TEST_F(VirtualHandTest, AHandThatHoldsKeepsTheHandleWhenTheScreenAsksSomethingElse) {
  button->hide();
  const QPoint start(100, 400);
  press(start);
  move(start + QPoint(look.mm(30), 0));
  hand.setWanted(false);  // the force is full, and the question appears
  EXPECT_NEAR(device.targetMm(), 30, 0.5);
  move(start + QPoint(look.mm(50), 0));
  EXPECT_NEAR(device.targetMm(), 50, 0.5);
  release(start);
  EXPECT_EQ(device.targetMm(), 0);
  press(start);
  move(start + QPoint(look.mm(30), 0));
  EXPECT_EQ(device.targetMm(), 0);
  release(start);
}

TEST_F(VirtualHandTest, TheHandIsNotLostWithWhatLayUnderTheMouse) {
  button->hide();
  auto* label = new QWidget(screen);
  label->setGeometry(50, 350, 400, 100);
  label->show();
  const QPoint start(100, 400);
  press(start);
  label->hide();
  move(start + QPoint(look.mm(30), 0));
  EXPECT_NEAR(device.targetMm(), 30, 0.5);
  release(start);
  EXPECT_EQ(device.targetMm(), 0);
}

TEST_F(VirtualHandTest, SpaceHoldsOnUntilItIsReleasedAndThenBelongsToTheScreen) {
  button->setFocus();
  int clicks = 0;
  QObject::connect(button, &QPushButton::clicked, &window, [&clicks] { ++clicks; });
  QTest::keyPress(button, Qt::Key_Space);
  hand.setWanted(false);
  QTest::keyClick(button, Qt::Key_Right);
  EXPECT_EQ(device.targetMm(), 4);
  QTest::keyRelease(button, Qt::Key_Space);
  EXPECT_EQ(device.targetMm(), 0);
  EXPECT_EQ(clicks, 0);
  QTest::keyClick(button, Qt::Key_Space);
  EXPECT_EQ(clicks, 1);
}

TEST_F(VirtualHandTest, UnderACoverTheHandRests) {
  window.cover(new QWidget);
  press({100, 400});
  move({300, 400});
  EXPECT_EQ(device.targetMm(), 0);
}

}  // namespace
}  // namespace tactus::workbench
