// One opening of a study for writing: its token, the reserved space of its journal, and the identity of its files.
// Private to core/store.
#pragma once

#include <SQLiteCpp/Statement.h>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

#include "core/store/connection.h"
#include "core/store/study_file.h"

struct sqlite3;
struct sqlite3_file;

namespace tactus::store {

// Opens a study file: checks before its contents are trusted, and messages about its last opening. Private to
// core/store.

struct OpenedStudy {
  std::unique_ptr<Connection> connection;
  int version = 0;
  std::vector<Notice> notices;  ///< StudyFile::notices
};

/// See StudyFile::open.
base::Result<OpenedStudy> openStudy(const std::string& path, const OpenOptions& options);

/// A connection to `path`, or an error with one sentence.
base::Result<std::unique_ptr<Connection>> connect(const std::string& path, Connection::Mode mode,
                                                  const std::string& vfs);

// The opening that a study file and its journal belong to: the single row of the table `opening`. Private to
// core/store.

/// Each opening for writing generates a token and keeps the previous one. Each commit is counted. An orderly close
/// clears `is_open`.
struct OpeningRow {
  std::string token;     ///< 16 random bytes
  std::string previous;  ///< token of the previous opening; may be empty
  long long commits = 0;
  bool is_open = false;
  long long journal_bytes = 0;  ///< minimum length of the journal in bytes while the study is open; 0: none stated
};

/// The row. Refuses a row with a wrong checksum. Throws as Query does.
OpeningRow readOpening(Connection& connection);

/// 16 random bytes.
std::string newToken();

/// Writes the row repeatedly. Throws SQLite::Exception.
class OpeningWriter {
 public:
  explicit OpeningWriter(Connection& connection);
  void write(const OpeningRow& row);

 private:
  SQLite::Statement update_;
};

/// The identity of a file in the operating system.
struct FileIdentity {
  dev_t device = 0;
  ino_t inode = 0;
  long long bytes = -1;  ///< -1: the file does not exist
  long long changed_ns = 0;

  bool isThere() const { return bytes >= 0; }
  bool isSameFileAs(const FileIdentity& other) const { return device == other.device && inode == other.inode; }
};
FileIdentity identityOf(const std::string& path);

/// Exists from the opening of a study for writing until its close. All functions throw as Query does. The first write
/// generates the token; a study that is only opened and closed is not written. From then on the study file states a
/// minimum length of its journal, so that a truncated journal is detected.
class Opening {
 public:
  /// The journal must be empty, with all commits already in the file.
  explicit Opening(Connection& connection);
  ~Opening();
  Opening(const Opening&) = delete;
  Opening& operator=(const Opening&) = delete;

  /// Call before a transaction. The first call generates the token and writes it to the file before any other data.
  /// Refuses before anything is written if another program has written to the study or taken its lock.
  void beginWrite();
  /// Counts a commit. Call inside its transaction, as the last thing before its commit. Refuses as beginWrite does.
  void countCommit();
  /// Call after a commit, before it is acknowledged. Writes the mark to the journal. Refuses if the study file or its
  /// journal is no longer the opened one: deleted, replaced or truncated.
  void acknowledge();

  /// Moves all data to the file and empties the journal, so that none of it remains on the disk.
  void emptyJournal();
  /// The same at an orderly close.
  void close();

 private:
  void requireSameStudy(const FileIdentity& study) const;
  /// Writes `row` in a transaction of its own.
  void commit(const OpeningRow& row);
  void makeRoom(long long bytes);
  void truncateJournal();
  void requireSameFiles();
  void requireSameJournal(const FileIdentity& journal) const;
  /// Refuses where another program has written to the study or taken its lock.
  void requireNoOtherWriter() const;
  void requireOwnMark() const;
  void writeMark();
  sqlite3_file* journal() const;
  static int afterCommit(void* self, sqlite3* database, const char* schema, int frames);

  Connection& connection_;
  OpeningRow row_;
  std::unique_ptr<OpeningWriter> writer_;
  long long page_bytes_ = 0;
  long long room_bytes_ = 0;     ///< minimum length of the journal; 0: none stated
  long long frames_end_ = 0;     ///< end of the last commit in the journal, in bytes
  bool is_drawn_ = false;        ///< the token is in the journal
  bool is_established_ = false;  ///< the token is in the file
  bool checkpointed_ = false;    ///< since the identities were read
  std::string mark_;             ///< the bytes of the last mark in the journal; empty: none is known
  long long mark_at_ = 0;        ///< where it stands
  FileIdentity study_;
  FileIdentity journal_;
};

}  // namespace tactus::store
