#include "app/workbench/views/rule_editor.h"

#include <QAbstractItemModel>
#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTabBar>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <gtest/gtest.h>

#include "app/editing/rule_edits.h"
#include "app/editing/same_bits.h"
#include "app/workbench/controllers/rule_controller.h"
#include "app/workbench/models/rule_list_model.h"
#include "app/workbench/views/number_box.h"
#include "app/workbench/views/rule_form.h"
#include "app/workbench/views/rule_grids.h"
#include "app/workbench/views/word_button.h"

#include "tests/gui/sample_models.h"
#include "tests/support/ngt_model.h"

namespace tactus::workbench {
namespace {

constexpr int kPatience = 10'000;  // ms, for a busy machine

// Grids: lubrication (poor, medium, well), neck flexion, speed (slow, medium, fast) against six regions of depth.
class RuleEditorTest : public testing::Test {
 protected:
  void SetUp() override {
    start = support::s4AsPrinted();
    start.created_utc = "2026-11-21T08:00:00Z";
    start.generator = "tactus tests";
    models.open(folder.write(start));
    editor.resize(590, 570);
    editor.show();
    grids = editor.findChild<RuleGrids*>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return rules.selected().has_value(); }, kPatience));
    QCoreApplication::processEvents();
  }

  void click(const RuleCell& cell) { QTest::mouseClick(grids, Qt::LeftButton, {}, grids->cellRect(cell).center()); }
  std::string answer(const RuleCell& cell) const { return rules.cell(cell).then; }
  std::size_t count() const { return rules.expert().rules.size(); }

  /// The widget with an accessible name.
  template <class Widget>
  Widget* named(const char* name) const {
    const QList<Widget*> all = editor.findChildren<Widget*>();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](auto* w) { return w->accessibleName() == QLatin1String(name); });
    return found == all.end() ? nullptr : *found;
  }
  template <class Button>
  Button* button(const char* text) const {
    const QList<Button*> all = editor.findChildren<Button*>();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](auto* b) { return b->text() == QString::fromUtf8(text); });
    return found == all.end() ? nullptr : *found;
  }

  QTableView* openList() {
    auto* tabs = editor.findChild<QTabBar*>();
    QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(1).center());
    auto* table = editor.findChild<QTableView*>();
    EXPECT_TRUE(QTest::qWaitFor([&] { return table->model()->rowCount() == static_cast<int>(count()); }, kPatience));
    return table;
  }
  static QModelIndex at(const QTableView* table, int row, int column) { return table->model()->index(row, column); }
  static void clickRow(QTableView* table, int row, Qt::KeyboardModifiers keys = {}) {
    const QModelIndex index = at(table, row, RuleListModel::kConditions);
    table->scrollTo(index);
    QTest::mouseClick(table->viewport(), Qt::LeftButton, keys, table->visualRect(index).center());
  }
  static bool waitForRows(const QTableView* table, int rows) {
    return QTest::qWaitFor([&] { return table->model()->rowCount() == rows; }, kPatience);
  }

  tests::ModelFolder folder;
  fuzzy::ForceModel start;
  ModelController models;
  SceneController scene{models};
  EditController edits{models};
  RuleController rules{edits, scene};
  RuleEditor editor{rules};
  RuleGrids* grids = nullptr;
};

TEST_F(RuleEditorTest, ANumberKeyAnswersAndGoesOn) {
  click({0, 2, 4});  // well and esophagus: medium
  QTest::keyClick(grids, Qt::Key_5);
  EXPECT_EQ(answer({0, 2, 4}), "very_large");
  EXPECT_EQ(rules.selected(), (RuleCell{0, 2, 5}));
  QTest::keyClick(grids, Qt::Key_1, Qt::KeypadModifier);
  EXPECT_EQ(answer({0, 2, 5}), "very_small");
  EXPECT_EQ(rules.selected(), (RuleCell{1, 0, 0})) << "behind the last cell of a grid comes the next one";
  EXPECT_EQ(edits.entries().size(), 2U) << "very small was the answer already";
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
  ASSERT_EQ(menu->actions().size(), 7);  // five words, a line, no answer
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
  EXPECT_EQ(edits.entries().size(), 2U);
  QTest::keyClick(weight, Qt::Key_Up);
  QTest::keyClick(weight, Qt::Key_Up);
  QTest::keyClick(weight, Qt::Key_Return);
  EXPECT_NEAR(rules.cell({0, 2, 4}).weight, 0.35, 1e-12);
  EXPECT_EQ(edits.entries().size(), 3U);
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
  rules.setWeight(rule, 0.5);
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
    rules.setWeight(3, 0.05 * (i + 1));
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

TEST_F(RuleEditorTest, TheListIsFilteredByWordsAndByKind) {
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

TEST_F(RuleEditorTest, TheListIsSortedByItsHeads) {
  QTableView* table = openList();
  rules.setWeight(20, 0.5);
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

TEST_F(RuleEditorTest, ARowIsEditedInItsPlace) {
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
  EXPECT_EQ(edits.entries().size(), 4U);
  for (int i = 0; i < 3; ++i) edits.undo();
  EXPECT_TRUE(editing::sameBits(edits.model(), start));
}

TEST_F(RuleEditorTest, SeveralRulesAreDisabledEnabledAndRemoved) {
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

TEST_F(RuleEditorTest, ARuleInFreeFormHasUpToFourConditions) {
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
  const auto message = [&] { return named<QLabel>("What is the matter with the rule")->text(); };
  auto* accept = form->findChild<QPushButton*>();

  QTest::mouseClick(accept, Qt::LeftButton);
  EXPECT_EQ(message(), QStringLiteral("S4: found a rule without a condition, wanted one condition or more"));
  EXPECT_EQ(count(), 45U);

  choose("Tube lubrication", 3);  // any, poor, medium, well
  choose("Depth", 1);
  QTest::mouseClick(accept, Qt::LeftButton);
  EXPECT_TRUE(message().contains(QStringLiteral("rule 1 that says the same"))) << message().toStdString();
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

TEST_F(RuleEditorTest, ARuleIsRewritten) {
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

TEST_F(RuleEditorTest, AFormFollowsWhatHappensMeanwhile) {
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

}  // namespace
}  // namespace tactus::workbench
