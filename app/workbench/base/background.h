// Work that may take longer than a frame, on a thread of its own. Of several jobs only the newest counts.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

#include "app/workbench/base/call_queue.h"

namespace tactus::workbench {

/// Thread: gui, but for what a job does.
class Background {
 public:
  /// What to do with the result of a job, on the thread of the GUI.
  using Deliver = std::function<void()>;
  /// Computes on the other thread, from what it owns or shares without changing it. May give up when the token says so.
  using Job = std::function<Deliver(const std::stop_token& stop)>;

  Background() = default;
  /// Waits for the end of a job that runs.
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Begins `job` as soon as the one that runs has ended. What was asked for before is dropped: a job that waits does
  /// not begin, one that runs is told to stop, and its result is not delivered.
  void run(Job job);
  /// Drops everything.
  void drop();
  /// Whether a result will come.
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
  std::jthread thread_;  ///< began with the first job
};

}  // namespace tactus::workbench
