// A thread that does what it is given, one thing after another.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace tactus::workbench {

class Worker {
 public:
  using Task = std::function<void()>;

  Worker() = default;
  /// Waits until everything that was posted is done.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// `task` is run after all that were posted before. Thread: the one that made the worker.
  void post(Task task);
  /// Until everything that was posted is done. Thread: the one that made the worker.
  void waitForDone();

 private:
  void run();

  std::mutex mutex_;  ///< guards the next three
  std::deque<Task> tasks_;
  bool busy_ = false;
  bool ending_ = false;
  std::condition_variable wake_;  ///< there is something to do
  std::condition_variable done_;  ///< there is nothing left to do
  std::thread thread_;            ///< began with the first task
};

}  // namespace tactus::workbench
