#include "app/workbench/controllers/mailbox.h"

#include <QCoreApplication>
#include <QEvent>
#include <utility>

namespace tactus::workbench {
namespace {

QEvent::Type postedEvent() {
  static const int type = QEvent::registerEventType();
  return static_cast<QEvent::Type>(type);
}

}  // namespace

Mailbox::Mailbox(QObject* parent) : QObject(parent) {}

void Mailbox::post(Call call) {
  {
    const std::lock_guard lock(mutex_);
    calls_.push_back(std::move(call));
  }
  QCoreApplication::postEvent(this, new QEvent(postedEvent()));
}

bool Mailbox::event(QEvent* event) {
  if (event->type() != postedEvent()) return QObject::event(event);
  Call call;
  {
    const std::lock_guard lock(mutex_);
    call = std::move(calls_.front());
    calls_.pop_front();
  }
  call();
  return true;
}

}  // namespace tactus::workbench
