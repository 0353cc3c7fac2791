#include <QComboBox>
#include <QFontMetricsF>
#include <QToolButton>

#include "app/editing/rule_edits.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/tune/history/history_panel.h"
#include "app/workbench/tune/rules/rule_editor.h"
#include "app/workbench/understand/here/rule_panel.h"
#include "app/workbench/workbench.h"

#include "tests/gui/shown_bench.h"

namespace tactus::workbench {
namespace {

using tests::kPatience;

class SelectionFeatureTest : public tests::ShownBench {
 protected:
  SelectionFeatureTest() : ShownBench(Stage::kUnderstand) {}

  template <class Widget>
  Widget& only() {
    return *bench.window.findChild<Widget*>();
  }

  /// The rules of expert A at the operating point, in "Why here".
  RuleFlow& rulesOfA() {
    bench.scene.setValue(0, 0);
    bench.scene.setValue(1, 0);
    auto& who = *only<RulePanel>().findChild<QComboBox*>();
    who.setCurrentIndex(1);
    emit who.activated(1);
    settle();
    return only<RuleFlow>();
  }

  /// In the first line, below the names of the columns.
  static QPoint firstLine(const RuleFlow& flow) {
    const double head = 2 * QFontMetricsF(theme::smallFont()).height() + theme::kGrid;
    return {flow.width() / 2, static_cast<int>(head) + 25};
  }
};

TEST_F(SelectionFeatureTest, FromARuleHereToEditingItIsOneDoubleClick) {
  RuleFlow& flow = rulesOfA();
  QTest::mouseDClick(&flow, Qt::LeftButton, {}, firstLine(flow));
  EXPECT_EQ(bench.window.stage(), Stage::kTune);
  ASSERT_TRUE(QTest::qWaitFor([&] { return only<RuleEditor>().isVisible(); }, kPatience));
  EXPECT_EQ(bench.selection.expert(), "A");
  EXPECT_TRUE(bench.selection.rule().has_value());
  EXPECT_GT(bench.rules.strength(*bench.selection.rule()), 0);
  // The next key is the answer.
  const QWidget* focus = bench.window.focusWidget();
  EXPECT_EQ(focus, &only<RuleGrids>()) << (focus != nullptr ? focus->metaObject()->className() : "none");
}

TEST_F(SelectionFeatureTest, AClickSelectsAndTheButtonOpensTheEditor) {
  RuleFlow& flow = rulesOfA();
  QTest::mouseClick(&flow, Qt::LeftButton, {}, firstLine(flow));
  ASSERT_TRUE(bench.selection.rule().has_value());
  EXPECT_EQ(bench.window.stage(), Stage::kUnderstand);
  settle();
  const QString name = QStringLiteral("Edit rule %1").arg(*bench.selection.rule() + 1);
  for (auto* button : only<RulePanel>().findChildren<QToolButton*>()) {
    if (button->isVisible() && button->text() == name) button->click();
  }
  EXPECT_EQ(bench.window.stage(), Stage::kTune);
}

TEST_F(SelectionFeatureTest, AnEditInTheHistorySelectsWhatItChanged) {
  bench.window.enter(Stage::kTune);
  bench.edits.apply(editing::setConsequent(bench.edits.model(), "B", 0, "high"));
  bench.edits.apply(editing::setRuleWeight(bench.edits.model(), "A", 0, 0.5));
  const editing::StateId second = bench.edits.history().current();
  emit only<HistoryPanel>().visited(second - 1);
  EXPECT_EQ(bench.selection.expert(), "B");
  EXPECT_EQ(bench.selection.rules(), std::vector<std::size_t>{0});
  emit only<HistoryPanel>().visited(second);
  EXPECT_EQ(bench.selection.expert(), "A");
  // The model as it was opened changed nothing.
  emit only<HistoryPanel>().visited(0);
  EXPECT_EQ(bench.selection.expert(), "A");
  EXPECT_TRUE(only<RuleEditor>().isVisible());
}

}  // namespace
}  // namespace tactus::workbench
