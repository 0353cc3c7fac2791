// What can be pressed, chosen or typed into says what it does: buttons, entries of the menus, hints and placeholders
// begin with a verb.
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QToolButton>
#include <gtest/gtest.h>

#include "app/workbench/kit/drawer_button.h"
#include "app/workbench/kit/statistic_help.h"
#include "app/workbench/shell/model_header.h"
#include "app/workbench/shell/operating_strip.h"
#include "app/workbench/shell/panel.h"
#include "app/workbench/shell/panel_area.h"

#include "tests/gui/shown_bench.h"

namespace tactus::workbench {
namespace {

// "New" stands for "make a new", as in every program. Whoever writes a button with another verb adds it here.
const QStringList kVerbs = {
    "About",   "Accept",  "Add",     "Approve",  "Arm",    "Begin",  "Build", "Choose",  "Close",   "Compare", "Copy",
    "Decide",  "Disable", "Discard", "Edit",     "Enable", "End",    "Enter", "Explore", "Feel",    "Feels",   "Fill",
    "Finish",  "Flex",    "Forget",  "Go",       "Import", "Keep",   "Look",  "Make",    "Measure", "Name",    "New",
    "Open",    "Put",     "Quit",    "Raise",    "Read",   "Record", "Redo",  "Remove",  "Reopen",  "Replay",  "Reset",
    "Restore", "Save",    "Search",  "Serve",    "Set",    "Show",   "Sign",  "Start",   "Stop",    "Switch",  "Take",
    "Try",     "Undo",    "Verify",  "Withdraw", "Write",  "Zoom"};
const QStringList kHintVerbs = {"Answer", "Arm",  "Ask", "Cancel", "Change", "Click", "Cut",  "Drag",  "Filter", "Flex",
                                "Give",   "Hold", "Let", "Lock",   "Move",   "Press", "Sign", "Split", "Type"};

QString plain(QString text) {
  return text.remove(QLatin1Char('&')).remove(QStringLiteral("‹ ")).remove(QStringLiteral(" ›")).trimmed();
}

bool beginsWithVerb(const QString& text) {
  return kVerbs.contains(text.section(QLatin1Char(' '), 0, 0)
                             .remove(QStringLiteral("…"))
                             .remove(QLatin1Char(','))
                             .remove(QLatin1Char(':'))) ||
         text.endsWith(QLatin1Char('?'));
}

class VerbLabels : public tests::ShownBench {
 protected:
  VerbLabels() : ShownBench(Stage::kTune) {}

  void expectVerbs(const QMenu& menu) {
    for (const QAction* action : menu.actions()) {
      if (action->isSeparator()) continue;
      const QString name = plain(action->text());
      if (action->menu() != nullptr) {
        // Stages, and files that were open.
        if (name != QLatin1String("Stage") && !name.contains(QLatin1String("ecent"))) expectVerbs(*action->menu());
        continue;
      }
      // What is one of several choices, or on or off, is named by what it is.
      if (action->isCheckable()) continue;
      EXPECT_TRUE(beginsWithVerb(plain(action->text()))) << "menu: " << action->text().toStdString();
    }
  }

  void expectVerbs(const QAbstractButton& button, const QString& where) {
    const QString text = plain(button.text());
    // Choices show what is chosen; signs such as ✕ say their verb to a screen reader.
    if (button.isCheckable() || text.isEmpty() || qobject_cast<const DrawerButton*>(&button)) return;
    const bool sign = text.size() <= 2;
    if (text == QStringLiteral("⋯")) return;  // opens a menu
    const auto* tool = qobject_cast<const QToolButton*>(&button);
    if (tool != nullptr && tool->menu() != nullptr) return;
    const auto* push = qobject_cast<const QPushButton*>(&button);
    if (push != nullptr && push->menu() != nullptr) return;
    // A note's button counts the notes behind it; a rule's button leads to the rule; the force has one word everywhere.
    if (text.startsWith(QStringLiteral("Rule ")) || text == QLatin1String("Force off")) return;
    if (text.contains(QStringLiteral("note")) || text.contains(QStringLiteral("first: "))) return;
    EXPECT_TRUE(beginsWithVerb(sign ? button.accessibleName() : text))
        << where.toStdString() << ": " << button.text().toStdString() << " (" << button.metaObject()->className()
        << ")";
  }
};

/// The hint of `widget` if it is one to act on; empty: it has none, or shows what it holds.
QString hintOf(const QWidget& widget) {
  const auto* line = qobject_cast<const QLineEdit*>(&widget);
  if (line != nullptr && !line->isReadOnly() && !line->placeholderText().isEmpty()) return line->placeholderText();
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  const bool acts = button != nullptr || qobject_cast<const QComboBox*>(&widget) != nullptr ||
                    qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr;
  return acts ? widget.toolTip() : QString();
}

TEST_F(VerbLabels, HintsSayWhatTheActDoes) {
  for (const Stage stage : {Stage::kUnderstand, Stage::kTune, Stage::kDeliver}) {
    bench.window.enter(stage);
    for (Panel* panel : bench.window.panels().panels()) {
      if (panel->isHidden()) continue;
      panel->raise();
      settle();
    }
  }
  QList<QWidget*> all;
  for (const QWidget* part :
       std::initializer_list<const QWidget*>{&bench.window.panels(), &bench.window.strip(), &bench.window.header()}) {
    all += part->findChildren<QWidget*>();
  }
  EXPECT_GT(all.size(), 500);
  for (const QWidget* widget : all) {
    const QString hint = hintOf(*widget).trimmed();
    // A sign with a question mark explains a word and does nothing.
    if (hint.isEmpty() || qobject_cast<const StatisticHelp*>(widget) != nullptr) continue;
    const QString first = hint.section(QLatin1Char(' '), 0, 0).remove(QLatin1Char(':'));
    EXPECT_TRUE(beginsWithVerb(hint) || kHintVerbs.contains(first))
        << widget->metaObject()->className() << " in " << widget->parentWidget()->metaObject()->className() << ": "
        << hint.toStdString();
  }
}

TEST_F(VerbLabels, MenusAndButtonsSayWhatTheyDo) {
  for (const QAction* menu : bench.window.menuBar()->actions()) expectVerbs(*menu->menu());
  for (const Stage stage : {Stage::kUnderstand, Stage::kTune, Stage::kDeliver}) {
    bench.window.enter(stage);
    for (Panel* panel : bench.window.panels().panels()) {
      if (panel->isHidden()) continue;
      panel->raise();
      settle();
      for (const QAbstractButton* button : panel->findChildren<QAbstractButton*>()) {
        const bool word = qobject_cast<const QPushButton*>(button) || qobject_cast<const QToolButton*>(button);
        if (word && button->isVisible()) expectVerbs(*button, panel->windowTitle());
      }
    }
  }
}

}  // namespace
}  // namespace tactus::workbench
