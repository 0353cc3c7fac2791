// A line on the terminal while a command takes long, so that nobody takes it for stuck.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace tactus::cli {

/// From 2 s on, writes `what` and the seconds that have passed to standard error, each second in the same line; the end
/// clears the line. Does nothing where standard error is no terminal.
class ProgressLine {
 public:
  explicit ProgressLine(std::string what);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

 private:
  void show(const std::string& what);

  std::mutex mutex_;
  std::condition_variable ended_;
  bool end_ = false;
  std::thread writer_;
};

}  // namespace tactus::cli
