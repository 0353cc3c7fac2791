// Whole sessions on the screens by the keyboard alone and by touch alone, as events of the window; and the way out.
#include "app/workbench/session/take_part.h"

#include <QLabel>
#include <QLineEdit>
#include <algorithm>

#include "app/devices/device_list.h"

#include "tests/gui/rehearsal/take_part_session.h"

namespace tactus::workbench {
namespace {

using session::InputMeans;
using tests::comesTrue;

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

TEST(DeviceToFeel, ARealOneBeforeADoubleBeforeTheVirtualOne) {
  devices::DeviceList list;
  const auto add = [&list](const char* id, bool usable, bool simulated) {
    devices::ListedDevice& device = list.devices.emplace_back();
    device.id = id;
    device.usable = usable;
    device.simulated = simulated;
  };
  add("simulated-haply:SIM-1", true, true);
  add("haply:1", false, false);
  add("haply:2", true, false);
  add("virtual", true, true);
  EXPECT_EQ(deviceToFeel(list), QStringLiteral("haply:2"));
  list.devices[2].usable = false;
  EXPECT_EQ(deviceToFeel(list), QStringLiteral("simulated-haply:SIM-1"));
  list.devices[0].usable = false;
  EXPECT_EQ(deviceToFeel(list), QStringLiteral("virtual"));
}

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
