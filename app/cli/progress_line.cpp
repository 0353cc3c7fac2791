#include "app/cli/progress_line.h"

#include <chrono>
#include <cstdio>
#include <unistd.h>
#include <utility>

namespace tactus::cli {
namespace {

using std::chrono::seconds;

constexpr seconds kQuiet{2};

}  // namespace

ProgressLine::ProgressLine(std::string what) {
  if (::isatty(STDERR_FILENO) == 1) writer_ = std::thread([this, what = std::move(what)] { show(what); });
}

ProgressLine::~ProgressLine() {
  if (!writer_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    end_ = true;
  }
  ended_.notify_one();
  writer_.join();
}

void ProgressLine::show(const std::string& what) {
  const auto start = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  if (ended_.wait_for(lock, kQuiet, [this] { return end_; })) return;
  do {
    const auto passed = std::chrono::duration_cast<seconds>(std::chrono::steady_clock::now() - start);
    std::fprintf(stderr, "\r%s: working, %lld s", what.c_str(), static_cast<long long>(passed.count()));
    std::fflush(stderr);
  } while (!ended_.wait_for(lock, seconds(1), [this] { return end_; }));
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
}

}  // namespace tactus::cli
