#include "app/workbench/study/study_worker.h"

namespace tactus::workbench {

bool StudyWorker::Desk::catchUp() {
  while (!works.empty()) {
    const base::Result<void> done = works.front().run(*file, ids);
    const auto answer = works.front().answer;
    const bool again = !done && done.error().code == base::ErrorCode::kIo;
    if (!again) works.pop_front();
    answer(done);
    if (again) return false;
  }
  return true;
}

}  // namespace tactus::workbench
