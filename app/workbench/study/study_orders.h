// What was ordered for the open study and is not written yet: done in its order by the thread of the study, told here,
// and tried again while the disk refuses.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <deque>
#include <functional>
#include <optional>

#include "app/workbench/base/call_queue.h"
#include "app/workbench/study/study_worker.h"

namespace tactus::workbench {

/// Thread: gui.
class StudyOrders : public QObject {
  Q_OBJECT

 public:
  /// `worker` and `answers` may come to life later, and must do so before the first order; `worker` ends before this.
  StudyOrders(StudyWorker& worker, CallQueue& answers, QObject* parent = nullptr);

  /// What to do with the study, in its thread; and what then, here.
  using Work = std::function<base::Result<void>(store::StudyFile&, study::RecordIds&)>;
  using Done = std::function<void()>;
  /// Told why a work cannot be done, in one sentence, where the disk is not the reason; it is not tried again.
  using Refused = std::function<void(const QString& sentence)>;
  /// The study must stay open until the work is done (`whenWritten`).
  void add(Work work, Done done, Refused refused);

  bool isBusy() const { return !waiting_.empty(); }
  /// Something has been waiting so long that the screen should say so.
  bool isSlow() const { return slow_; }
  /// What the disk refused last; empty while all is well. It is tried again every few seconds.
  const QString& failure() const { return failure_; }
  /// Tries again at once.
  void tryAgain();
  /// `then` is told whether everything that was ordered so far is written; false: the disk refuses.
  void whenWritten(std::function<void(bool)> then);

 signals:
  /// One of the above changed.
  void changed();
  /// One sentence, once for each reason: the disk refuses.
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
