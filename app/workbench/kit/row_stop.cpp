#include "app/workbench/kit/row_stop.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QWidget>
#include <algorithm>

namespace tactus::workbench {
namespace {

// The text that is edited in `part`, its own or that of a number box.
const QLineEdit* textOf(const QWidget& part) {
  const auto* own = qobject_cast<const QLineEdit*>(&part);
  return own ? own : part.findChild<const QLineEdit*>();
}

bool leavesText(const QWidget& part, bool forward) {
  const QLineEdit* text = textOf(part);
  if (!text || text->selectedText() == text->text()) return true;
  return !text->hasSelectedText() && text->cursorPosition() == (forward ? text->text().size() : 0);
}

}  // namespace

RowStop::RowStop(const QList<QWidget*>& parts, QObject* parent, Qt::Orientation along)
    : QObject(parent), along_(along) {
  for (QWidget* part : parts) {
    const bool click = (part->focusPolicy() & Qt::ClickFocus) != 0;
    parts_ << Part{part, click ? Qt::ClickFocus : Qt::NoFocus};
    part->installEventFilter(this);
  }
  stopSomewhere();
}

bool RowStop::canStop(qsizetype part) const {
  const QWidget* widget = parts_[part].widget;
  return widget != nullptr && widget->isEnabled() && !widget->isHidden();
}

void RowStop::stopAt(qsizetype part) {
  stop_ = part;
  for (qsizetype i = 0; i < parts_.size(); ++i) {
    const int tab = i == part ? Qt::TabFocus : Qt::NoFocus;
    if (parts_[i].widget) parts_[i].widget->setFocusPolicy(static_cast<Qt::FocusPolicy>(parts_[i].by_click | tab));
  }
}

void RowStop::stopSomewhere() {
  qsizetype part = 0;
  while (part < parts_.size() && !canStop(part)) ++part;
  stopAt(part < parts_.size() ? part : 0);
}

bool RowStop::eventFilter(QObject* watched, QEvent* event) {
  const auto found =
      std::find_if(parts_.begin(), parts_.end(), [&](const Part& one) { return one.widget.data() == watched; });
  if (found == parts_.end()) return QObject::eventFilter(watched, event);
  const qsizetype part = found - parts_.begin();
  switch (event->type()) {
    case QEvent::FocusIn:
      stopAt(part);
      break;
    case QEvent::EnabledChange:
    case QEvent::ShowToParent:
    case QEvent::HideToParent:
      // The row keeps a stop while any part of it can be used.
      if (!canStop(stop_)) stopSomewhere();
      break;
    case QEvent::KeyPress:
      if (goFrom(part, static_cast<const QKeyEvent&>(*event))) return true;
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

bool RowStop::goFrom(qsizetype part, const QKeyEvent& key) {
  const bool row = along_ == Qt::Horizontal;
  const bool forward = key.key() == (row ? Qt::Key_Right : Qt::Key_Down);
  if (!forward && key.key() != (row ? Qt::Key_Left : Qt::Key_Up)) return false;
  if ((key.modifiers() & ~Qt::KeypadModifier) != Qt::NoModifier || !leavesText(*parts_[part].widget, forward)) {
    return false;
  }
  for (qsizetype next = part + (forward ? 1 : -1); next >= 0 && next < parts_.size(); next += forward ? 1 : -1) {
    if (!canStop(next)) continue;
    parts_[next].widget->setFocus(Qt::TabFocusReason);
    return true;
  }
  return true;
}

}  // namespace tactus::workbench
