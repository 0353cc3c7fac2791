#include "app/workbench/shell/undo_keys.h"

#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSpinBox>

namespace tactus::workbench {
namespace {

bool isUndoOrRedo(const QKeyEvent& key) {
  return key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo) ||
         (key.key() == Qt::Key_Y && key.modifiers() == Qt::ControlModifier) ||
         (key.key() == Qt::Key_Z &&
          (key.modifiers() == Qt::ControlModifier || key.modifiers() == (Qt::ControlModifier | Qt::ShiftModifier)));
}

// A field without something typed that was not accepted yet.
bool isIdleField(QObject* watched) {
  if (const auto* number = qobject_cast<const QDoubleSpinBox*>(watched)) {
    return number->text() == number->prefix() + number->textFromValue(number->value()) + number->suffix();
  }
  if (const auto* count = qobject_cast<const QSpinBox*>(watched)) {
    return count->locale().toInt(count->cleanText()) == count->value();
  }
  if (const auto* line = qobject_cast<const QLineEdit*>(watched)) return !line->isModified();
  return false;
}

}  // namespace

UndoKeys::UndoKeys(QObject* parent) : QObject(parent) { QCoreApplication::instance()->installEventFilter(this); }

bool UndoKeys::eventFilter(QObject* watched, QEvent* event) {
  // A field answers this question with yes, and the shortcut of the window is not asked.
  if (event->type() != QEvent::ShortcutOverride || !isUndoOrRedo(*static_cast<QKeyEvent*>(event)) ||
      !isIdleField(watched)) {
    return QObject::eventFilter(watched, event);
  }
  event->ignore();
  return true;
}

}  // namespace tactus::workbench
