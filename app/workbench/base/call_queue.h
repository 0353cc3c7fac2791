// Passes calls from other threads to the GUI thread.
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

  /// The event loop of the GUI thread makes `call`, after all calls posted earlier. It makes no call after this queue
  /// is destroyed. The call sees everything that the poster had written. Thread: any.
  void post(Call call);

 protected:
  bool event(QEvent* event) override;

 private:
  std::mutex mutex_;  ///< guards calls_
  std::deque<Call> calls_;
};

}  // namespace tactus::workbench
