// One opening of a study for writing: its token, the reserved space of its journal, and the identity of its files.
// Private to core/store.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <sys/types.h>

#include "core/store/connection.h"
#include "core/store/opening_row.h"

struct sqlite3;
struct sqlite3_file;

namespace tactus::store {

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
