#include "app/workbench/base/background.h"

#include <sys/resource.h>
#include <unistd.h>
#include <utility>

namespace tactus::workbench {
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

}  // namespace tactus::workbench
