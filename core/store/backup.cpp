#include "core/store/backup.h"

#include <sqlite3.h>

#include "core/store/connection.h"
#include "core/store/fresh_file.h"
#include "core/store/opening_row.h"
#include "core/store/query.h"
#include "core/store/study_file.h"

namespace tactus::store {
namespace {

using base::ErrorCode;
using base::Result;

/// Copies all pages in one go; SQLite syncs the copy when it is complete. It needs no journal: where the copying fails,
/// the whole file is thrown away. (SQLiteCpp's Backup does not tell why it failed.)
void copyPages(Connection& from, Connection& to) {
  to.database().exec("PRAGMA journal_mode = OFF");
  sqlite3* target = to.database().getHandle();
  sqlite3_backup* backup = sqlite3_backup_init(target, "main", from.database().getHandle(), "main");
  if (backup == nullptr) throw SQLite::Exception(target);
  const int stepped = sqlite3_backup_step(backup, -1);
  sqlite3_backup_finish(backup);
  if (stepped != SQLITE_DONE) throw SQLite::Exception(sqlite3_errstr(stepped), stepped);
}

}  // namespace

Result<void> copyDatabase(Connection& connection, const std::string& target) {
  auto fresh = FreshFile::beside(target);
  if (!fresh) return tl::unexpected(fresh.error());
  try {
    Connection copy(fresh->temporary(), Connection::Mode::kReadWrite, connection.vfs());
    auto copied = guarded(copy, [&] {
      copyPages(connection, copy);
      // The copy is a file of its own, so that no journal of the study can pass for its journal.
      if (auto row = readOpening(copy)) {
        OpeningWriter(copy).write({newToken(), {}, row->commits, false, 0});
        Query truncate(copy, "PRAGMA wal_checkpoint(TRUNCATE)");
        if (!truncate.next() || truncate.integer() != 0) {
          refuse(ErrorCode::kIo, "copy", "a journal that could not be emptied", "a copy that stands alone");
        }
      }
      for (const char* check : {"integrity_check", "foreign_key_check"}) {
        const std::string finding = copy.firstFinding(check);
        if (!finding.empty()) refuse(ErrorCode::kMismatch, "copy", finding, "an intact copy of the study");
      }
      copy.leaveJournalOnClose(false);
    });
    if (!copied) return tl::unexpected(fresh->renamed(copied.error()));
  } catch (const Refusal& refusal) {
    return base::inFile(fresh->renamed(refusal.error), target);
  } catch (const SQLite::Exception& exception) {
    return tl::unexpected(describeFailure(target, failureOf(exception)));
  }
  return fresh->place();
}

Result<void> backUp(const StudyFile& file, const std::string& target) {
  if (file.connection().batch != Connection::BatchState::kNone) {
    return base::inFile({ErrorCode::kIo, {}, {}, "a batch that is not finished", "a study at rest"}, file.path());
  }
  return copyDatabase(file.connection(), target);
}

}  // namespace tactus::store
