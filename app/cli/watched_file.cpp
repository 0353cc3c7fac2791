#include "app/cli/watched_file.h"

#include <utility>

namespace tactus::cli {
namespace {

struct stat lookAt(const std::string& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return {};
  return info;
}

bool sameTime(const timespec& a, const timespec& b) { return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec; }

bool sameFile(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino && a.st_size == b.st_size && sameTime(a.st_mtim, b.st_mtim) &&
         sameTime(a.st_ctim, b.st_ctim);
}

}  // namespace

WatchedFile::WatchedFile(std::string path) : path_(std::move(path)) {}

WatchedFile::Change WatchedFile::look(Clock::time_point now) {
  const struct stat info = lookAt(path_);
  if (!sameFile(info, seen_)) {
    seen_ = info;
    changed_at_ = now;
    return Change::kNew;
  }
  // A write within one tick of the system's clock leaves no trace in the times, so the file is read once more.
  if (!changed_at_ || now - *changed_at_ < kQuiet) return Change::kNone;
  changed_at_.reset();
  return Change::kSettled;
}

}  // namespace tactus::cli
