// A thread that runs tasks in the order of their arrival.
#pragma once

#include <QObject>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace tactus::workbench {

// Passes calls from other threads to the GUI thread.

/// Lives in the GUI's thread.
class CallQueue : public QObject {
 public:
  using Call = std::function<void()>;

  explicit CallQueue(QObject* parent = nullptr);

  /// The event loop of the GUI thread makes `call`, after all calls posted earlier. It makes no call after this queue
  /// is destroyed. The call sees everything that the poster had written. Thread: any.
  void post(Call call);

 protected:
  bool event(QEvent* event) override;

 private:
  std::mutex mutex_;  ///< guards calls_
  std::deque<Call> calls_;
};

// Runs long work on a thread of its own. Only the newest of several jobs counts.

/// Thread: gui. Only the job itself runs on the other thread.
class Background {
 public:
  /// Handles the result of a job. Runs on the GUI thread.
  using Deliver = std::function<void()>;
  /// Computes on the other thread. Reads only data that it owns or shares unchanged. May stop early if `stop` asks for
  /// it.
  using Job = std::function<Deliver(const std::stop_token& stop)>;

  Background() = default;
  /// Waits for a running job to end.
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Starts `job` after the running job has ended. Drops every earlier request: a waiting job does not start; a running
  /// job is asked to stop, and its result is not delivered.
  void run(Job job);
  /// Drops the waiting job and the result of the running one.
  void drop();
  /// Whether a result is still to come.
  bool isBusy() const { return busy_; }

 private:
  void work(const std::stop_token& end);

  bool busy_ = false;         ///< of the GUI's thread alone
  std::uint64_t newest_ = 0;  ///< likewise: the number of the job that counts
  CallQueue answers_;
  std::mutex mutex_;  ///< guards the next three
  std::condition_variable_any wake_;
  std::function<void(const std::stop_token&)> waiting_;
  std::stop_source running_;
  std::jthread thread_;  ///< started by the first job
};

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
