#include "app/workbench/tune/findings/findings_panel.h"

#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <gtest/gtest.h>

#include "app/workbench/kit/layout.h"
#include "app/workbench/shell/panel_area.h"

#include "tests/gui/shown_bench.h"

namespace tactus::workbench {
namespace {

using tests::kPatience;

class FindingsPanelTest : public tests::ShownBench {
 protected:
  FindingsPanelTest() : ShownBench(Stage::kTune) {}

  void look() {
    auto* dock = bench.window.findChild<QDockWidget*>(QStringLiteral("findings"));
    ASSERT_NE(dock, nullptr);
    dock->raise();
    ASSERT_TRUE(QTest::qWaitFor([&] { return panel().isVisible() && bench.findings.isCurrent(); }, kPatience));
    // The lint may have ended before; the panel takes it over when it is seen.
    const auto taken = [this] {
      const auto rows = static_cast<std::size_t>(list().model()->rowCount());
      return panel().isVisible() && rows == bench.findings.findings().size();
    };
    ASSERT_TRUE(QTest::qWaitFor(taken, kPatience));
  }

  FindingsPanel& panel() { return *bench.window.findChild<FindingsPanel*>(); }
  QListView& list() { return *panel().findChild<QListView*>(QStringLiteral("findings_list")); }

  void clickRow(int row) {
    const QModelIndex index = list().model()->index(row, 0);
    list().scrollTo(index);
    QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, list().visualRect(index).center());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !bench.findings.isLookingForFixes(); }, kPatience));
  }

  QPushButton* button(const QString& text) {
    for (auto* one : panel().findChildren<QPushButton*>()) {
      if (one->isVisible() && one->text() == text) return one;
    }
    return nullptr;
  }

  int rowOf(const QString& start) {
    for (int row = 0; row < list().model()->rowCount(); ++row) {
      if (list().model()->index(row, 0).data().toString().startsWith(start)) return row;
    }
    return -1;
  }
};

TEST_F(FindingsPanelTest, BehindAnotherTabTheLintIsKeptUpToDate) {
  QCoreApplication::processEvents();
  EXPECT_FALSE(panel().isVisible());
  ASSERT_TRUE(QTest::qWaitFor([&] { return bench.findings.isCurrent(); }, kPatience));
  look();
  EXPECT_GT(list().model()->rowCount(), 3);
}

TEST_F(FindingsPanelTest, AClickOnAFindingAndOneOnItsFixSettleIt) {
  look();
  clickRow(rowOf(QStringLiteral("No rule of any expert fires")));
  EXPECT_GE(bench.scene.value(1), 5);
  EXPECT_LE(bench.scene.value(1), 6);
  auto* const fix = button(QStringLiteral("Stretch Near over the gap"));
  ASSERT_NE(fix, nullptr);
  QTest::mouseClick(fix, Qt::LeftButton);
  EXPECT_EQ(bench.edits.model().inputs[1].terms[0].points, (std::vector<double>{0, 0, 6, 7}));
  ASSERT_TRUE(QTest::qWaitFor([&] { return bench.findings.isCurrent(); }, kPatience));
  EXPECT_EQ(rowOf(QStringLiteral("No rule of any expert fires")), -1);
  bench.edits.undo();
  EXPECT_EQ(bench.edits.model(), tests::twoExperts());
}

TEST_F(FindingsPanelTest, AClickOnARuleOfAFindingSelectsItInTheEditor) {
  look();
  const auto& all = bench.findings.findings();
  const auto with_rules = std::find_if(all.begin(), all.end(), [](const auto& one) { return !one.rules.empty(); });
  ASSERT_NE(with_rules, all.end());
  const RuleOfExpert rule = with_rules->rules.front();
  bench.findings.choose(static_cast<std::size_t>(with_rules - all.begin()));
  // Silently: the findings stay in front.
  EXPECT_EQ(bench.selection.expert(), rule.expert);
  EXPECT_FALSE(bench.selection.rules().empty());
  EXPECT_TRUE(panel().isVisible());
  auto* const button = panel().findChild<QToolButton*>(QStringLiteral("rule_0"));
  ASSERT_NE(button, nullptr);
  button->click();
  EXPECT_EQ(bench.selection.rule(), rule.rule);
  EXPECT_FALSE(panel().isVisible());
}

TEST_F(FindingsPanelTest, FiltersByKindAndExpert) {
  look();
  const int all = list().model()->rowCount();
  const auto choices = panel().findChildren<QComboBox*>();
  ASSERT_EQ(choices.size(), 3);  // the third one is the order
  QComboBox& kind = *choices[0];
  QComboBox& who = *choices[1];
  EXPECT_TRUE(kind.itemText(0).contains(QString::number(all)));
  kind.setCurrentIndex(1);
  emit kind.activated(1);
  const int of_kind = list().model()->rowCount();
  EXPECT_TRUE(kind.itemText(1).contains(QString::number(of_kind))) << kind.itemText(1).toStdString();
  EXPECT_LT(of_kind, all);
  kind.setCurrentIndex(0);
  emit kind.activated(0);
  who.setCurrentIndex(who.findText(QStringLiteral("A")));
  emit who.activated(who.currentIndex());
  EXPECT_GT(list().model()->rowCount(), 0);
  EXPECT_LT(list().model()->rowCount(), all);
}

TEST_F(FindingsPanelTest, SaysWhenNothingIsFound) {
  auto model = tests::twoExperts();
  model.experts.pop_back();
  model.inputs[1].terms[0].points = {0, 0, 6, 7};
  model.inputs[1].unit = "cm";  // in mm the force would step within 1 mm
  // Rules for both speeds at both depths, and all rise.
  model.experts[0].rules = {{{{"speed", "slow"}, {"depth", "near"}}, "low"},
                            {{{"speed", "fast"}, {"depth", "near"}}, "high"},
                            {{{"depth", "far"}}, "high"}};
  bench.models.open(folder.write(model, QStringLiteral("clean.tactus.json")));
  look();
  EXPECT_EQ(list().model()->rowCount(), 0);
  EXPECT_FALSE(list().isVisible());
  bool said = false;
  for (auto* label : panel().findChildren<QLabel*>()) {
    said = said || (label->isVisible() && label->text().startsWith(QStringLiteral("Nothing found")));
  }
  EXPECT_TRUE(said);
}

TEST_F(FindingsPanelTest, AListThatWasHiddenWhileAnotherModelWasOpenedIsPainted) {
  look();
  ASSERT_GT(list().model()->rowCount(), 3);
  bench.window.enter(Stage::kUnderstand);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !panel().isVisible(); }, kPatience));
  bench.models.open(folder.write(tests::twoExperts(), QStringLiteral("again.tactus.json")));
  bench.window.enter(Stage::kTune);
  // Before anything is linted anew.
  panel().grab();
  for (int row = 0; row < list().model()->rowCount(); ++row) {
    EXPECT_FALSE(list().model()->index(row, 0).data().toString().isEmpty());
  }
  look();
  EXPECT_GT(list().model()->rowCount(), 3);
}

TEST_F(FindingsPanelTest, EachRowIsOneStopOfTab) {
  look();
  clickRow(rowOf(QStringLiteral("No rule of any expert fires")));
  settle();
  // The filters, the list, the ways to the place, the fixes; where the message can be scrolled or copied it takes none.
  QStringList stops;
  for (const QWidget* stop : readingOrder(panel())) stops << QString::fromLatin1(stop->metaObject()->className());
  EXPECT_EQ(stops, (QStringList{QStringLiteral("QComboBox"), QStringLiteral("QListView"), QStringLiteral("QToolButton"),
                                QStringLiteral("QPushButton")}));
  auto* first = panel().findChild<QPushButton*>(QStringLiteral("fix_0"));
  auto* second = panel().findChild<QPushButton*>(QStringLiteral("fix_1"));
  ASSERT_NE(second, nullptr);
  bench.window.activateWindow();
  first->setFocus();
  QTest::keyClick(first, Qt::Key_Down);
  EXPECT_EQ(bench.window.focusWidget(), second);
}

}  // namespace
}  // namespace tactus::workbench
