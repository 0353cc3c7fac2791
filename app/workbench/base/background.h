// Runs long work on a thread of its own. Only the newest of several jobs counts.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

#include "app/workbench/base/call_queue.h"

namespace tactus::workbench {

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

}  // namespace tactus::workbench
