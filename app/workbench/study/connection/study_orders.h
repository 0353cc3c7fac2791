// The orders for the open study that are not written yet. The study's thread runs them in order; this class reports the
// results and retries after disk errors.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <deque>
#include <functional>
#include <optional>

#include "app/workbench/base/worker.h"
#include "app/workbench/study/connection/study_worker.h"

namespace tactus::workbench {

/// Thread: gui.
class StudyOrders : public QObject {
  Q_OBJECT

 public:
  /// `worker` and `answers` may come to life later, and must do so before the first order; `worker` ends before this.
  StudyOrders(StudyWorker& worker, CallQueue& answers, QObject* parent = nullptr);

  /// An order: `Work` runs in the study's thread, `Done` afterwards in this thread.
  using Work = std::function<base::Result<void>(store::StudyFile&, study::RecordIds&)>;
  using Done = std::function<void()>;
  /// Called for a permanent failure (anything but a disk error), with one sentence. The order is not retried.
  using Refused = std::function<void(const QString& sentence)>;
  /// The study must stay open until the order is done (`whenWritten`).
  void add(Work work, Done done, Refused refused);

  bool isBusy() const { return !waiting_.empty(); }
  /// An order has waited so long that the screen should say so.
  bool isSlow() const { return slow_; }
  /// The last disk error; empty if all is well. The order is retried every few seconds.
  const QString& failure() const { return failure_; }
  /// Retries now.
  void tryAgain();
  /// Calls `then` after all orders so far, with true if they are written and false if the disk fails.
  void whenWritten(std::function<void(bool)> then);

 signals:
  /// One of the above changed.
  void changed();
  /// The disk fails: one sentence, once for each reason.
  void failed(const QString& sentence);

 private:
  void onAnswer(const std::optional<base::Error>& error);
  void setFailure(const QString& sentence);

  struct Waiting {
    Done done;
    Refused refused;
  };
  StudyWorker& worker_;
  CallQueue& answers_;
  std::deque<Waiting> waiting_;  ///< what follows each order that is not written yet
  QString failure_;
  bool slow_ = false;
  QTimer slow_timer_;
  QTimer retry_;
};

}  // namespace tactus::workbench
