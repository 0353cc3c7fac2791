#include "app/workbench/study/connection/study_worker.h"

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

base::Result<void> StudyWorker::Desk::close() {
  drop();
  const base::Result<void> closed = file->close();
  file.reset();
  return closed;
}

void StudyWorker::Desk::exchange() {
  drop();
  // The destructor closes a study that does not close with a word; nothing is lost with it.
  file = std::move(*next);
  next.reset();
}

void StudyWorker::Desk::drop() {
  for (const auto& call : before_closing) call();
  before_closing.clear();
}

}  // namespace tactus::workbench
