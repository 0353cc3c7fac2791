// A thread that runs tasks in the order of their arrival.
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
  /// Waits until all posted tasks are done.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// `task` runs after all tasks posted earlier. Thread: the one that created the worker.
  void post(Task task);
  /// Waits until all posted tasks are done. Thread: the one that created the worker.
  void waitForDone();

 private:
  void run();

  std::mutex mutex_;  ///< guards the next three
  std::deque<Task> tasks_;
  bool busy_ = false;
  bool ending_ = false;
  std::condition_variable wake_;  ///< a task arrived, or the worker ends
  std::condition_variable done_;  ///< no task is left
  std::thread thread_;            ///< started by the first task
};

}  // namespace tactus::workbench
