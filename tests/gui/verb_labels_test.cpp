// What can be pressed, chosen or typed into says what it does: buttons, entries of the menus, hints and placeholders
// begin with a verb.
#include <QMenu>
#include <QMenuBar>
#include <gtest/gtest.h>

#include "app/workbench/shell/model_header.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/shell/panel_area.h"

#include "tests/gui/shown_bench.h"
#include "tests/gui/verb_check.h"

namespace tactus::workbench {
namespace {

class VerbLabels : public tests::ShownBench {
 protected:
  VerbLabels() : ShownBench(Stage::kTune) {}

  static void expectNone(const QStringList& found) {
    EXPECT_TRUE(found.isEmpty()) << found.join(QStringLiteral("\n")).toStdString();
  }
  /// Each panel of the stages comes to the front once, and `look` looks at it.
  template <class Look>
  void showPanels(Look look) {
    for (const Stage stage : {Stage::kUnderstand, Stage::kTune, Stage::kDeliver}) {
      bench.window.enter(stage);
      for (Panel* panel : bench.window.panels().panels()) {
        if (panel->isHidden()) continue;
        panel->raise();
        settle();
        look(*panel);
      }
    }
  }
};

TEST_F(VerbLabels, HintsSayWhatTheActDoes) {
  showPanels([](Panel&) {});
  EXPECT_GT(bench.window.panels().findChildren<QWidget*>().size(), 500);
  expectNone(tests::hintsWithoutVerb(bench.window.panels()));
  expectNone(tests::hintsWithoutVerb(bench.window.strip()));
  expectNone(tests::hintsWithoutVerb(bench.window.header()));
}

TEST_F(VerbLabels, MenusAndButtonsSayWhatTheyDo) {
  for (const QAction* menu : bench.window.menuBar()->actions()) expectNone(tests::entriesWithoutVerb(*menu->menu()));
  showPanels([](Panel& panel) { expectNone(tests::buttonsWithoutVerb(panel)); });
}

}  // namespace
}  // namespace tactus::workbench
