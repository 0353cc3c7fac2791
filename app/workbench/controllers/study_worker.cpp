#include "app/workbench/controllers/study_worker.h"

#include <utility>

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

StudyWorker::StudyWorker() : thread_([this] { run(); }) {}

StudyWorker::~StudyWorker() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void StudyWorker::post(Task task) {
  {
    const std::lock_guard lock(mutex_);
    tasks_.push_back(std::move(task));
  }
  wake_.notify_one();
}

void StudyWorker::run() {
  Desk desk;
  while (true) {
    Task task;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [this] { return ending_ || !tasks_.empty(); });
      if (tasks_.empty()) return;
      task = std::move(tasks_.front());
      tasks_.pop_front();
    }
    task(desk);
  }
}

}  // namespace tactus::workbench
