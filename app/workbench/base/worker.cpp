#include "app/workbench/base/worker.h"

#include <QCoreApplication>
#include <QEvent>
#include <sys/resource.h>
#include <unistd.h>
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

namespace {

// The servo and the screen come first.
constexpr int kNiceness = 10;

}  // namespace

Background::~Background() {
  drop();
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
}

void Background::run(Job job) {
  drop();
  busy_ = true;
  auto task = [this, number = newest_, job = std::move(job)](const std::stop_token& stop) {
    Deliver deliver = job(stop);
    if (stop.stop_requested()) return;
    answers_.post([this, number, deliver = std::move(deliver)] {
      if (number != newest_) return;
      busy_ = false;
      deliver();
    });
  };
  {
    const std::lock_guard lock(mutex_);
    waiting_ = std::move(task);
  }
  if (!thread_.joinable()) thread_ = std::jthread([this](const std::stop_token& end) { work(end); });
  wake_.notify_one();
}

void Background::drop() {
  busy_ = false;
  ++newest_;
  const std::lock_guard lock(mutex_);
  waiting_ = nullptr;
  running_.request_stop();
}

void Background::work(const std::stop_token& end) {
  // For this thread alone: in Linux threads have a niceness each.
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNiceness);
  std::unique_lock lock(mutex_);
  while (wake_.wait(lock, end, [this] { return waiting_ != nullptr; })) {
    auto task = std::exchange(waiting_, nullptr);
    running_ = std::stop_source();
    const std::stop_token stop = running_.get_token();
    lock.unlock();
    task(stop);
    // What the job holds goes before the next one begins.
    task = nullptr;
    lock.lock();
  }
}

Worker::~Worker() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void Worker::post(Task task) {
  {
    const std::lock_guard lock(mutex_);
    tasks_.push_back(std::move(task));
  }
  if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
  wake_.notify_one();
}

void Worker::waitForDone() {
  std::unique_lock lock(mutex_);
  done_.wait(lock, [this] { return tasks_.empty() && !busy_; });
}

void Worker::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return ending_ || !tasks_.empty(); });
    if (tasks_.empty()) return;
    Task task = std::move(tasks_.front());
    tasks_.pop_front();
    busy_ = true;
    lock.unlock();
    task();
    task = nullptr;
    lock.lock();
    busy_ = false;
    if (tasks_.empty()) done_.notify_all();
  }
}

}  // namespace tactus::workbench
