// One opening of a study for writing: its token, the room of its journal, and that the files are still the ones that
// were opened. Private to core/store.
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

/// A file as the system knows it.
struct FileIdentity {
  dev_t device = 0;
  ino_t inode = 0;
  long long bytes = -1;  ///< -1: there is no such file
  long long changed_ns = 0;

  bool isThere() const { return bytes >= 0; }
  bool isSameFileAs(const FileIdentity& other) const { return device == other.device && inode == other.inode; }
};
FileIdentity identityOf(const std::string& path);

/// Lives from the moment in which a study is open for writing to its close. All functions throw as Query does.
/// The first write draws the token; a study that is only opened and closed is not written to. The journal then has a
/// room: a length that is promised in the file, so that a journal that was cut is noticed.
class Opening {
 public:
  /// The journal must be empty, with nothing in it that is not in the file.
  explicit Opening(Connection& connection);
  ~Opening();
  Opening(const Opening&) = delete;
  Opening& operator=(const Opening&) = delete;

  /// Before a transaction: draws the token, once, and puts it into the file itself, before anything else is written.
  void beginWrite();
  /// Counts a commit, within its transaction.
  void countCommit();
  /// After a commit, before it is acknowledged: says so in the journal, and refuses where the study file or its journal
  /// is not the one any more that was opened: deleted, replaced, cut.
  void acknowledge();

  /// Puts everything into the file and empties the journal, of which nothing is left on the disk.
  void emptyJournal();
  /// The same for good: an orderly close.
  void close();

 private:
  void requireSameStudy(const FileIdentity& study) const;
  /// Writes `row` in a transaction of its own.
  void commit(const OpeningRow& row);
  void makeRoom(long long bytes);
  void truncateJournal();
  void requireSameFiles();
  void writeMark();
  sqlite3_file* journal() const;
  static int afterCommit(void* self, sqlite3* database, const char* schema, int frames);

  Connection& connection_;
  OpeningRow row_;
  std::unique_ptr<OpeningWriter> writer_;
  long long page_bytes_ = 0;
  long long room_bytes_ = 0;     ///< what the journal has at least; 0: nothing is promised
  long long frames_end_ = 0;     ///< bytes of the journal that the last commit reached
  bool is_drawn_ = false;        ///< the token is in the journal
  bool is_established_ = false;  ///< and in the file
  bool checkpointed_ = false;    ///< since the identities were taken
  FileIdentity study_;
  FileIdentity journal_;
};

}  // namespace tactus::store
