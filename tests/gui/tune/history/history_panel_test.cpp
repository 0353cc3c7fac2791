#include "app/workbench/tune/history/history_panel.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <gtest/gtest.h>

#include "app/editing/membership_edits.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/tune/history/compare_strip.h"
#include "app/workbench/tune/history/history_model.h"

#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"
#include "tests/gui/shown_bench.h"

namespace tactus::workbench {
namespace {

using tests::kNearShoulder;

class HistoryPanelTest : public tests::ShownBench {
 protected:
  HistoryPanelTest() : ShownBench(Stage::kTune) {}

  void SetUp() override {
    ShownBench::SetUp();
    bench.window.activateWindow();
    panel = bench.window.findChild<HistoryPanel*>();
    view = panel->findChild<QListView*>();
  }

  void edit(double to) { ASSERT_TRUE(bench.edits.apply(editing::moveVertex(bench.edits.model(), kNearShoulder, to))); }
  double shoulder() const { return bench.models.current()->model.inputs[1].terms[0].points[2]; }

  void reveal() {
    auto* dock = bench.window.findChild<QDockWidget*>(QStringLiteral("history"));
    dock->show();
    dock->raise();
    ASSERT_TRUE(QTest::qWaitFor([&] { return view->isVisible() && rows() > 0; }, tests::kPatience));
  }
  /// The part with comparison, sign-off and author; a narrow panel shows it instead of the versions.
  void revealSide() {
    action(Qt::CTRL | Qt::SHIFT | Qt::Key_G)->trigger();
    auto* who = named<QComboBox>(QStringLiteral("Expert who signs off"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return who->isVisible(); }, tests::kPatience));
  }
  int rows() const { return view->model()->rowCount(); }
  bool waitForRows(int count) const {
    return QTest::qWaitFor([&] { return rows() == count; }, tests::kPatience);
  }
  QString cell(int row, int role = Qt::DisplayRole) const { return view->model()->index(row, 0).data(role).toString(); }
  void click(int row) {
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, view->visualRect(view->model()->index(row, 0)).center());
  }

  template <class Widget>
  Widget* named(const QString& name) const {
    const QList<Widget*> all = bench.window.findChildren<Widget*>();
    const auto found = std::find_if(all.begin(), all.end(), [&](auto* w) { return w->accessibleName() == name; });
    return found == all.end() ? nullptr : *found;
  }
  QAction* action(const QKeySequence& keys) {
    const auto all = bench.window.menus().menu(MenuSlot::kEditUndo).actions();
    const auto found = std::find_if(all.begin(), all.end(), [&](auto* a) { return a->shortcut() == keys; });
    return found == all.end() ? nullptr : *found;
  }

  HistoryPanel* panel = nullptr;
  QListView* view = nullptr;
};

TEST_F(HistoryPanelTest, ShowsBranchesAndAClickReturnsToAnyState) {
  reveal();
  edit(3);
  edit(2);
  bench.edits.undo();
  edit(1);
  ASSERT_TRUE(waitForRows(4));
  click(2);  // the branch with 2
  EXPECT_EQ(shoulder(), 2);
  ASSERT_TRUE(QTest::qWaitFor([&] { return view->currentIndex().row() == 3; }, tests::kPatience));
  click(0);
  EXPECT_EQ(bench.models.current()->model, tests::twoExperts());
  EXPECT_EQ(rows(), 4);
}

TEST_F(HistoryPanelTest, ARowSaysWhatTheEditDid) {
  reveal();
  // The centroid of high rises from 0.75 to 0.8 N where only A has a force; noticeable there is 0.0985 N.
  bench.edits.apply(editing::moveEdge(bench.edits.model(), {{"force", ""}, "high"}, editing::Side::kLeft, 0.1));
  ASSERT_TRUE(waitForRows(2));
  EXPECT_TRUE(cell(1).contains(QStringLiteral("High")));
  EXPECT_TRUE(
      cell(1, HistoryModel::kEffectRole).startsWith(QStringLiteral("max ΔF anywhere at least 0.050 N (0.5 JND) · ")));
}

TEST_F(HistoryPanelTest, TheAuthorIsTypedOnceAndKept) {
  reveal();
  edit(3);
  ASSERT_TRUE(waitForRows(2));
  EXPECT_TRUE(cell(1, HistoryModel::kEffectRole).endsWith(QStringLiteral("unnamed")));
  revealSide();
  auto* field = named<QLineEdit>(QStringLiteral("Your name"));
  QTest::keyClicks(field, QStringLiteral("M. Ortiz"));
  QTest::keyClick(field, Qt::Key_Return);
  edit(2);
  action(Qt::CTRL | Qt::SHIFT | Qt::Key_N)->trigger();
  ASSERT_TRUE(waitForRows(3));
  EXPECT_TRUE(cell(2, HistoryModel::kEffectRole).endsWith(QStringLiteral("M. Ortiz")));

  EditController later{bench.models};
  const AuthorName kept(settings, later);
  EXPECT_EQ(kept.name(), QStringLiteral("M. Ortiz"));
  EXPECT_EQ(later.author(), QStringLiteral("M. Ortiz"));
}

TEST_F(HistoryPanelTest, AStateIsNamedInPlace) {
  edit(3);
  action(Qt::CTRL | Qt::SHIFT | Qt::Key_N)->trigger();
  ASSERT_TRUE(waitForRows(2));
  auto* field = named<QLineEdit>(QStringLiteral("Name of a snapshot"));
  EXPECT_TRUE(QTest::qWaitFor([&] { return field->hasFocus(); }, tests::kPatience));
  QTest::keyClicks(field, QStringLiteral("steeper"));
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(field->text(), QString());
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        return view->model()->index(1, 0).data(HistoryModel::kSnapshotsRole).toStringList() == QStringList{"steeper"};
      },
      tests::kPatience));
  EXPECT_EQ(bench.edits.history().events().back().kind, editing::EventKind::kSnapshot);
}

TEST_F(HistoryPanelTest, AnExpertSignsOff) {
  revealSide();
  edit(3);
  edit(2);
  auto* who = named<QComboBox>(QStringLiteral("Expert who signs off"));
  ASSERT_EQ(who->count(), 2);
  who->setCurrentText(QStringLiteral("B"));
  QTest::mouseClick(named<QPushButton>(QStringLiteral("Approve unfelt")), Qt::LeftButton);
  const editing::Event& event = bench.edits.history().events().back();
  EXPECT_EQ(event.kind, editing::EventKind::kSignOff);
  EXPECT_EQ(event.stamp.author, "B");
  EXPECT_EQ(event.label, "approved without feeling, after 2 edits");
  EXPECT_EQ(event.state, bench.edits.history().current());
}

TEST_F(HistoryPanelTest, TheStripSaysWhatIsShownAndTheKeySwitches) {
  auto* strip = bench.window.findChild<CompareStrip*>();
  EXPECT_FALSE(strip->isVisible());
  edit(3);
  action(Qt::CTRL | Qt::Key_B)->trigger();
  ASSERT_TRUE(strip->isVisible());
  const auto says = [&](const QString& words) {
    const auto labels = strip->findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](auto* label) { return label->text().contains(words); });
  };
  EXPECT_TRUE(QTest::qWaitFor([&] { return says(QStringLiteral("B is on the screen: Before the last edit")); },
                              tests::kPatience));
  EXPECT_EQ(bench.scene.model()->model, tests::twoExperts());
  action(Qt::CTRL | Qt::Key_B)->trigger();
  EXPECT_TRUE(QTest::qWaitFor([&] { return says(QStringLiteral("A is on the screen")); }, tests::kPatience));
  EXPECT_EQ(bench.scene.model()->model, bench.models.current()->model);
  action(Qt::CTRL | Qt::SHIFT | Qt::Key_B)->trigger();
  EXPECT_FALSE(strip->isVisible());
}

TEST_F(HistoryPanelTest, TheSideThatIsNotShownIsTheGhostOfTheCurves) {
  edit(3);
  action(Qt::CTRL | Qt::Key_B)->trigger();
  ASSERT_TRUE(bench.ghost.hasReference());
  EXPECT_EQ(bench.ghost.before()->model, bench.models.current()->model);
  EXPECT_EQ(bench.ghost.label(), QStringLiteral("Open model, mean of 2 experts"));
  action(Qt::CTRL | Qt::Key_B)->trigger();
  EXPECT_EQ(bench.ghost.before()->model, tests::twoExperts());
  action(Qt::CTRL | Qt::SHIFT | Qt::Key_B)->trigger();
  EXPECT_FALSE(bench.ghost.hasReference());
}

TEST_F(HistoryPanelTest, TheComparisonSetsTheOperatingPointToTheLargestDifference) {
  bench.compare.choose(CompareSide::kB, {CompareChoice::Kind::kExpert, 0, "B"});
  revealSide();
  auto* go = named<QPushButton>(QStringLiteral("Go there"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return bench.compare.result() && go->isVisible(); }, tests::kPatience));
  bench.scene.setValue(1, 0);
  QTest::mouseClick(go, Qt::LeftButton);
  // Only far from the entrance both have a force, and it is 0.25 N apart everywhere there.
  EXPECT_GT(bench.scene.value(1), 6);
  EXPECT_EQ(bench.scene.value(1), bench.compare.result()->at[1]);
}

TEST_F(HistoryPanelTest, TheComparisonListsTheTermsAndRulesThatDiffer) {
  revealSide();
  auto other = bench.edits.model();
  other.experts[0].rules[0].weight = 0.5;
  bench.edits.apply(editing::finished(other, "weight"));
  ASSERT_TRUE(QTest::qWaitFor([this] { return bench.compare.result().has_value(); }, tests::kPatience));
  settle();
  const auto* const changes = bench.window.findChild<QLabel*>(QStringLiteral("compare_changes"));
  ASSERT_NE(changes, nullptr);
  // From before the edit (B) to the model as it is (A).
  EXPECT_TRUE(changes->text().contains(QStringLiteral("B → A"))) << changes->text().toStdString();
  EXPECT_TRUE(changes->text().contains(QStringLiteral("rule of A: depth near, speed slow: ")))
      << changes->text().toStdString();
  EXPECT_TRUE(changes->text().endsWith(QStringLiteral("0.5"))) << changes->text().toStdString();
}

TEST_F(HistoryPanelTest, StatesOfAnotherHistoryAreGoneAtOnce) {
  reveal();
  for (const double to : {4.5, 4.6, 4.7}) edit(to);
  ASSERT_TRUE(waitForRows(4));
  bench.models.open(folder.write(tests::twoExperts(), QStringLiteral("other.tactus.json")));
  panel->grab();  // a window that is uncovered now is painted before the panel refreshes
  EXPECT_EQ(rows(), 0);
  // What a menu or a list that is still open offers.
  bench.edits.returnTo(3);
  EXPECT_FALSE(bench.edits.canUndo());
  bench.compare.choose(CompareSide::kB, {CompareChoice::Kind::kState, 3, {}});
  EXPECT_NE(bench.compare.choice(CompareSide::kB).kind, CompareChoice::Kind::kState);
  EXPECT_TRUE(waitForRows(1));
}

TEST_F(HistoryPanelTest, ANameAndItsButtonAreOneStopOfTab) {
  reveal();
  edit(3);
  ASSERT_TRUE(waitForRows(2));
  auto* name = named<QLineEdit>(QStringLiteral("Name of a snapshot"));
  name->setText(QStringLiteral("soft"));
  settle();
  const QList<QWidget*> stops = readingOrder(*panel);
  EXPECT_TRUE(stops.contains(view));
  EXPECT_TRUE(stops.contains(name));
  name->setFocus();
  name->setCursorPosition(4);
  QTest::keyClick(name, Qt::Key_Right);
  auto* button = qobject_cast<QPushButton*>(bench.window.focusWidget());
  ASSERT_NE(button, nullptr);
  EXPECT_EQ(button->text(), QStringLiteral("Name version"));
  EXPECT_FALSE(stops.contains(button));
}

}  // namespace
}  // namespace tactus::workbench
