// The one connection of an open study file, and its rules. Private to core/store.
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <sys/types.h>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/files/descriptor.h"
#include "core/store/study_file.h"

namespace tactus::store {

// Converts SQLite's errors to one sentence for the user. Private to core/store.

/// Thrown inside core/store only, like SQLiteCpp's exceptions. `guarded` (connection.h) converts both to a Result.
struct Refusal {
  base::Error error;
};

[[noreturn]] void refuse(base::ErrorCode code, std::string place, std::string found, std::string wanted);

/// SQLite's report of a failure on a study file.
struct SqliteFailure {
  int code = 0;           ///< extended result code
  int system_errno = 0;   ///< of the last failed system call, or 0
  std::string what = {};  ///< SQLite's own words
};

/// `system_errno`: pass it if the connection still exists to give it.
SqliteFailure failureOf(const SQLite::Exception& exception, int system_errno = 0);

/// The error about `path` for a failure of SQLite.
base::Error describeFailure(const std::string& path, const SqliteFailure& failure);

/// The error if the file or its folder prevents writing; else an error with an empty `found`.
base::Error whyNotWritable(const std::string& path);

// One program at a time holds a study. Private to core/store.

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
  void release();

  base::Descriptor descriptor_;
  std::optional<File> held_;
};

/// `TACS`, in the header of every study file.
inline constexpr int kApplicationId = 0x54414353;
/// `TACT`: studies from before the release, whose versions of the tables are other ones.
inline constexpr int kApplicationIdBeforeRelease = 0x54414354;
/// Waiting time for another program to release the file: long enough for a query in the sqlite3 shell.
inline constexpr int kBusyTimeoutMs = 1000;

class Opening;

/// Thread: the one that opened it. Exactly one per file: SQLite up to 3.51.2 may lose commits of a WAL file if two
/// connections write. So the file is locked as a whole while it is open.
class Connection {
 public:
  /// Opens an existing file under the rules of a study file; throws SQLite::Exception or Refusal. kImmutable reads a
  /// file on a read-only medium, without locks.
  enum class Mode { kReadWrite, kQueryOnly, kImmutable };
  Connection(const std::string& path, Mode mode, const std::string& vfs);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  const std::string& path() const { return path_; }
  const std::string& vfs() const { return vfs_; }
  SQLite::Database& database() { return database_; }
  bool isWritable() const { return mode_ == Mode::kReadWrite; }
  const StudyLock& lock() const { return lock_; }

  /// Column names of tables, cached by columnsOf (record_checksum.h).
  std::map<std::string, std::vector<std::string>>& columns() { return columns_; }

  /// The statement of `sql`, prepared when it is first asked for.
  SQLite::Statement& kept(const std::string& sql);

  /// The first column of the last row that `sql` gives.
  std::string answerOf(const std::string& sql);
  long long pragma(const std::string& name);
  int applicationId() { return static_cast<int>(pragma("application_id")); }
  int version() { return static_cast<int>(pragma("user_version")); }
  /// Refuses a file of another kind, and a study from before the release.
  void requireStudyFile();
  /// From now on commits go through the journal and are synced. Only for a file known to be a study.
  void startJournal();
  /// With `leave`, closing keeps the journal in place. For a file that may not be a study.
  void leaveJournalOnClose(bool leave);
  /// The first finding of `PRAGMA check`, or an empty text. `check`: `quick_check`, `integrity_check` or
  /// `foreign_key_check`.
  std::string firstFinding(const std::string& check);

  /// The error for an exception thrown by this connection.
  base::Error describe(const SQLite::Exception& exception);

  /// Further data of an opening for writing (opening.h). Empty while the file is created or only read. Closed with the
  /// connection.
  std::unique_ptr<Opening> opening;
  /// Call beginWrite before a transaction, countCommit in it before its commit, acknowledge after it.
  void beginWrite();
  void countCommit();
  void acknowledge();

  /// Sets a step limit: a query with more steps than any query on a study of this size ends with an error, because a
  /// crafted file could make one run forever. `more_bytes`: the size of another file that the query also uses.
  void startWork(long long more_bytes = 0);

  /// Whether writes go into one transaction that a Batch commits.
  enum class BatchState { kNone, kOpen, kSpoiled };
  BatchState batch = BatchState::kNone;

 private:
  std::string path_;
  std::string vfs_;
  Mode mode_;
  StudyLock lock_;  ///< goes after the database
  SQLite::Database database_;
  std::map<std::string, std::vector<std::string>> columns_;
  std::map<std::string, SQLite::Statement> kept_;  ///< by their text; goes before the database
  static int onProgress(void* self);
  long long steps_ = 0;
  long long more_bytes_ = 0;
};

/// Runs `work` and converts its exceptions to an error about the connection's file.
template <class Work>
auto guarded(Connection& connection, Work&& work) -> base::Result<std::invoke_result_t<Work>> {
  connection.startWork();
  try {
    if constexpr (std::is_void_v<std::invoke_result_t<Work>>) {
      work();
      return {};
    } else {
      return work();
    }
  } catch (const Refusal& refusal) {
    return base::inFile(refusal.error, connection.path());
  } catch (const SQLite::Exception& exception) {
    return tl::unexpected(connection.describe(exception));
  }
}

/// Runs `work` in a transaction of its own, or in that of the open batch. Success means committed and synced; in a
/// batch it means that the batch will commit it.
template <class Work>
base::Result<void> inTransaction(Connection& connection, Work&& work) {
  if (connection.batch == Connection::BatchState::kOpen) {
    auto done = guarded(connection, std::forward<Work>(work));
    // SQLite may have rolled back the whole transaction, so the batch must not write further.
    if (!done) connection.batch = Connection::BatchState::kSpoiled;
    return done;
  }
  return guarded(connection, [&] {
    if (!connection.isWritable()) {
      refuse(base::ErrorCode::kIo, {}, "a study that is open for reading only", "one that is open for writing");
    }
    if (connection.batch == Connection::BatchState::kSpoiled) {
      refuse(base::ErrorCode::kIo, {}, "a batch in which a write failed", "a new batch");
    }
    connection.beginWrite();
    SQLite::Transaction transaction(connection.database(), SQLite::TransactionBehavior::IMMEDIATE);
    work();
    connection.countCommit();
    transaction.commit();
    connection.acknowledge();
  });
}

}  // namespace tactus::store
