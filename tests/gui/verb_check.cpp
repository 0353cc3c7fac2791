#include "tests/gui/verb_check.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>

#include "app/workbench/kit/buttons.h"
#include "app/workbench/shell/main_window.h"

namespace tactus::tests {
namespace {

// "New" stands for "make a new", as in every program. Whoever writes a button with another verb adds it here.
const QStringList kVerbs = {"About", "Accept", "Add",    "Approve", "Arm",      "Begin",   "Build",   "Carry",
                            "Check", "Choose", "Close",  "Compare", "Copy",     "Decide",  "Disable", "Discard",
                            "Edit",  "Enable", "End",    "Explain", "Enter",    "Explore", "Feel",    "Feels",
                            "Fill",  "Find",   "Finish", "Flex",    "Forget",   "Go",      "Import",  "Keep",
                            "Load",  "Look",   "Mark",   "Move",    "Make",     "Measure", "Name",    "New",
                            "Open",  "Pin",    "Pull",   "Put",     "Quit",     "Raise",   "Read",    "Record",
                            "Redo",  "Remove", "Reopen", "Replay",  "Reset",    "Restore", "Save",    "Search",
                            "Serve", "Set",    "Show",   "Sign",    "Start",    "Store",   "Stop",    "Switch",
                            "Take",  "Try",    "Undo",   "Verify",  "Withdraw", "Write",   "Zoom"};
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

QString widgetText(const QWidget& widget) {
  return QLatin1String(widget.metaObject()->className()) + QStringLiteral(" in ") +
         QLatin1String(widget.parentWidget()->metaObject()->className());
}

/// The words of `button` that a verb begins; nothing where it has none of its own.
QString wordsOf(const QAbstractButton& button) {
  const QString text = plain(button.text());
  // Choices show what is chosen; signs such as ✕ say their verb to a screen reader.
  if (button.isCheckable() || text.isEmpty() || qobject_cast<const workbench::DrawerButton*>(&button)) return {};
  if (text == QStringLiteral("⋯")) return {};                    // opens a menu
  if (button.text().startsWith(QStringLiteral("‹"))) return {};  // leads back to what it names
  const auto* tool = qobject_cast<const QToolButton*>(&button);
  const auto* push = qobject_cast<const QPushButton*>(&button);
  if (tool == nullptr && push == nullptr) return {};
  if ((tool != nullptr ? tool->menu() : push->menu()) != nullptr) return {};
  // A note's button counts the notes behind it; a rule's button leads to the rule; the force has one word everywhere.
  if (text.startsWith(QStringLiteral("Rule ")) || text == QLatin1String("Force off")) return {};
  if (text.contains(QStringLiteral("note")) || text.contains(QStringLiteral("first: "))) return {};
  return text.size() <= 2 ? button.accessibleName() : text;
}

/// The hint of `widget` if it is one to act on; empty: it has none, or shows what it holds.
QString hintOf(const QWidget& widget) {
  const auto* line = qobject_cast<const QLineEdit*>(&widget);
  if (line != nullptr && !line->isReadOnly() && !line->placeholderText().isEmpty()) return line->placeholderText();
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  const bool acts = button != nullptr || qobject_cast<const QComboBox*>(&widget) != nullptr ||
                    qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr;
  return acts ? widget.toolTip() : QString();
}

}  // namespace

QStringList entriesWithoutVerb(const QMenu& menu) {
  QStringList out;
  for (const QAction* action : menu.actions()) {
    if (action->isSeparator()) continue;
    const QString name = plain(action->text());
    if (action->menu() != nullptr) {
      // Stages, and files that were open.
      if (name != QLatin1String("Stage") && !name.contains(QLatin1String("ecent"))) {
        out += entriesWithoutVerb(*action->menu());
      }
    } else if (!action->isCheckable() && !beginsWithVerb(name)) {
      out << name;
    }
  }
  return out;
}

QStringList buttonsWithoutVerb(const QWidget& part) {
  QStringList out;
  for (const QAbstractButton* button : part.findChildren<QAbstractButton*>()) {
    const QString words = button->isVisible() ? wordsOf(*button) : QString();
    if (!words.isEmpty() && !beginsWithVerb(words)) out << widgetText(*button) + QStringLiteral(": ") + words;
  }
  return out;
}

QStringList hintsWithoutVerb(const QWidget& part) {
  QStringList out;
  for (const QWidget* widget : part.findChildren<QWidget*>()) {
    const QString hint = hintOf(*widget).trimmed();
    // A sign with a question mark explains a word and does nothing.
    // A stage is a place.
    if (hint.isEmpty() || qobject_cast<const workbench::StatisticHelp*>(widget) != nullptr ||
        qobject_cast<const workbench::StageButton*>(widget) != nullptr) {
      continue;
    }
    const QString first = hint.section(QLatin1Char(' '), 0, 0).remove(QLatin1Char(':'));
    if (!beginsWithVerb(hint) && !kHintVerbs.contains(first)) out << widgetText(*widget) + QStringLiteral(": ") + hint;
  }
  return out;
}

}  // namespace tactus::tests
