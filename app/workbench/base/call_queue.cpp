#include "app/workbench/base/call_queue.h"

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

CallQueue::CallQueue(QObject* parent) : QObject(parent) {}

void CallQueue::post(Call call) {
  const std::lock_guard lock(mutex_);
  calls_.push_back(std::move(call));
  QCoreApplication::postEvent(this, new QEvent(postedEvent()));
}

bool CallQueue::event(QEvent* event) {
  // The event is handed over by the lock too, not only by the queue of Qt, which the thread sanitizer does not see.
  std::unique_lock lock(mutex_);
  if (event->type() != postedEvent()) {
    lock.unlock();
    return QObject::event(event);
  }
  const Call call = std::move(calls_.front());
  calls_.pop_front();
  lock.unlock();
  call();
  return true;
}

}  // namespace tactus::workbench
