#include "app/workbench/controllers/background.h"

#include <QCoreApplication>
#include <QEvent>
#include <sys/resource.h>
#include <unistd.h>
#include <utility>

namespace tactus::workbench {
namespace {

// The servo and the screen come first.
constexpr int kNiceness = 10;

QEvent::Type doneEvent() {
  static const int type = QEvent::registerEventType();
  return static_cast<QEvent::Type>(type);
}

}  // namespace

Background::Background(QObject* parent) : QObject(parent) {}

Background::~Background() {
  drop();
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
}

void Background::run(Job job) {
  drop();
  busy_ = true;
  {
    const std::lock_guard lock(mutex_);
    waiting_ = std::move(job);
  }
  if (!thread_.joinable()) thread_ = std::jthread([this](const std::stop_token& end) { work(end); });
  wake_.notify_one();
}

void Background::drop() {
  busy_ = false;
  const std::lock_guard lock(mutex_);
  waiting_ = nullptr;
  done_ = nullptr;
  running_.request_stop();
}

bool Background::event(QEvent* event) {
  if (event->type() != doneEvent()) return QObject::event(event);
  Deliver done;
  {
    const std::lock_guard lock(mutex_);
    done = std::exchange(done_, nullptr);
  }
  // The newest job may have been asked for after the one that this event tells of.
  if (!done) return true;
  busy_ = false;
  done();
  return true;
}

void Background::work(const std::stop_token& end) {
  // For this thread alone: in Linux threads have a niceness each.
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNiceness);
  std::unique_lock lock(mutex_);
  while (wake_.wait(lock, end, [this] { return waiting_ != nullptr; })) {
    Job job = std::exchange(waiting_, nullptr);
    running_ = std::stop_source();
    const std::stop_token stop = running_.get_token();
    lock.unlock();
    Deliver done = job(stop);
    // What the job holds goes before the next one begins.
    job = nullptr;
    lock.lock();
    if (stop.stop_requested()) continue;
    done_ = std::move(done);
    QCoreApplication::postEvent(this, new QEvent(doneEvent()));
  }
}

}  // namespace tactus::workbench
