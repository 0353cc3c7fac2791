#include "app/workbench/participant/force_off_keys.h"

#include <QCoreApplication>
#include <QKeyEvent>

namespace tactus::workbench {

ForceOffKeys::ForceOffKeys(QObject* parent) : QObject(parent) {}

void ForceOffKeys::setOn(bool on) {
  if (on == on_) return;
  on_ = on;
  if (on) {
    QCoreApplication::instance()->installEventFilter(this);
  } else {
    QCoreApplication::instance()->removeEventFilter(this);
  }
}

bool ForceOffKeys::eventFilter(QObject* watched, QEvent* event) {
  const bool asks = event->type() == QEvent::ShortcutOverride;
  const bool press = event->type() == QEvent::KeyPress;
  if (!asks && !press && event->type() != QEvent::KeyRelease) return QObject::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  if (key->key() != Qt::Key_Escape) return QObject::eventFilter(watched, event);
  // Without an answer to this question a shortcut on Esc anywhere takes the key, and no press follows.
  event->accept();
  if (press && !key->isAutoRepeat()) emit pressed();
  return true;
}

}  // namespace tactus::workbench
