// One program at a time holds a study. Private to core/store.
#pragma once

#include <optional>
#include <string>
#include <sys/types.h>

#include "core/base/files/descriptor.h"

namespace tactus::store {

/// A lock on the file itself that belongs to the descriptor kept here (F_OFD_SETLK): unlike SQLite's locks, it stays
/// when this process opens and closes the file somewhere else. It lies on a byte far behind every study, where SQLite
/// locks nothing. Where the file system knows no locks, nothing is held. Over NFS the server must know locks (version
/// 4). Thread: any; locks of one process know of each other.
class StudyLock {
 public:
  enum class Kind { kNone, kReading, kWriting };

  /// Waits at most `timeout_ms` for another holder. What is held afterwards is the file that `path` names: a file that
  /// lost its name during the wait is let go. Throws Refusal if another program or this one holds the study.
  StudyLock(const std::string& path, Kind kind, int timeout_ms);
  /// Only after SQLite has closed the file: closing any descriptor drops SQLite's locks.
  ~StudyLock();
  StudyLock(const StudyLock&) = delete;
  StudyLock& operator=(const StudyLock&) = delete;

  /// Whether `path` names the file that is held; true where nothing is held.
  bool isNamed(const std::string& path) const;
  /// Takes SQLite's lock of a writer again where a close elsewhere in this process dropped it. False if another program
  /// has taken it meanwhile. Only while SQLite holds the file exclusively.
  bool renew() const;

 private:
  struct File {
    dev_t device;
    ino_t inode;
    auto operator<=>(const File&) const = default;
  };
  static std::optional<File> named(const std::string& path);
  /// Whether there is nothing to wait for any more.
  bool tryToTake(const std::string& path, Kind kind);
  void letGo();

  base::Descriptor descriptor_;
  std::optional<File> held_;
};

}  // namespace tactus::store
