#include "app/workbench/feel/feel_keys.h"

#include <QApplication>
#include <QKeyEvent>
#include <QWidget>
#include <utility>

#include "app/workbench/feel/feel_controller.h"

namespace tactus::workbench {
namespace {

constexpr auto kStopKey = Qt::Key_F12;

// Space is a letter there, or chooses something. In a number there is no space.
bool wantsSpace() {
  const QWidget* focus = QApplication::focusWidget();
  return QApplication::activePopupWidget() || QApplication::activeModalWidget() ||
         (focus && (focus->inherits("QLineEdit") || focus->inherits("QTextEdit")));
}

}  // namespace

FeelKeys::FeelKeys(FeelController& feel, QObject* parent) : QObject(parent), feel_(feel) {}

void FeelKeys::setOn(bool on) {
  if (std::exchange(on_, on) == on) return;
  if (on) {
    qApp->installEventFilter(this);
  } else {
    qApp->removeEventFilter(this);
  }
}

bool FeelKeys::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ApplicationDeactivate && !feel_.session().grip().latch) feel_.session().setHeld(false);
  const bool asks = event->type() == QEvent::ShortcutOverride;
  const bool press = event->type() == QEvent::KeyPress || asks;
  if (asking_ || (!press && event->type() != QEvent::KeyRelease)) return QObject::eventFilter(watched, event);
  auto* key = static_cast<QKeyEvent*>(event);
  if (press && key->key() == kStopKey) {
    feel_.stop();
    event->accept();
    return true;
  }
  if (press && key->key() == Qt::Key_Escape) return escape(*watched, *key, asks);
  if (key->key() != Qt::Key_Space) return QObject::eventFilter(watched, event);
  // Whatever has opened since the press, the hand lets go.
  if (!press && !key->isAutoRepeat()) feel_.session().setHeld(false);
  if (wantsSpace()) return QObject::eventFilter(watched, event);
  if (press && !key->isAutoRepeat()) feel_.session().setHeld(true);
  event->accept();
  return true;
}

bool FeelKeys::escape(QObject& watched, QKeyEvent& key, bool asks) {
  if (asks) {
    // Whoever drags something says now that Escape is his.
    asking_ = true;
    key.ignore();
    QCoreApplication::sendEvent(&watched, &key);
    asking_ = false;
    escape_taken_ = key.isAccepted();
    if (escape_taken_) return true;
  }
  if (escape_taken_) return false;
  feel_.stop();
  key.accept();
  return true;
}

}  // namespace tactus::workbench
