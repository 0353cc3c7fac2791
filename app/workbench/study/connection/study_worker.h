// The thread that owns the study file. It runs tasks in order. No other thread uses the file, so a slow or full disk
// never blocks the window.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "app/workbench/base/worker.h"
#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/record_id.h"

namespace tactus::workbench {

class StudyWorker {
 public:
  /// An order for the study, with a callback for its result.
  struct Work {
    std::function<base::Result<void>(store::StudyFile&, study::RecordIds&)> run;
    /// Runs in the worker's thread after each attempt. A disk error (ErrorCode::kIo) is retried.
    std::function<void(const base::Result<void>&)> answer;
  };
  /// The state that only the worker's thread uses.
  struct Desk {
    std::optional<store::StudyFile> file;  ///< the open study
    std::optional<store::StudyFile> next;  ///< an opened study that replaces `file` on request
    std::deque<Work> works;                ///< not done yet, because the disk refused the first of them
    study::RecordIds ids;
    /// Run before `file` is closed or exchanged.
    std::vector<std::function<void()>> before_closing;

    /// Runs the orders in sequence until the disk refuses one. Returns whether all are done.
    bool catchUp();
    /// Closes `file`.
    base::Result<void> close();
    /// Puts `next` in the place of `file`.
    void exchange();

   private:
    void drop();
  };
  using Task = std::function<void(Desk&)>;

  /// Runs `task` in the worker's thread after all tasks posted before.
  void post(Task task) {
    worker_.post([this, task = std::move(task)] { task(desk_); });
  }

 private:
  Desk desk_;      ///< used by the worker's thread, except in the destructor
  Worker worker_;  ///< last member: all posted tasks are done before the study is closed
};

}  // namespace tactus::workbench
