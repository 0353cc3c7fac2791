// The thread that owns the study file: what it is asked to do, one after another. Nothing else touches the file, so a
// disk that is slow or full holds nobody up.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <utility>

#include "app/workbench/base/worker.h"
#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/record_id.h"

namespace tactus::workbench {

class StudyWorker {
 public:
  /// Something to be done with the study; told what came of it.
  struct Work {
    std::function<base::Result<void>(store::StudyFile&, study::RecordIds&)> run;
    /// In the thread of the worker, after each attempt. A failure of the disk (ErrorCode::kIo) is tried again.
    std::function<void(const base::Result<void>&)> answer;
  };
  /// What only the thread of the worker touches.
  struct Desk {
    std::optional<store::StudyFile> file;  ///< the open study
    std::optional<store::StudyFile> next;  ///< one that was opened and takes its place when it is told to
    std::deque<Work> works;                ///< not done yet, because the disk refused the first of them
    study::RecordIds ids;

    /// Does the works in their order, until the disk refuses one. Returns whether none is left.
    bool catchUp();
  };
  using Task = std::function<void(Desk&)>;

  /// `task` runs in the thread of the worker, after all that were posted before.
  void post(Task task) {
    worker_.post([this, task = std::move(task)] { task(desk_); });
  }

 private:
  Desk desk_;      ///< of the thread of the worker, but for its end
  Worker worker_;  ///< last: everything that was posted is done before the study is closed
};

}  // namespace tactus::workbench
