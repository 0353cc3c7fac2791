#include "app/workbench/understand/pull/pull_card.h"

#include <QAbstractButton>
#include <QLabel>
#include <QPushButton>

#include "app/workbench/kit/number_box.h"
#include "app/workbench/understand/curves/curve_plot.h"
#include "app/workbench/understand/curves/curves_panel.h"

#include "tests/gui/shown_bench.h"

namespace tactus::workbench {
namespace {

using State = PullController::State;

/// Two experts who share their words: at depth 8 A says 0.75 N and B 0.25 N, so the mean is 0.5 N.
class PullCardTest : public tests::ShownBench {
 protected:
  PullCardTest() : ShownBench(Stage::kUnderstand) {}

  PullCard* card() { return bench.window.findChild<PullCard*>(); }
  QWidget* canvas() { return bench.views.curves->findChild<CurvePlot*>()->findChild<QWidget*>(); }
  QPoint pixelOf(double x, double force_n) {
    CurvesPanel& curves = *bench.views.curves;
    return canvas()->mapFrom(&curves, curves.pixelOf(x, force_n));
  }
  void mouse(QEvent::Type type, QPoint at, Qt::KeyboardModifiers keys) {
    const bool move = type == QEvent::MouseMove;
    const auto buttons = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, at, canvas()->mapToGlobal(at), move ? Qt::NoButton : Qt::LeftButton, buttons, keys);
    QCoreApplication::sendEvent(canvas(), &event);
  }
  void drag(QPoint from, QPoint to, Qt::KeyboardModifiers keys) {
    mouse(QEvent::MouseButtonPress, from, keys);
    mouse(QEvent::MouseMove, (from + to) / 2, keys);
    mouse(QEvent::MouseMove, to, keys);
    mouse(QEvent::MouseButtonRelease, to, keys);
  }
  void wait() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return bench.pull.answer() && !bench.pull.isSearching(); }, tests::kPatience));
  }
};

TEST_F(PullCardTest, AltAndDragOpensItAndEnterMakesTheEdit) {
  const double place = bench.scene.value(bench.scene.xInput());
  drag(pixelOf(8, .5), pixelOf(8, .4), Qt::AltModifier);
  ASSERT_EQ(bench.pull.state(), State::kChoosing);
  EXPECT_FALSE(bench.pull.expert()) << "the mean lies over the others";
  EXPECT_NEAR(bench.pull.wish().force_n, .4, .02);
  EXPECT_EQ(bench.scene.value(bench.scene.xInput()), place) << "the operating point stays";
  wait();
  ASSERT_NE(card(), nullptr);
  EXPECT_TRUE(bench.window.rect().contains(card()->geometry()));
  ASSERT_FALSE(bench.pull.answer()->offers.empty());
  const auto before = bench.edits.model();
  QTest::keyClick(card(), Qt::Key_Return);
  EXPECT_NE(bench.edits.model(), before);
  EXPECT_TRUE(bench.edits.canUndo());
  EXPECT_EQ(bench.pull.state(), State::kIdle);
}

TEST_F(PullCardTest, EscapeLeavesEverythingAsItWas) {
  const auto before = bench.edits.model();
  emit bench.views.curves->pullAsked();
  ASSERT_NE(card(), nullptr);
  QTest::keyClick(card(), Qt::Key_Escape);
  EXPECT_EQ(bench.pull.state(), State::kIdle);
  EXPECT_EQ(bench.edits.model(), before);
  EXPECT_FALSE(bench.edits.canUndo());
}

TEST_F(PullCardTest, AForceCanBeTyped) {
  emit bench.views.curves->pullAsked();
  ASSERT_NE(card(), nullptr);
  NumberBox* wanted = nullptr;
  for (NumberBox* box : card()->findChildren<NumberBox*>()) {
    if (box->isVisible()) wanted = box;
  }
  ASSERT_NE(wanted, nullptr);
  wanted->selectAll();
  QTest::keyClicks(wanted, QStringLiteral("0.42"));
  QTest::keyClick(wanted, Qt::Key_Return);
  EXPECT_EQ(bench.pull.wish().force_n, .42);
}

TEST_F(PullCardTest, AltShiftAndDragDrawsABand) {
  drag(pixelOf(6, .6), pixelOf(9, .3), Qt::AltModifier | Qt::ShiftModifier);
  ASSERT_EQ(bench.pull.state(), State::kChoosing);
  const PullWish& wish = bench.pull.wish();
  EXPECT_EQ(wish.kind, PullWish::Kind::kBand);
  EXPECT_NEAR(wish.from, 6, .2);
  EXPECT_NEAR(wish.to, 9, .2);
  EXPECT_NEAR(wish.low_n, .3, .02);
  EXPECT_NEAR(wish.high_n, .6, .02);
}

// The drag by keys: the arrows move the wanted force at the operating point, Enter opens the offers, Escape drops it.
TEST_F(PullCardTest, ArrowsPullEnterOffersAndEscapeDrops) {
  auto& plot = *bench.views.curves->findChild<CurvePlot*>();
  const std::size_t x = bench.scene.xInput();
  bench.scene.setValue(x, 8);
  plot.setFocus(Qt::TabFocusReason);
  ASSERT_TRUE(plot.hasFocus());
  QTest::keyClick(&plot, Qt::Key_Right);
  EXPECT_GT(bench.scene.value(x), 8) << "without a pull the operating point moves";
  QTest::keyClick(&plot, Qt::Key_Left);
  EXPECT_EQ(bench.scene.value(x), 8);
  const double step = .01;  // a hundredth of 1 N
  QTest::keyClick(&plot, Qt::Key_Down);
  ASSERT_EQ(bench.pull.state(), State::kPulling);
  EXPECT_EQ(bench.pull.wish().from, 8);
  EXPECT_NEAR(bench.pull.wish().force_n, .5 - step, 1e-9);
  QTest::keyClick(&plot, Qt::Key_PageDown);
  QTest::keyClick(&plot, Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_NEAR(bench.pull.wish().force_n, .5 - 11 * step + step / 10, 1e-9);
  QTest::keyClick(&plot, Qt::Key_Escape);
  EXPECT_EQ(bench.pull.state(), State::kIdle);
  QTest::keyClick(&plot, Qt::Key_Down);
  QTest::keyClick(&plot, Qt::Key_Return);
  EXPECT_EQ(bench.pull.state(), State::kChoosing);
  ASSERT_NE(card(), nullptr);
  QTest::keyClick(card(), Qt::Key_Escape);
  EXPECT_EQ(bench.pull.state(), State::kIdle);
  EXPECT_TRUE(plot.hasFocus()) << "the keys go back to the curves";
}

TEST_F(PullCardTest, APinIsToldInTheCardAndTakenAwayThere) {
  emit bench.views.curves->pinAsked(9);
  ASSERT_EQ(bench.pull.pins().size(), 1U);
  EXPECT_EQ(bench.pull.pins()[0][bench.scene.xInput()], 9);
  emit bench.views.curves->pullAsked();
  ASSERT_NE(card(), nullptr);
  QPushButton* away = nullptr;
  for (QPushButton* button : card()->findChildren<QPushButton*>()) {
    if (button->isVisible() && button->text() == QStringLiteral("Take the pins away")) away = button;
  }
  ASSERT_NE(away, nullptr);
  away->click();
  EXPECT_TRUE(bench.pull.pins().empty());
  EXPECT_FALSE(away->isVisible());
}

TEST_F(PullCardTest, AnotherStageClosesIt) {
  emit bench.views.curves->pullAsked();
  ASSERT_NE(card(), nullptr);
  bench.window.enter(Stage::kTune);
  EXPECT_EQ(bench.pull.state(), State::kIdle);
}

}  // namespace
}  // namespace tactus::workbench
