// The whole window under a hand that does not know what it does: random clicks and keys into the editors and random
// windowGestures at their controllers, panels that come and go, other models in between. TACTUS_WINDOW_GESTURES=5000 in
// the environment plays that many.
#include <QApplication>
#include <QDockWidget>
#include <QSettings>
#include <QTest>
#include <QTimer>
#include <cstdlib>
#include <gtest/gtest.h>

#include "app/workbench/base/theme.h"
#include "app/workbench/tune/findings/findings_panel.h"
#include "app/workbench/tune/rules/rule_editor.h"
#include "app/workbench/tune/terms/membership_editor.h"
#include "app/workbench/workbench.h"

#include "tests/gui/bench_gestures.h"
#include "tests/gui/sample_models.h"
#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::workbench {
namespace {

constexpr int kGesturesInWindow = 120;   // some seconds
constexpr int kOfOneModelInWindow = 60;  // until another one is opened

int windowGestures() {
  const char* const wanted = std::getenv("TACTUS_WINDOW_GESTURES");
  return wanted == nullptr ? kGesturesInWindow : std::atoi(wanted);
}

class WindowFuzz : public testing::Test {
 protected:
  std::size_t below(qsizetype count) { return static_cast<std::size_t>(random.below(static_cast<int>(count))); }
  template <class List>
  auto pick(const List& list) {
    return list[static_cast<qsizetype>(below(list.size()))];
  }

  fuzzy::ForceModel someModel() {
    switch (random.below(3)) {
      case 0: return support::s4AsPrinted();
      case 1: return tests::twoExperts();
      default: return support::randomModel(random, {.gaussians = true, .adversarial = random.below(2) == 0});
    }
  }

  // Other panels have buttons that ask for a file.
  QWidget* somePart() {
    QWidget* const panels[] = {bench.window.findChild<RuleEditor*>(), bench.window.findChild<MembershipEditor*>(),
                               bench.window.findChild<FindingsPanel*>()};
    QWidget* const panel = panels[below(3)];
    if (panel == nullptr || !panel->isVisible()) return nullptr;
    QWidgetList seen;
    for (QWidget* part : panel->findChildren<QWidget*>()) {
      if (part->isVisible() && part->isEnabled() && part->window() == &bench.window) seen << part;
    }
    return seen.isEmpty() ? nullptr : pick(seen);
  }

  void clickOrType() {
    QWidget* const part = somePart();
    if (part == nullptr) return;
    const QPoint place(static_cast<int>(below(std::max(1, part->width()))),
                       static_cast<int>(below(std::max(1, part->height()))));
    static constexpr Qt::Key kKeys[] = {Qt::Key_1,    Qt::Key_5,     Qt::Key_Delete, Qt::Key_Space, Qt::Key_Return,
                                        Qt::Key_Left, Qt::Key_Right, Qt::Key_Up,     Qt::Key_Down,  Qt::Key_Escape,
                                        Qt::Key_Home, Qt::Key_End,   Qt::Key_Tab,    Qt::Key_F2,    Qt::Key_Period};
    switch (random.below(6)) {
      case 0: QTest::mouseDClick(part, Qt::LeftButton, {}, place); break;
      case 1:
        QTest::keyClick(part, kKeys[below(std::size(kKeys))],
                        random.below(4) == 0 ? Qt::ShiftModifier : Qt::NoModifier);
        break;
      case 2: {
        QTest::mousePress(part, Qt::LeftButton, {}, place);
        QTest::mouseMove(part, place + QPoint(random.below(80) - 40, random.below(40) - 20));
        if (random.below(3) == 0) bench.edits.undo();
        QTest::mouseRelease(part, Qt::LeftButton, {}, place + QPoint(random.below(80) - 40, 0));
        break;
      }
      case 3: QTest::mouseClick(part, Qt::RightButton, {}, place); break;
      default: QTest::mouseClick(part, Qt::LeftButton, {}, place);
    }
    closePopup();
  }

  // What popped up is in the way of the next click; a menu of a button even waits for one.
  static void closePopup() {
    if (QWidget* const popup = QApplication::activePopupWidget()) popup->close();
  }

  void rearrange() {
    switch (random.below(5)) {
      case 0: bench.window.enter(random.below(2) == 0 ? Stage::kUnderstand : Stage::kTune); break;
      case 1: bench.window.resize(1024 + random.below(900), 640 + random.below(400)); break;
      case 2: theme::changeLook(*qApp, random.below(2) == 0 ? theme::Look::kDark : theme::Look::kLight); break;
      default: {
        QDockWidget* const dock = pick(bench.window.findChildren<QDockWidget*>());
        dock->show();
        dock->raise();
      }
    }
  }

  tests::ModelFolder folder;
  base::Random random{5};
  QSettings settings{folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat};
  Workbench bench{settings, folder.path(QStringLiteral("autosave"))};
};

TEST_F(WindowFuzz, NoHandBreaksIt) {
  bench.window.resize(1280, 720);
  bench.window.show();
  QTimer closer;
  QObject::connect(&closer, &QTimer::timeout, &closePopup);
  closer.start(0);
  const int count = windowGestures();
  for (int k = 0; k < count;) {
    bench.models.open(folder.write(someModel(), QStringLiteral("%1.tactus.json").arg(k % 3)));
    ASSERT_NE(bench.models.current(), nullptr);
    bench.window.enter(Stage::kTune);
    tests::BenchGestures hand(static_cast<std::uint64_t>(k) + 1, tests::BenchReach(bench));
    for (int end = k + kOfOneModelInWindow; k < end; ++k) {
      const std::string what = random.below(3) == 0 ? hand.play() : (clickOrType(), "click or key");
      ASSERT_EQ(hand.check(false), "") << "gesture " << k << ", " << what;
      if (random.below(12) == 0) rearrange();
      if (random.below(3) > 0) QCoreApplication::processEvents();
    }
    ASSERT_EQ(hand.unwind(), "") << "gesture " << k;
    QCoreApplication::processEvents();
  }
  theme::changeLook(*qApp, theme::Look::kLight);
}

}  // namespace
}  // namespace tactus::workbench
