#include "app/workbench/kit/row_stop.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <utility>

namespace tactus::workbench {
namespace {

// The text that is edited in `part`, its own or that of a number box.
const QLineEdit* textOf(const QWidget& part) {
  const auto* own = qobject_cast<const QLineEdit*>(&part);
  return own ? own : part.findChild<const QLineEdit*>();
}

bool leavesText(const QWidget& part, bool right) {
  const QLineEdit* text = textOf(part);
  if (!text || text->selectedText() == text->text()) return true;
  return !text->hasSelectedText() && text->cursorPosition() == (right ? text->text().size() : 0);
}

}  // namespace

RowStop::RowStop(QList<QWidget*> parts, QObject* parent) : QObject(parent), parts_(std::move(parts)) {
  for (QWidget* part : parts_) part->installEventFilter(this);
  stopAt(0);
}

void RowStop::stopAt(qsizetype part) {
  for (qsizetype i = 0; i < parts_.size(); ++i) {
    parts_[i]->setFocusPolicy(i == part ? Qt::StrongFocus : Qt::ClickFocus);
  }
}

bool RowStop::eventFilter(QObject* watched, QEvent* event) {
  const qsizetype part = parts_.indexOf(watched);
  if (part >= 0 && event->type() == QEvent::FocusIn) stopAt(part);
  if (part >= 0 && event->type() == QEvent::KeyPress && goFrom(part, static_cast<const QKeyEvent&>(*event)))
    return true;
  return QObject::eventFilter(watched, event);
}

bool RowStop::goFrom(qsizetype part, const QKeyEvent& key) {
  const bool right = key.key() == Qt::Key_Right;
  if ((!right && key.key() != Qt::Key_Left) || (key.modifiers() & ~Qt::KeypadModifier) != Qt::NoModifier) return false;
  if (!leavesText(*parts_[part], right)) return false;
  for (qsizetype next = part + (right ? 1 : -1); next >= 0 && next < parts_.size(); next += right ? 1 : -1) {
    if (!parts_[next]->isEnabled() || !parts_[next]->isVisible()) continue;
    parts_[next]->setFocus(Qt::TabFocusReason);
    return true;
  }
  return true;
}

}  // namespace tactus::workbench
