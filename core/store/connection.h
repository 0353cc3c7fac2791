// The one connection of an open study file, and the rules under which it works. Private to core/store.
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <map>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/store/sqlite_errors.h"
#include "core/store/study_file.h"

namespace tactus::store {

/// `TACT`, in the header of every study file.
inline constexpr int kApplicationId = 0x54414354;
/// How long to wait for another program to let go of the file: long enough for a look with the sqlite3 shell.
inline constexpr int kBusyTimeoutMs = 1000;

class Opening;

/// Thread: the one that opened it. Exactly one per file: SQLite up to 3.51.2 may lose commits of a WAL file with two
/// connections that write, so the file is locked as a whole while it is open.
class Connection {
 public:
  /// Opens an existing file under the rules of the study file; throws SQLite::Exception or Refusal.
  /// `immutable` reads a file on a medium that cannot be written to, without locks.
  enum class Mode { kReadWrite, kQueryOnly, kImmutable };
  Connection(const std::string& path, Mode mode, const std::string& vfs);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  const std::string& path() const { return path_; }
  const std::string& vfs() const { return vfs_; }
  SQLite::Database& database() { return database_; }
  bool isWritable() const { return mode_ == Mode::kReadWrite; }

  /// Names of the columns of tables, kept by columnsOf (record_checksum.h).
  std::map<std::string, std::vector<std::string>>& columns() { return columns_; }

  /// The statement of `sql`, prepared when it is first asked for.
  SQLite::Statement& kept(const std::string& sql);

  /// The first column of the last row that `sql` gives.
  std::string answerOf(const std::string& sql);
  long long pragma(const std::string& name);
  int applicationId() { return static_cast<int>(pragma("application_id")); }
  int version() { return static_cast<int>(pragma("user_version")); }
  /// From now on commits are written through the journal and synced; only for a file known to be a study.
  void startJournal();
  /// On close the journal stays where it is: for a file that is not known to be ours.
  void leaveJournalOnClose(bool leave);
  /// The first finding of `PRAGMA check`, or an empty text: `quick_check`, `integrity_check`, `foreign_key_check`.
  std::string firstFinding(const std::string& check);

  /// The error for an exception that this connection threw.
  base::Error describe(const SQLite::Exception& exception);

  /// What an opening for writing needs beside the connection (opening.h); empty while the file is made or only read.
  /// Closed with the connection.
  std::unique_ptr<Opening> opening;
  /// Before a transaction; within it, before its commit; after it, before it is acknowledged.
  void beginWrite();
  void countCommit();
  void acknowledge();

  /// A query that takes more steps than any does on a study of this size ends with an error: files of others may be
  /// made so that one would take for ever. `more_bytes` of another file are worked in too.
  void startWork(long long more_bytes = 0);

  /// Whether writes go into one transaction that a Batch commits.
  enum class BatchState { kNone, kOpen, kSpoiled };
  BatchState batch = BatchState::kNone;

 private:
  std::string path_;
  std::string vfs_;
  Mode mode_;
  SQLite::Database database_;
  std::map<std::string, std::vector<std::string>> columns_;
  std::map<std::string, SQLite::Statement> kept_;  ///< by their text; goes before the database
  static int onProgress(void* self);
  long long steps_ = 0;
  long long more_bytes_ = 0;
};

/// Runs `work`; what it throws becomes an error about the connection's file.
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

/// Runs `work` in one transaction of its own, or in that of the open batch. Success means: committed and synced, in a
/// batch only that it will be.
template <class Work>
base::Result<void> inTransaction(Connection& connection, Work&& work) {
  if (connection.batch == Connection::BatchState::kOpen) {
    auto done = guarded(connection, std::forward<Work>(work));
    // SQLite may have rolled everything back, so nothing more may be written on top of it.
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
