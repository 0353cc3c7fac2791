// Whole sessions by the mouse alone and by the keyboard alone, with events of an X server: xdotool moves its pointer
// and presses its keys, as hands do. Needs a display; ctest runs it under Xvfb.
#include <QApplication>
#include <QKeyEvent>
#include <QProcess>
#include <cmath>

#include "tests/gui/patience.h"
#include "tests/gui/rehearsal/take_part_session.h"

namespace tactus::workbench {
namespace {

using session::InputMeans;

using tests::kPatience;

/// Counts what comes from the X server.
class EventCount : public QObject {
 public:
  EventCount() { qApp->installEventFilter(this); }
  int of(QEvent::Type type) const { return counts_.value(type); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool is_key = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
    if (is_key && static_cast<QKeyEvent*>(event)->isAutoRepeat()) return false;
    // At the window itself: each comes there once.
    if (event->spontaneous() && watched->isWindowType()) ++counts_[event->type()];
    return false;
  }

 private:
  QHash<QEvent::Type, int> counts_;
};

class RealEvents : public TakePartTest {
 protected:
  void SetUp() override {
    if (QGuiApplication::platformName() != QLatin1String("xcb")) GTEST_SKIP() << "runs on an X server";
    hands.start(QStringLiteral("xdotool"), {QStringLiteral("-")});
    ASSERT_TRUE(hands.waitForStarted());
  }
  void TearDown() override {
    hands.closeWriteChannel();
    hands.waitForFinished();
    TakePartTest::TearDown();
  }

  // Orders `command`, and waits for the event that it makes.
  void act(const QString& command, QEvent::Type comes) {
    const int before = events.of(comes);
    hands.write(command.toUtf8() + '\n');
    ASSERT_TRUE(QTest::qWaitFor([&] { return events.of(comes) > before; }, kPatience)) << command.toStdString();
  }
  QAbstractButton* shown(std::initializer_list<const char*> ids) const {
    for (const char* id : ids) {
      if (QAbstractButton* found = button(say(id))) return found;
    }
    return nullptr;
  }
  QAbstractButton* wayOn() const {
    return shown({"code.new", "con.agree", "nav.confirm", "nav.seal", "nav.continue", "nav.next", "thx.done"});
  }

  EventCount events;
  QProcess hands;
};

class RealMouse : public RealEvents {
 protected:
  void click(const QAbstractButton* on) {
    ASSERT_NE(on, nullptr) << static_cast<int>(at().screen);
    const QPoint place = on->mapToGlobal(on->rect().center());
    act(QStringLiteral("mousemove %1 %2 click 1").arg(place.x()).arg(place.y()), QEvent::MouseButtonRelease);
  }
  void choose(const QString& text, Qt::Key /*key*/) override { click(button(text)); }
  void goOn() override { click(wayOn()); }
  void push(bool until_still) override {
    QPoint place(part->window().width() / 8, part->window().height() * 3 / 4);
    while (qobject_cast<QAbstractButton*>(part->window().childAt(place)) != nullptr) place.ry() += 8;
    const auto to = [&place](double px) {
      return QStringLiteral("mousemove %1 %2").arg(place.x() + std::lround(px)).arg(place.y());
    };
    act(to(0) + QStringLiteral(" mousedown 1"), QEvent::MouseButtonPress);
    pass(until_still ? 1300 : 300);
    for (int mm = 4; mm <= 60; mm += 4) {
      act(to(part->look().mm(mm)), QEvent::MouseMove);
      pass(48);
    }
    pass(900);
    act(QStringLiteral("mouseup 1"), QEvent::MouseButtonRelease);
    pass(500);
  }
};

class RealKeyboard : public RealEvents {
 protected:
  void press(const char* key) {
    act(QStringLiteral("key ") + QLatin1String(key), QEvent::KeyRelease);
    QCoreApplication::processEvents();
  }
  QAbstractButton* focused() const { return qobject_cast<QAbstractButton*>(QApplication::focusWidget()); }
  void choose(const QString& text, Qt::Key key) override {
    if (key != Qt::Key_unknown) return press(qPrintable(QString(QChar(key))));
    for (int i = 0; i < 12 && (focused() == nullptr || !focused()->isCheckable()); ++i) press("Tab");
    for (const char* arrow : {"Right", "Right", "Right", "Down", "Left", "Left"}) {
      if (focused() == nullptr || focused()->text() == text) break;
      press(arrow);
    }
    ASSERT_NE(focused(), nullptr);
    ASSERT_EQ(focused()->text(), text);
    press("space");
  }
  // Enter continues, but on a card, which keeps it: from there Tab leads to the button.
  void goOn() override {
    for (int i = 0; i < 12 && focused() != nullptr && focused() != wayOn(); ++i) press("Tab");
    press("Return");
  }
  void push(bool until_still) override {
    act(QStringLiteral("keydown space"), QEvent::KeyPress);
    pass(until_still ? 1300 : 200);
    const bool forward = device->targetMm() < 60;
    for (int i = 0; i < 16 && forward; ++i) {
      press("Right");
      pass(48);
    }
    pass(900);
    act(QStringLiteral("keyup space"), QEvent::KeyRelease);
    for (int i = 0; i < 40 && device->targetMm() > 0; ++i) {
      press("Left");
      pass(16);
    }
    pass(300);
  }
};

TEST_F(RealMouse, AWholeSessionIsInTheFile) {
  ASSERT_NO_FATAL_FAILURE(begin());
  ASSERT_NO_FATAL_FAILURE(doAll());
  EXPECT_EQ(events.of(QEvent::KeyPress), 0);
  expectAll(InputMeans::kMouse);
}

TEST_F(RealKeyboard, AWholeSessionIsInTheFile) {
  ASSERT_NO_FATAL_FAILURE(begin());
  ASSERT_NO_FATAL_FAILURE(doAll());
  EXPECT_EQ(events.of(QEvent::MouseButtonPress), 0);
  expectAll(InputMeans::kKeyboard);
}

}  // namespace
}  // namespace tactus::workbench
