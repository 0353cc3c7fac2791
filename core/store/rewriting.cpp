#include "core/store/rewriting.h"

#include <SQLiteCpp/Statement.h>
#include <cerrno>
#include <sqlite3.h>
#include <unistd.h>
#include <utility>

#include "core/base/files/system_reason.h"
#include "core/base/files/unfinished.h"
#include "core/store/opening.h"
#include "core/store/query.h"

namespace tactus::store {
namespace {

using base::ErrorCode;

/// An empty file beside the study that only its owner may read; its name goes on every way out.
class Beside {
 public:
  explicit Beside(const std::string& study) : file_(base::makeUnfinishedFile(study, 0600)) {
    if (file_.descriptor.isOpen()) return;
    throw Refusal{
        {ErrorCode::kIo, study, {}, base::systemReason(errno), "a folder in which the study can be written anew"}};
  }
  ~Beside() { removeName(); }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;

  const std::string& path() const { return file_.path; }
  void removeName() {
    for (const char* tail : {"", "-journal", "-wal"}) ::unlink((path() + tail).c_str());
  }

 private:
  base::Unfinished file_;
};

/// Writes all pages of `from` over those of the study, in one transaction.
void putInPlace(SQLite::Database& from, Connection& study) {
  sqlite3* target = study.database().getHandle();
  sqlite3_backup* backup = sqlite3_backup_init(target, "main", from.getHandle(), "main");
  if (backup == nullptr) throw SQLite::Exception(target);
  const int stepped = sqlite3_backup_step(backup, -1);
  const int finished = sqlite3_backup_finish(backup);
  if (stepped != SQLITE_DONE) throw SQLite::Exception(sqlite3_errstr(stepped), stepped);
  if (finished != SQLITE_OK) throw SQLite::Exception(sqlite3_errstr(finished), finished);
}

}  // namespace

void rewriteWithoutTraces(Connection& connection) {
  {
    Beside beside(connection.path());
    // VACUUM INTO holds a few pages in memory; VACUUM alone would put the whole study into a temporary file that may
    // lie on another disk.
    Query copy(connection, "VACUUM INTO ?");
    copy.put(beside.path()).run();
    SQLite::Database anew(beside.path().c_str(), SQLite::OPEN_READONLY, 0,
                          connection.vfs().empty() ? nullptr : connection.vfs().c_str());
    anew.exec("PRAGMA locking_mode = EXCLUSIVE");
    anew.exec("PRAGMA mmap_size = 0");
    anew.execAndGet("SELECT count(*) FROM sqlite_schema");  // opens it
    // From here on a crash leaves no copy behind.
    beside.removeName();
    putInPlace(anew, connection);
  }
  emptyJournal(connection);
}

void emptyJournal(Connection& connection) {
  if (connection.opening) return connection.opening->emptyJournal();
  Query truncate(connection, "PRAGMA wal_checkpoint(TRUNCATE)");
  if (!truncate.next() || truncate.integer() != 0) {
    refuse(ErrorCode::kIo, {}, "a journal that could not be emptied", "a study that no other program uses");
  }
}

}  // namespace tactus::store
