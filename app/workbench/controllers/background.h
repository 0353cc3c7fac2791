// Work that may take longer than a frame, on a thread of its own. Of several jobs only the newest counts.
#pragma once

#include <QObject>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace tactus::workbench {

/// Thread: gui, but for what a job does.
class Background : public QObject {
  Q_OBJECT

 public:
  /// What to do with the result of a job, on the thread of the GUI.
  using Deliver = std::function<void()>;
  /// Computes on the other thread, from what it owns or shares without changing it. May give up when the token says so.
  using Job = std::function<Deliver(const std::stop_token& stop)>;

  explicit Background(QObject* parent = nullptr);
  /// Waits for the end of a job that runs.
  ~Background() override;

  /// Begins `job` as soon as the one that runs has ended. What was asked for before is dropped: a job that waits does
  /// not begin, one that runs is told to stop, and its result is not delivered.
  void run(Job job);
  /// Drops everything.
  void drop();
  /// Whether a result will come.
  bool isBusy() const { return busy_; }

 protected:
  bool event(QEvent* event) override;

 private:
  void work(const std::stop_token& end);

  bool busy_ = false;  ///< of the GUI's thread alone
  std::mutex mutex_;   ///< of the members below
  std::condition_variable_any wake_;
  Job waiting_;
  std::stop_source running_;
  Deliver done_;
  std::jthread thread_;  ///< began with the first job
};

}  // namespace tactus::workbench
