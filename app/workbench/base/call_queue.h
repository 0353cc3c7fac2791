// Brings calls from other threads into the GUI's.
#pragma once

#include <QObject>
#include <deque>
#include <functional>
#include <mutex>

namespace tactus::workbench {

/// Lives in the GUI's thread.
class CallQueue : public QObject {
 public:
  using Call = std::function<void()>;

  explicit CallQueue(QObject* parent = nullptr);

  /// `call` is made by the event loop of the GUI's thread, after those that were posted before; never, once the box is
  /// gone. What `post` saw is seen by the call. Thread: any.
  void post(Call call);

 protected:
  bool event(QEvent* event) override;

 private:
  std::mutex mutex_;  ///< guards calls_
  std::deque<Call> calls_;
};

}  // namespace tactus::workbench
