#include "core/store/study_lock.h"

#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <mutex>
#include <set>
#include <sqlite3.h>
#include <sys/stat.h>
#include <thread>
#include <utility>

#include "core/store/sqlite_errors.h"

namespace tactus::store {
namespace {

constexpr off_t kOurByte = off_t{1} << 62;
/// SQLite's "Database File Format" and os.h: the bytes that a reader shares and a writer has alone.
constexpr off_t kSharedFirst = 0x40000002;
constexpr off_t kSharedBytes = 510;
constexpr std::chrono::milliseconds kBetweenTries{10};

struct flock lockOf(short type, off_t first, off_t bytes) {
  struct flock lock {};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  lock.l_start = first;
  lock.l_len = bytes;
  return lock;
}

/// The files that this process holds. Without it a second opening would have to open the file to learn that it is held,
/// and its close would drop SQLite's locks.
class Holdings {
 public:
  bool add(dev_t device, ino_t inode) {
    const std::lock_guard guard(mutex_);
    return files_.emplace(device, inode).second;
  }
  void remove(dev_t device, ino_t inode) {
    const std::lock_guard guard(mutex_);
    files_.erase({device, inode});
  }

 private:
  std::mutex mutex_;
  std::set<std::pair<dev_t, ino_t>> files_;
};

Holdings& holdings() {
  static Holdings all;
  return all;
}

bool isTaken(int error) { return error == EAGAIN || error == EACCES; }

}  // namespace

StudyLock::StudyLock(const std::string& path, Kind kind, int timeout_ms) {
  if (kind == Kind::kNone) return;
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(timeout_ms);
  while (!tryToTake(path, kind)) {
    if (std::chrono::steady_clock::now() >= end) throw Refusal{describeFailure(path, {SQLITE_BUSY})};
    std::this_thread::sleep_for(kBetweenTries);
  }
}

StudyLock::~StudyLock() { letGo(); }

std::optional<StudyLock::File> StudyLock::named(const std::string& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return std::nullopt;
  return File{info.st_dev, info.st_ino};
}

bool StudyLock::tryToTake(const std::string& path, Kind kind) {
  const auto file = named(path);
  if (!file) return true;  // SQLite says why
  if (!holdings().add(file->device, file->inode)) return false;
  held_ = file;
  const bool writing = kind == Kind::kWriting;
  descriptor_ = base::Descriptor(::open(path.c_str(), (writing ? O_RDWR : O_RDONLY) | O_NONBLOCK | O_CLOEXEC));
  struct stat opened {};
  if (!descriptor_.isOpen() || ::fstat(descriptor_.number(), &opened) != 0) {
    letGo();
    return true;
  }
  // Until the lock is there, the name may have gone to another file.
  struct flock lock = lockOf(writing ? F_WRLCK : F_RDLCK, kOurByte, 1);
  const bool taken = ::fcntl(descriptor_.number(), F_OFD_SETLK, &lock) != 0 && isTaken(errno);
  if (!taken && File{opened.st_dev, opened.st_ino} == *held_ && isNamed(path)) return true;
  letGo();
  return false;
}

void StudyLock::letGo() {
  descriptor_.close();
  if (held_) holdings().remove(held_->device, held_->inode);
  held_.reset();
}

bool StudyLock::isNamed(const std::string& path) const { return !held_ || named(path) == held_; }

bool StudyLock::renew() const {
  if (!held_) return true;
  struct flock lock = lockOf(F_WRLCK, kSharedFirst, kSharedBytes);
  return ::fcntl(descriptor_.number(), F_SETLK, &lock) == 0 || !isTaken(errno);
}

}  // namespace tactus::store
