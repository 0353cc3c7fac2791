// The list of all rules below the grids, and the form for rules in free form.
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <gtest/gtest.h>

#include "app/editing/edit.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/number_box.h"
#include "app/workbench/tune/rules/rule_editor.h"

#include "tests/gui/tune/rules/rule_editor_fixture.h"

namespace tactus::workbench {
namespace {

using tests::kPatience;

using RuleListTest = tests::RuleEditorFixture;

TEST_F(RuleListTest, TheListIsFilteredByWordsAndByKind) {
  QTableView* table = openList();
  auto* text = named<QLineEdit>("Filter by words of the rule");
  QTest::keyClicks(text, QStringLiteral("well and esoph"));
  EXPECT_TRUE(waitForRows(table, 1));
  EXPECT_EQ(at(table, 0, RuleListModel::kNumber).data().toInt(), 4);
  text->clear();
  QTest::keyClicks(text, QStringLiteral("if speed fast then very_large"));
  EXPECT_TRUE(waitForRows(table, 3));
  text->clear();

  auto* only = named<QComboBox>("Which rules are listed");
  scene.setValue(0, 1);
  scene.setValue(1, 0);
  scene.setValue(2, 30);
  scene.setValue(3, 0);
  only->setCurrentIndex(1);  // acting here: well, small and slow in the nasal cavity
  EXPECT_TRUE(waitForRows(table, 3));
  scene.setValue(2, 130);  // Table A2 has no oropharynx
  EXPECT_TRUE(waitForRows(table, 0));
  only->setCurrentIndex(2);
  EXPECT_TRUE(waitForRows(table, 0));
  rules.enable({5, 6}, false);
  EXPECT_TRUE(waitForRows(table, 2));
  only->setCurrentIndex(3);
  ASSERT_TRUE(rules.add({{{"lubrication", "well"}, {"depth", "esophagus"}}, "very_large"}));
  EXPECT_TRUE(waitForRows(table, 2));
  only->setCurrentIndex(0);
  EXPECT_TRUE(waitForRows(table, 46));
}

TEST_F(RuleListTest, AKeyAnswersAllSelectedRulesInOneStep) {
  QTableView* table = openList();
  selection.selectRules({0, 1, 4});
  ASSERT_TRUE(QTest::qWaitFor([&] { return table->selectionModel()->selectedRows().size() == 3; }, kPatience));
  QTest::keyClick(table, Qt::Key_4);
  for (const std::size_t r : {0, 1, 4}) EXPECT_EQ(rule(r).then, "large");
  EXPECT_EQ(selection.rules(), (std::vector<std::size_t>{0, 1, 4}));
  edits.undo();
  EXPECT_EQ(edits.model().experts[0].rules, start.experts[0].rules);
}

TEST_F(RuleListTest, RulesAreCopiedAndPastedAsText) {
  QTableView* table = openList();
  selection.selectRules({3});
  ASSERT_TRUE(QTest::qWaitFor([&] { return table->selectionModel()->selectedRows().size() == 1; }, kPatience));
  QTest::keySequence(table, QKeySequence::Copy);
  EXPECT_EQ(QApplication::clipboard()->text().trimmed(),
            QStringLiteral("IF Tube lubrication is well AND Depth is esophagus THEN Force is medium"));
  QApplication::clipboard()->setText(QStringLiteral("IF Tube lubrication is well AND Depth is esophagus THEN large"));
  QTest::keySequence(table, QKeySequence::Paste);
  EXPECT_EQ(rule(3).then, "large");
  EXPECT_EQ(count(), 45U);
}

TEST_F(RuleListTest, TheListIsSortedByItsHeads) {
  QTableView* table = openList();
  rules.setWeight({20}, 0.5);
  auto* head = table->horizontalHeader();
  const auto press = [&](int column) {
    QTest::mouseClick(head->viewport(), Qt::LeftButton, {},
                      QPoint(head->sectionViewportPosition(column) + head->sectionSize(column) / 2, 8));
  };
  press(RuleListModel::kWeight);
  EXPECT_TRUE(QTest::qWaitFor([&] { return at(table, 0, RuleListModel::kNumber).data().toInt() == 21; }, kPatience));
  press(RuleListModel::kConsequent);
  EXPECT_EQ(at(table, 0, RuleListModel::kConsequent).data().toString(), QStringLiteral("very_small"));
  EXPECT_EQ(at(table, 44, RuleListModel::kConsequent).data().toString(), QStringLiteral("very_large"));
  press(RuleListModel::kNumber);
  EXPECT_EQ(at(table, 0, RuleListModel::kNumber).data().toInt(), 1);
}

TEST_F(RuleListTest, ARowIsEditedInItsPlace) {
  QTableView* table = openList();
  const QRect box = table->visualRect(at(table, 0, RuleListModel::kEnabled));
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, QPoint(box.left() + 10, box.center().y()));
  EXPECT_FALSE(rules.expert().rules[0].enabled);

  const QModelIndex weight = at(table, 1, RuleListModel::kWeight);
  table->setCurrentIndex(weight);
  table->edit(weight);
  auto* number = table->viewport()->findChild<NumberBox*>();
  ASSERT_NE(number, nullptr);
  QTest::keyClicks(number, QStringLiteral("0.4"));
  QTest::keyClick(number, Qt::Key_Return);
  EXPECT_TRUE(QTest::qWaitFor([&] { return rules.expert().rules[1].weight == 0.4; }, kPatience));

  const QModelIndex word = at(table, 2, RuleListModel::kConsequent);
  table->setCurrentIndex(word);
  table->edit(word);
  auto* words = table->viewport()->findChild<QComboBox*>();
  ASSERT_NE(words, nullptr);
  ASSERT_EQ(words->count(), 5);
  words->setCurrentIndex(4);
  emit words->activated(4);
  EXPECT_EQ(rules.expert().rules[2].then, "very_large");
  EXPECT_EQ(edits.history().line().size(), 4U);
  for (int i = 0; i < 3; ++i) edits.undo();
  EXPECT_TRUE(editing::sameBits(edits.model(), start));
}

TEST_F(RuleListTest, SeveralRulesAreDisabledEnabledAndRemoved) {
  QTableView* table = openList();
  clickRow(table, 1);
  clickRow(table, 3, Qt::ShiftModifier);
  QTest::mouseClick(button<QToolButton>("Disable"), Qt::LeftButton);
  EXPECT_FALSE(rules.expert().rules[2].enabled);
  EXPECT_EQ(edits.undoText(), QStringLiteral("S4: 3 rules, disabled"));
  QTest::keyClick(table, Qt::Key_Space);
  EXPECT_TRUE(rules.expert().rules[2].enabled);
  QTest::keyClick(table, Qt::Key_Delete);
  EXPECT_EQ(count(), 42U);
  QTest::keyClick(table, Qt::Key_Delete);  // at once: what was selected is gone
  EXPECT_EQ(count(), 42U);
  EXPECT_EQ(rules.expert().rules[1], start.experts[0].rules[4]);
}

TEST_F(RuleListTest, ARuleInFreeFormHasUpToFourConditions) {
  openList();
  QTest::mouseClick(button<QToolButton>("Add rule…"), Qt::LeftButton);
  auto* form = editor.findChild<RuleForm*>();
  ASSERT_TRUE(form->isVisible());
  const auto choose = [&](const char* input, int row) {
    const QList<QComboBox*> boxes = form->findChildren<QComboBox*>();
    for (QComboBox* box : boxes) {
      if (box->accessibleName() == QLatin1String(input)) box->setCurrentIndex(row);
    }
  };
  const auto message = [&] { return named<QLabel>("The problem with the rule")->text(); };
  auto* accept = form->findChild<QPushButton*>();

  QTest::mouseClick(accept, Qt::LeftButton);
  EXPECT_EQ(message(), QStringLiteral("S4: found a rule without a condition, wanted one condition or more"));
  EXPECT_EQ(count(), 45U);

  choose("Tube lubrication", 3);  // any, poor, medium, well
  choose("Depth", 1);
  QTest::mouseClick(accept, Qt::LeftButton);
  EXPECT_TRUE(message().contains(QStringLiteral("the same as rule 1"))) << message().toStdString();
  EXPECT_EQ(count(), 45U);

  choose("Neck flexion", 2);
  choose("Speed", 3);
  choose("Consequent of the rule", 4);
  auto* weight = named<NumberBox>("Weight of the rule");
  weight->selectAll();
  QTest::keyClicks(weight, QStringLiteral("0.75"));
  QTest::keyClick(weight, Qt::Key_Return);  // adds
  ASSERT_EQ(count(), 46U);
  const fuzzy::Rule& added = rules.expert().rules.back();
  EXPECT_EQ(added.conditions,
            (std::vector<fuzzy::Condition>{
                {"lubrication", "well"}, {"neck_flexion", "medium"}, {"depth", "nasal_cavity"}, {"speed", "fast"}}));
  EXPECT_EQ(added.then, "very_large");
  EXPECT_EQ(added.weight, 0.75);
  EXPECT_EQ(message(), QStringLiteral("Added as rule 46."));
}

TEST_F(RuleListTest, ARuleIsRewritten) {
  QTableView* table = openList();
  const QModelIndex third = at(table, 2, RuleListModel::kConditions);
  QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(third).center());
  clickRow(table, 2);
  QTest::mouseClick(button<QToolButton>("Edit…"), Qt::LeftButton);
  auto* form = editor.findChild<RuleForm*>();
  ASSERT_TRUE(form->isVisible());
  for (QComboBox* box : form->findChildren<QComboBox*>()) {
    if (box->accessibleName() == QStringLiteral("Speed")) box->setCurrentIndex(1);
  }
  QTest::keyClick(form, Qt::Key_Return);
  EXPECT_FALSE(form->isVisible());
  ASSERT_EQ(count(), 45U);
  EXPECT_EQ(rules.expert().rules[2].conditions.size(), 3U);
  EXPECT_EQ(rules.expert().rules[2].conditions.back(), (fuzzy::Condition{"speed", "slow"}));
}

TEST_F(RuleListTest, AFormFollowsWhatHappensMeanwhile) {
  QTableView* table = openList();
  clickRow(table, 4);
  QTest::mouseClick(button<QToolButton>("Edit…"), Qt::LeftButton);
  auto* form = editor.findChild<RuleForm*>();
  rules.remove({0});
  const auto says = [&](const char* text) {
    return QTest::qWaitFor([&] { return form->findChild<QPushButton*>()->text() == QLatin1String(text); }, kPatience);
  };
  EXPECT_TRUE(says("Rewrite rule 4"));
  rules.remove({3});
  EXPECT_TRUE(says("Add rule"));
  edits.undo();
  QTest::keyClick(form, Qt::Key_Escape);
  EXPECT_FALSE(form->isVisible());
}

TEST_F(RuleListTest, AWeightWithManyDigitsKeepsThem) {
  rules.setWeight({2}, 1.0 / 3);
  QTableView* table = openList();
  const QModelIndex weight = at(table, 2, RuleListModel::kWeight);
  table->setCurrentIndex(weight);
  table->edit(weight);
  auto* number = table->viewport()->findChild<NumberBox*>();
  ASSERT_NE(number, nullptr);
  QTest::keyClick(number, Qt::Key_Return);  // as it is
  QCoreApplication::processEvents();
  EXPECT_EQ(rule(2).weight, 1.0 / 3);
  EXPECT_EQ(edits.history().line().size(), 2U);

  clickRow(table, 2);
  QTest::mouseClick(button<QToolButton>("Edit…"), Qt::LeftButton);
  auto* form = editor.findChild<RuleForm*>();
  ASSERT_TRUE(form->isVisible());
  named<QComboBox>("Consequent of the rule")->setCurrentIndex(4);
  QTest::keyClick(form, Qt::Key_Return);
  EXPECT_EQ(rule(2).then, "very_large");
  EXPECT_EQ(rule(2).weight, 1.0 / 3);
}

TEST_F(RuleListTest, TheColorOfARefusalFollowsTheLook) {
  openList();
  QTest::mouseClick(button<QToolButton>("Add rule…"), Qt::LeftButton);
  QTest::mouseClick(editor.findChild<RuleForm*>()->findChild<QPushButton*>(), Qt::LeftButton);
  const auto color = [&] { return named<QLabel>("The problem with the rule")->palette().color(QPalette::WindowText); };
  EXPECT_EQ(color(), theme::errorInk());
  theme::changeLook(*qApp, theme::Look::kDark);
  EXPECT_EQ(color(), theme::errorInk());
  theme::changeLook(*qApp, theme::Look::kLight);
  EXPECT_EQ(color(), theme::errorInk());
}

TEST_F(RuleListTest, TheRowsAroundTheListAreOneStopEach) {
  QTableView* table = openList();
  auto* pane = qobject_cast<RuleListPane*>(table->parentWidget());
  ASSERT_NE(pane, nullptr);
  // The filter, the list, the acts.
  const QList<QWidget*> stops = readingOrder(*pane);
  ASSERT_EQ(stops.size(), 3);
  EXPECT_EQ(stops[0], named<QLineEdit>("Filter by words of the rule"));
  EXPECT_EQ(stops[1], table);
  auto* add = qobject_cast<QToolButton*>(stops[2]);
  ASSERT_NE(add, nullptr);
  EXPECT_EQ(add->text(), QStringLiteral("Add rule…"));
  // Without a rule to edit, the arrow passes over what cannot be pressed.
  selection.selectRules({2});
  ASSERT_TRUE(QTest::qWaitFor([&] { return table->selectionModel()->selectedRows().size() == 1; }, kPatience));
  add->setFocus();
  QTest::keyClick(add, Qt::Key_Right);
  EXPECT_EQ(qobject_cast<QToolButton*>(QApplication::focusWidget())->text(), QStringLiteral("Edit…"));
}

}  // namespace
}  // namespace tactus::workbench
