#include "app/workbench/tune/rules/rule_editor.h"

#include <QApplication>
#include <QCheckBox>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <gtest/gtest.h>

#include "app/editing/edit.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/number_box.h"

#include "tests/gui/tune/rules/rule_editor_fixture.h"

namespace tactus::workbench {
namespace {

using tests::kPatience;

using RuleEditorTest = tests::RuleEditorFixture;

TEST_F(RuleEditorTest, ANumberKeyAnswersAndGoesOn) {
  click({0, 2, 4});  // well and esophagus: medium
  QTest::keyClick(grids, Qt::Key_5);
  EXPECT_EQ(answer({0, 2, 4}), "very_large");
  EXPECT_EQ(rules.selected(), (RuleCell{0, 2, 5}));
  QTest::keyClick(grids, Qt::Key_1, Qt::KeypadModifier);
  EXPECT_EQ(answer({0, 2, 5}), "very_small");
  EXPECT_EQ(rules.selected(), (RuleCell{1, 0, 0})) << "behind the last cell of a grid comes the next one";
  EXPECT_EQ(edits.history().line().size(), 2U) << "very small was the answer already";
}

TEST_F(RuleEditorTest, KeysBeyondTheWordsDoNothing) {
  click({0, 2, 4});
  QTest::keyClick(grids, Qt::Key_6);
  QTest::keyClick(grids, Qt::Key_0);
  QTest::keyClick(grids, Qt::Key_3, Qt::ControlModifier);
  EXPECT_FALSE(edits.canUndo());
  EXPECT_EQ(rules.selected(), (RuleCell{0, 2, 4}));
}

TEST_F(RuleEditorTest, DeleteEmptiesACellAndStays) {
  click({0, 2, 4});
  QTest::keyClick(grids, Qt::Key_Delete);
  EXPECT_FALSE(rules.cell({0, 2, 4}).rule);
  EXPECT_EQ(rules.selected(), (RuleCell{0, 2, 4}));
  QTest::keyClick(grids, Qt::Key_Left);
  QTest::keyClick(grids, Qt::Key_Backspace);
  EXPECT_EQ(count(), 43U);
  edits.undo();
  edits.undo();
  EXPECT_TRUE(editing::sameBits(edits.model(), start));
}

TEST_F(RuleEditorTest, KeysMoveAcrossTheGrids) {
  click({0, 2, 3});
  QTest::keyClick(grids, Qt::Key_Down);
  EXPECT_EQ(rules.selected(), (RuleCell{1, 0, 3}));
  QTest::keyClick(grids, Qt::Key_PageDown);
  EXPECT_EQ(rules.selected(), (RuleCell{2, 0, 3}));
  QTest::keyClick(grids, Qt::Key_End);
  QTest::keyClick(grids, Qt::Key_Space);
  EXPECT_EQ(rules.selected(), (RuleCell{2, 1, 0}));
  EXPECT_FALSE(edits.canUndo());
}

TEST_F(RuleEditorTest, TabLeavesTheGrids) {
  editor.activateWindow();
  grids->setFocus();
  ASSERT_TRUE(QTest::qWaitFor([&] { return grids->hasFocus(); }, kPatience));
  QTest::keyClick(grids, Qt::Key_Tab);
  EXPECT_FALSE(grids->hasFocus());
}

TEST_F(RuleEditorTest, AWordIsChosenWithTheMouse) {
  click({2, 0, 4});  // slow and esophagus: small
  auto* word = named<WordButton>("very_large");
  ASSERT_NE(word, nullptr);
  QTest::mouseClick(word, Qt::LeftButton);
  EXPECT_EQ(answer({2, 0, 4}), "very_large");
  EXPECT_EQ(rules.selected(), (RuleCell{2, 0, 5}));
  click({2, 0, 4});
  QTest::mouseClick(named<WordButton>("No answer"), Qt::LeftButton);
  EXPECT_FALSE(rules.cell({2, 0, 4}).rule);
}

TEST_F(RuleEditorTest, AMenuAnswersTheCellBelowTheMouse) {
  click({2, 0, 4});
  QTest::keyClick(grids, Qt::Key_Return);
  auto* menu = grids->findChild<QMenu*>();
  ASSERT_NE(menu, nullptr);
  ASSERT_EQ(menu->actions().size(), 9);  // five words, a line, no answer, go where it acts, where it comes from
  menu->actions()[3]->trigger();
  EXPECT_EQ(answer({2, 0, 4}), "large");
  EXPECT_EQ(rules.selected(), (RuleCell{2, 0, 4}));
}

TEST_F(RuleEditorTest, TheBarBelowHasWeightAndEnabled) {
  click({0, 2, 4});
  auto* weight = named<NumberBox>("Weight of the selected rule");
  weight->setFocus();
  weight->selectAll();
  QTest::keyClicks(weight, QStringLiteral("0.25"));
  QTest::keyClick(weight, Qt::Key_Return);
  EXPECT_EQ(rules.cell({0, 2, 4}).weight, 0.25);
  EXPECT_EQ(edits.history().line().size(), 2U);
  QTest::keyClick(weight, Qt::Key_Up);
  QTest::keyClick(weight, Qt::Key_Up);
  QTest::keyClick(weight, Qt::Key_Return);
  EXPECT_NEAR(rules.cell({0, 2, 4}).weight, 0.35, 1e-12);
  EXPECT_EQ(edits.history().line().size(), 3U);
  auto* enabled = named<QCheckBox>("The selected rule is enabled");
  QTest::mouseClick(enabled, Qt::LeftButton, {}, QPoint(8, enabled->height() / 2));
  EXPECT_FALSE(rules.cell({0, 2, 4}).enabled);
}

TEST_F(RuleEditorTest, EachMarkIsSeen) {
  scene.setValue(2, 30);  // nasal cavity: the cells looked at do not act
  const RuleCell place{0, 2, 4};
  click({2, 2, 0});
  const auto picture = [&] { return grids->grab(grids->cellRect(place)).toImage(); };
  const std::size_t rule = *rules.cell(place).rule;
  std::vector<QImage> pictures = {picture()};
  rules.setWeight({rule}, 0.5);
  pictures.push_back(picture());
  edits.undo();
  rules.enable({rule}, false);
  pictures.push_back(picture());
  edits.undo();
  scene.setValue(2, 300);  // esophagus
  pictures.push_back(picture());
  scene.setValue(2, 30);
  ASSERT_TRUE(rules.add({{{"lubrication", "well"}, {"depth", "esophagus"}}, "small"}));
  pictures.push_back(picture());
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(pictures[i], pictures[j]) << i << " and " << j;
  }
}

TEST_F(RuleEditorTest, AHiddenEditorComputesNothing) {
  editor.hide();
  const std::uint64_t before = scene.evaluations();
  for (int i = 0; i < 10; ++i) {
    scene.setValue(2, 10 * i);
    rules.setWeight({3}, 0.05 * (i + 1));
    QCoreApplication::processEvents();
  }
  EXPECT_EQ(scene.evaluations(), before);
  editor.show();
  EXPECT_TRUE(QTest::qWaitFor([&] { return scene.evaluations() > before; }, kPatience));
}

TEST_F(RuleEditorTest, NothingIsCutAtTheSmallestWindow) {
  EXPECT_LE(grids->minimumSizeHint().width(), 590 - 16);
  EXPECT_LE(editor.minimumSizeHint().width(), 590);
  for (const RuleCell& cell : {RuleCell{0, 0, 0}, RuleCell{2, 2, 5}}) {
    EXPECT_TRUE(grids->rect().contains(grids->cellRect(cell)));
    EXPECT_TRUE(editor.rect().contains(
        QRect(grids->mapTo(&editor, grids->cellRect(cell).topLeft()), grids->cellRect(cell).size())));
  }
}

TEST_F(RuleEditorTest, ATallPanelShowsGridsAndList) {
  auto* table = editor.findChild<QTableView*>();
  auto* tabs = editor.findChild<QTabBar*>();
  EXPECT_FALSE(table->isVisible());
  editor.resize(880, 980);
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return table->isVisible() && grids->isVisible() && !tabs->isVisible(); }, kPatience));
  EXPECT_TRUE(waitForRows(table, 45));
  editor.resize(590, 570);
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return !table->isVisible() && grids->isVisible() && tabs->isVisible(); }, kPatience));
}

TEST_F(RuleEditorTest, AnotherModelWithOtherWordsFits) {
  models.open(folder.write(tests::twoExperts(), QStringLiteral("two.tactus.json")));
  ASSERT_TRUE(QTest::qWaitFor([&] { return rules.selected().has_value(); }, kPatience));
  QCoreApplication::processEvents();
  click({0, 1, 1});  // fast and far
  QTest::keyClick(grids, Qt::Key_3);
  EXPECT_FALSE(edits.canUndo());
  QTest::keyClick(grids, Qt::Key_2);
  EXPECT_EQ(answer({0, 1, 1}), "high");
  EXPECT_EQ(named<WordButton>("very_large"), nullptr);
  QTableView* table = openList();
  EXPECT_EQ(table->model()->rowCount(), 4);
}

TEST_F(RuleEditorTest, CellsStandInTheirPlacesBeforeTheyAreShown) {
  models.open(folder.write(tests::twoExperts(), QStringLiteral("two.tactus.json")));
  ASSERT_TRUE(QTest::qWaitFor([&] { return rules.selected().has_value(); }, kPatience));
  QCoreApplication::processEvents();
  models.open(folder.write(start));
  // A window that is uncovered now is painted before the panel refreshes.
  grids->grab();
  const QRect last = grids->cellRect({2, 2, 5});
  click({1, 2, 3});
  EXPECT_EQ(rules.selected(), (RuleCell{1, 2, 3}));
  QTest::qWait(0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return grids->minimumSize() == grids->minimumSizeHint(); }, kPatience));
  EXPECT_EQ(grids->cellRect({2, 2, 5}).left(), last.left());
}

TEST_F(RuleEditorTest, TheColorOfAConflictFollowsTheLook) {
  ASSERT_TRUE(rules.add({{{"lubrication", "well"}, {"depth", "esophagus"}}, "very_large"}));
  click({0, 2, 4});
  const auto shown = [&] {
    for (const auto* label : editor.findChildren<QLabel*>()) {
      if (label->isVisible() && label->text().startsWith(QStringLiteral("Conflict"))) {
        return label->palette().color(QPalette::WindowText);
      }
    }
    return QColor();
  };
  EXPECT_EQ(shown(), theme::warningInk());
  const QColor light = theme::warningInk();
  theme::changeLook(*qApp, theme::Look::kDark);
  EXPECT_EQ(shown(), theme::warningInk());
  EXPECT_NE(shown(), light);
  theme::changeLook(*qApp, theme::Look::kLight);
  EXPECT_EQ(shown(), light);
  rules.answer(0);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !shown().isValid(); }, kPatience));
}

}  // namespace
}  // namespace tactus::workbench
