#include "app/workbench/tune/history/carry_dialog.h"

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QTest>
#include <gtest/gtest.h>

#include "app/editing/membership_edits.h"
#include "app/editing/rule_edits.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/tune/history/history_panel.h"

#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"
#include "tests/gui/shown_bench.h"

namespace tactus::workbench {
namespace {

using tests::kNearShoulder;

class CarryDialogTest : public tests::ShownBench {
 protected:
  CarryDialogTest() : ShownBench(Stage::kTune) {}

  void SetUp() override {
    ShownBench::SetUp();
    dialog = bench.window.findChild<CarryDialog*>();
    table = dialog->findChild<QTableView*>();
    ASSERT_TRUE(bench.edits.apply(editing::moveVertex(bench.edits.model(), kNearShoulder, 3)));
    ASSERT_TRUE(bench.edits.apply(editing::setExpertWeight(bench.edits.model(), "B", 0.5)));
    tuned = bench.edits.history().current();
  }
  void buildAnew() {
    fuzzy::ForceModel model = tests::twoExperts();
    model.created_utc = "2026-11-28T08:00:00Z";
    ASSERT_TRUE(bench.edits.apply(editing::finished(model, "Built anew")));
  }
  QAction* action() {
    for (QAction* one : bench.window.menus().menu(MenuSlot::kEditStates).actions()) {
      if (one->text().remove(QLatin1Char('&')).startsWith(QStringLiteral("Carry earlier"))) return one;
    }
    return nullptr;
  }
  bool isComplete() {
    return QTest::qWaitFor(
        [&] {
          return table->model()->rowCount() == 2 && !bench.carry.list().isBusy() && !bench.carry.sum().isBusy() &&
                 bench.carry.together() != nullptr;
        },
        tests::kPatience);
  }
  QString cell(int row, int column) const { return table->model()->index(row, column).data().toString(); }
  PrimaryButton* go() const { return dialog->findChild<PrimaryButton*>(); }

  CarryDialog* dialog = nullptr;
  QTableView* table = nullptr;
  editing::StateId tuned = 0;
};

TEST_F(CarryDialogTest, TheMenuOffersTheEditsOfTheVersionBeforeTheBuild) {
  action()->trigger();
  EXPECT_FALSE(dialog->isVisible());  // there is no other build
  buildAnew();
  action()->trigger();
  ASSERT_TRUE(dialog->isVisible());
  ASSERT_TRUE(isComplete());
  EXPECT_EQ(go()->text(), QStringLiteral("Carry over 2 edits"));
  EXPECT_TRUE(cell(0, 3).contains(QStringLiteral("JND")) || cell(1, 3).contains(QStringLiteral("JND")));
  go()->click();
  EXPECT_FALSE(dialog->isVisible());
  EXPECT_EQ(bench.edits.model().experts[1].weight, 0.5);
  EXPECT_EQ(bench.edits.undoText(), QStringLiteral("2 edits carried over"));
}

TEST_F(CarryDialogTest, AKeyTakesAnEditOut) {
  buildAnew();
  emit bench.window.findChild<HistoryPanel*>()->carryAsked(tuned);
  ASSERT_TRUE(isComplete());
  table->setCurrentIndex(table->model()->index(0, 0));
  QTest::keyClick(table, Qt::Key_Space);
  EXPECT_EQ(bench.carry.chosenCount(), 1U);
  EXPECT_EQ(go()->text(), QStringLiteral("Carry over 1 edit"));
  QTest::keyClick(table, Qt::Key_Space);
  EXPECT_EQ(bench.carry.chosenCount(), 2U);
}

TEST_F(CarryDialogTest, TheSelectedEditIsTheGhostOfTheCurvesUntilTheDialogCloses) {
  buildAnew();
  emit bench.window.findChild<HistoryPanel*>()->carryAsked(tuned);
  ASSERT_TRUE(isComplete());
  table->selectRow(1);
  EXPECT_TRUE(bench.ghost.hasReference());
  EXPECT_TRUE(bench.ghost.label().startsWith(QStringLiteral("With: ")));
  dialog->close();
  EXPECT_FALSE(bench.ghost.hasReference());
  EXPECT_FALSE(bench.carry.isActive());
}

TEST_F(CarryDialogTest, AVersionWithoutFurtherEditsIsSaid) {
  buildAnew();
  emit bench.window.findChild<HistoryPanel*>()->carryAsked(0);
  const auto says = [&](const QString& part) {
    const auto labels = dialog->findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](const QLabel* one) { return one->text().contains(part); });
  };
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return says(QStringLiteral("has no edit that the open model lacks")); }, tests::kPatience));
  EXPECT_FALSE(go()->isEnabled());
}

}  // namespace
}  // namespace tactus::workbench
