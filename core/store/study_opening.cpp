
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <sqlite3.h>
#include <string>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/store/connection.h"
#include "core/store/journal_file.h"
#include "core/store/migrations.h"
#include "core/store/opening.h"
#include "core/store/query.h"
#include "core/store/record_checksum.h"
#include "core/store/record_tables.h"
#include "core/store/withdrawn_codes.h"

namespace tactus::store {
namespace {

// Checks whether the journal beside a study belongs to it and is complete. Private to core/store.

/// An event that lost or may have lost records; a row of the table `incident`.
struct Incident {
  std::string kind;    ///< journal_missing, journal_cut, journal_damaged
  std::string detail;  ///< a sentence for the user
};

struct JournalFindings {
  /// The journal belongs to another file, or to another state of this one. None of it may be used.
  bool is_foreign = false;
  /// The study file is newer than the readable part of the journal, so the journal is ignored.
  bool is_behind = false;
  std::optional<Incident> incident;
};

std::string counted(long long count, const char* one, const char* many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

/// `3 saved records are gone`: what is committed at once, a record or a batch of them, counts as one.
std::string gone(long long count) { return counted(count, "saved record is gone", "saved records are gone"); }

bool belongs(const OpeningRow& file, const OpeningRow& both, const JournalFile& journal) {
  // Commits that are not counted, such as that of VACUUM, only loosen this.
  if (both.token == file.token) return both.commits - journal.commits <= file.commits;
  return both.previous == file.token && both.commits == file.commits + 1;
}

/// Compares three sources: `file`, the row of `opening` read without the journal; `both`, the row read together with
/// the journal (empty if unreadable); and the journal itself.
/// Every commit counts in the row of `opening`. So a journal belongs to the file only if it continues the count under
/// the same token, or if it holds only the commit with the next token. The mark in the journal's last bytes gives the
/// number of acknowledged commits.
JournalFindings examineJournal(const OpeningRow& file, const std::optional<OpeningRow>& both,
                               const JournalFile& journal) {
  JournalFindings findings;
  const bool is_read = journal.commits > 0;
  if (is_read && (!both || !belongs(file, *both, journal))) {
    findings.is_foreign = true;
    return findings;
  }
  const OpeningRow& last = is_read ? *both : file;
  findings.is_behind = is_read && last.token == file.token && file.commits > last.commits;

  // What only the journal promises may have come to the disk before the journal's length did, while the token was
  // drawn.
  const bool is_promised = is_read && last.is_open && last.token == file.token;
  const long long promised = std::max(file.is_open ? file.journal_bytes : 0, is_promised ? last.journal_bytes : 0);
  if (promised == 0) return findings;
  if (journal.isEmpty()) {
    findings.incident = {
        "journal_missing",
        "the journal of a study that was not closed was missing when it was opened: what was saved last "
        "before may be gone, how many records cannot be told"};
    return findings;
  }
  const long long there = std::max(last.commits, file.commits);
  const bool is_marked = journal.mark && journal.mark->token == last.token;
  const long long acknowledged = is_marked ? journal.mark->commits : 0;
  // Of the transactions behind the last readable one the very last may have been on its way. Where none is readable,
  // their numbers are not known, and the file may hold all of them.
  const long long behind = is_read ? last.commits + journal.commits_behind - 1 - there : 0;
  const long long lost = std::max({0LL, acknowledged - there, behind});
  if (journal.bytes < promised) {
    std::string detail = "the journal was cut to " + std::to_string(journal.bytes) + " of " + std::to_string(promised) +
                         " bytes when the study was opened: ";
    if (lost > 0) {
      detail += "at least " + gone(lost);
    } else if (journal.ends_in_file) {
      detail += "no record was in the part that is missing";
    } else {
      detail += "what was saved last may be gone, how many records cannot be told";
    }
    findings.incident = {"journal_cut", std::move(detail)};
  } else if (lost > 0) {
    findings.incident = {"journal_damaged", "the journal was damaged when the study was opened: " +
                                                std::string(is_marked ? "" : "at least ") + gone(lost)};
  } else if (!is_marked && (!journal.has_header || (!is_read && journal.commits_behind > 1))) {
    findings.incident = {
        "journal_damaged",
        "the beginning of the journal was damaged when the study was opened: what was saved last may be "
        "gone, how many records cannot be told"};
  }
  return findings;
}

// Checks that the schema of a file is exactly that of its version. Private to core/store.

using base::ErrorCode;

/// The SQL of each table, index, view and trigger, by type and name. Indexes that SQLite makes by itself have none.
using Schema = std::map<std::string, std::string>;

Schema schemaOf(SQLite::Database& database) {
  SQLite::Statement rows(database,
                         "SELECT type || ' ' || name || ' of ' || tbl_name, coalesce(sql, '') FROM main.sqlite_schema"
                         " WHERE NOT (type = 'table' AND name = 'sqlite_stat1')");
  Schema schema;
  while (rows.executeStep()) schema[rows.getColumn(0).getString()] = rows.getColumn(1).getString();
  return schema;
}

/// The schema of each version, from 1: what its steps make of an empty database.
const std::vector<Schema>& knownSchemas() {
  static const std::vector<Schema> schemas = [] {
    SQLite::Database database(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    addRecordChecksum(database.getHandle());
    std::vector<Schema> made;
    for (const Migration& step : schemaSteps()) {
      database.exec("BEGIN");
      database.exec(step.sql);
      database.exec("COMMIT");
      made.push_back(schemaOf(database));
    }
    return made;
  }();
  return schemas;
}

[[noreturn]] void refuseSchema(const std::string& found, int version) {
  refuse(ErrorCode::kSchema, {}, found,
         "the tables of a study of version " + std::to_string(version) + " as Tactus makes them");
}

void requireOrdinaryTables(const Schema& found, int version) {
  for (const RecordTable& table : recordTables()) {
    const std::string name(table.name);
    const auto at = found.find("table " + name + " of " + name);
    if (at == found.end() || !at->second.starts_with("CREATE TABLE")) refuseSchema("no table " + name, version);
  }
}

/// Call before any SQL of the file runs, because a foreign schema can contain an endless view, a trigger that changes
/// data, or a false table. Refuses, and names missing, added and different parts. If the program does not know the
/// version, each table of the newest known version must be an ordinary table.
void requireSchema(Connection& connection, int version) {
  const Schema found = schemaOf(connection.database());
  if (version > static_cast<int>(knownSchemas().size())) return requireOrdinaryTables(found, version);
  const Schema& wanted = knownSchemas()[static_cast<std::size_t>(version) - 1];
  if (found == wanted) return;
  for (const auto& [object, sql] : wanted) {
    const auto at = found.find(object);
    if (at == found.end()) refuseSchema("no " + object, version);
    if (at->second != sql) refuseSchema("another " + object, version);
  }
  for (const auto& [object, sql] : found) {
    if (!wanted.contains(object)) refuseSchema("a foreign object (" + base::quoted(object) + ")", version);
  }
}

namespace fs = std::filesystem;
using base::Error;
using base::ErrorCode;
using base::Result;
using Mode = Connection::Mode;

tl::unexpected<Error> fileError(const std::string& path, std::string found, std::string wanted) {
  return tl::unexpected(Error{ErrorCode::kIo, path, {}, std::move(found), std::move(wanted)});
}

Result<void> requireFile(const std::string& path) {
  std::error_code error;
  const auto status = fs::status(path, error);
  const bool is_regular = status.type() == fs::file_type::regular;
  // One with a journal beside it holds what the journal holds.
  const bool is_empty = is_regular && identityOf(path).bytes == 0 && identityOf(journalOf(path)).bytes <= 0;
  if (is_regular && !is_empty) return {};
  std::string found = "a device or a pipe";
  if (is_empty) {
    found = "an empty file";
  } else if (path.empty()) {
    found = "an empty file name";
  } else if (status.type() == fs::file_type::directory) {
    found = "a folder";
  } else if (status.type() == fs::file_type::not_found) {
    found = "no such file";
  } else if (error) {
    found = error.message();
  }
  return fileError(path, std::move(found), "a Tactus study file");
}

/// SQLite would play such a journal back into the study; Tactus never leaves one beside it.
Result<void> requireNoRollbackJournal(const std::string& path) {
  const std::string journal = path + "-journal";
  if (identityOf(journal).bytes <= 0) return {};
  return fileError(path, "the journal of another program beside the study (" + base::quoted(journal) + ")",
                   "the study without it; move that file away");
}

/// For reading only: as usual where the journal can be opened too, without locks where nothing can be written.
Result<Mode> readingMode(const std::string& path) {
  if (whyNotWritable(path).found.empty()) return Mode::kQueryOnly;
  if (identityOf(journalOf(path)).bytes <= 0) return Mode::kImmutable;
  return fileError(
      path, "a journal beside the study that was not worked in after a crash, in a place that cannot be written to",
      "both files together in a folder that can be written to");
}

/// Looks whether the file is a study of a version that this program may open so; returns the version.
int requireStudy(Connection& connection, Access access) {
  connection.requireStudyFile();
  const int version = connection.version();
  const int newest = schemaSteps().back().version;
  if (version > newest && access == Access::kReadWrite) {
    refuse(ErrorCode::kVersion, {}, "a study of version " + std::to_string(version),
           "at most version " + std::to_string(newest) +
               ": a newer Tactus wrote it, and this one can open it for reading only");
  }
  if (version < 1) {
    refuse(ErrorCode::kMismatch, {}, "a damaged file (no version)", "an intact study file; restore a backup");
  }
  requireSchema(connection, version);
  return version;
}

void requireIntact(Connection& connection) {
  const std::string finding = connection.firstFinding("quick_check");
  if (finding.empty()) return;
  refuse(ErrorCode::kMismatch, {}, "a damaged file (" + finding + ")", "an intact study file; restore a backup");
}

/// `look` at the file without its journal; false where it throws.
template <class Look>
bool lookAlone(const std::string& path, Look&& look) {
  try {
    Connection alone(path, Mode::kImmutable, {});
    look(alone);
    return true;
  } catch (const SQLite::Exception&) {
    return false;
  } catch (const Refusal&) {
    return false;
  }
}

/// What the study file says without its journal; nothing where it cannot be read alone, which a crash while the journal
/// was worked in can bring about.
std::optional<OpeningRow> readAlone(const std::string& path) {
  std::optional<OpeningRow> row;
  const bool is_readable = lookAlone(path, [&](Connection& alone) {
    requireStudy(alone, Access::kReadOnly);
    row = readOpening(alone);
  });
  return is_readable ? row : std::nullopt;
}

bool isIntactAlone(const std::string& path) {
  return lookAlone(path, [](Connection& alone) {
    requireStudy(alone, Access::kReadOnly);
    requireIntact(alone);
  });
}

tl::unexpected<Error> foreignJournal(const std::string& path) {
  return tl::unexpected(Error{ErrorCode::kMismatch,
                              path,
                              {},
                              "the journal of another file, or of another state of this one, beside the study (" +
                                  base::quoted(journalOf(path)) + ")",
                              "the study with its own journal or without one; move that file away, and keep it"});
}

/// What the study and its journal say together.
JournalFindings examine(Connection& connection, const JournalFile& journal) {
  const auto file = readAlone(connection.path());
  if (!file) return {};
  std::optional<OpeningRow> both;
  try {
    both = readOpening(connection);
  } catch (const SQLite::Exception&) {
  } catch (const Refusal&) {
  }
  return examineJournal(*file, both, journal);
}

/// A free name for the damaged journal, which is kept so that what was lost can be looked into.
std::string freeNameFor(const std::string& path) {
  std::string name = path + ".damaged-journal";
  for (int number = 2; identityOf(name).isThere(); ++number) name = path + ".damaged-journal-" + std::to_string(number);
  return name;
}

/// Lets everything read a file of a newer version as if it were of the newest known one. Temporary views come before
/// what the file itself has under the same name.
void readAsNewest(Connection& connection, int version) {
  if (version == schemaSteps().back().version) return;
  connection.database().exec("PRAGMA query_only = OFF");
  connection.database().exec("PRAGMA temp_store = MEMORY");
  connection.database().exec(viewsForReading());
  connection.database().exec("PRAGMA query_only = ON");
}

std::int64_t utcNowMs() {
  return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::system_clock::now().time_since_epoch())
      .count();
}

/// Ends the opening before this one: what happened to it is noted, its journal is worked in and emptied.
void settle(Connection& connection, const std::optional<Incident>& incident) {
  if (const OpeningRow row = readOpening(connection); row.is_open || incident) {
    SQLite::Transaction transaction(connection.database(), SQLite::TransactionBehavior::IMMEDIATE);
    OpeningWriter(connection).write({row.token, row.previous, row.commits + 1, false, 0});
    if (incident) {
      Query insert(connection, insertion(connection, "incident"));
      insert.putBlob(newToken()).put(utcNowMs()).put(incident->kind).put(incident->detail).run();
    }
    transaction.commit();
  }
  Query truncate(connection, "PRAGMA wal_checkpoint(TRUNCATE)");
  if (!truncate.next() || truncate.integer() != 0) {
    refuse(ErrorCode::kIo, {}, "a journal that could not be worked in", "a study that no other program uses");
  }
}

Result<void> beginWriting(Connection& connection, const std::optional<Incident>& incident) {
  auto done = guarded(connection, [&] {
    connection.startJournal();
    connection.leaveJournalOnClose(true);  // until Opening::close says that it is empty
    settle(connection, incident);
  });
  if (done) done = migrate(connection, schemaSteps());
  if (!done) return done;
  return guarded(connection, [&] { connection.opening = std::make_unique<Opening>(connection); });
}

/// With `known`, the journal was put aside before, and that is what is to be said of it.
Result<OpenedStudy> openAs(const std::string& path, const OpenOptions& options, Mode mode,
                           const std::optional<Incident>& known) {
  TACTUS_TRY(auto connected, connect(path, mode, options.vfs));
  OpenedStudy study{std::move(connected), 0, {}};
  Connection& db = *study.connection;
  try {
    db.applicationId();  // takes the lock; SQLite reads the journal
  } catch (const SQLite::Exception& exception) {
    if ((exception.getErrorCode() & 0xFF) == SQLITE_BUSY) return tl::unexpected(db.describe(exception));
  }
  const JournalFile journal = mode == Mode::kImmutable ? JournalFile{} : readJournal(journalOf(path));
  // Nothing of a journal is touched before it is known to be ours; the empty one that SQLite makes goes again.
  db.leaveJournalOnClose(!journal.isEmpty());
  std::optional<Incident> incident = known;
  if (!journal.isEmpty()) {
    JournalFindings findings = examine(db, journal);
    if (findings.is_foreign) return foreignJournal(path);
    if (findings.incident) incident = std::move(findings.incident);
    if ((findings.is_behind || incident) && mode == Mode::kReadWrite) {
      const std::string kept = freeNameFor(path);
      std::error_code error;
      fs::copy_file(journalOf(path), kept, error);
      if (error) return fileError(kept, error.message(), "a place in which the damaged journal can be kept");
      if (incident) incident->detail += "; the journal is kept as " + fs::path(kept).filename().string();
    }
    if (findings.is_behind) {
      if (!isIntactAlone(path)) return fileError(path, "a damaged file", "an intact study file; restore a backup");
      if (mode != Mode::kReadWrite) {
        return fileError(path, "a damaged journal beside the study",
                         "a study that was opened for writing once since then");
      }
      study.connection.reset();
      fs::remove(journalOf(path));
      return openAs(path, options, mode, incident);
    }
  }
  auto version = guarded(db, [&] {
    const int found = requireStudy(db, options.access);
    requireIntact(db);
    if (journal.isEmpty() && !incident) incident = examineJournal(readOpening(db), {}, journal).incident;
    return found;
  });
  if (!version) {
    if (journal.commits == 0 || !isIntactAlone(path)) return tl::unexpected(version.error());
    return fileError(
        path, "a damaged journal (" + base::quoted(journalOf(path)) + ") beside a study that is intact without it",
        "an intact journal; move it away, and keep it, to open the study without what was saved last");
  }
  study.version = *version;
  if (mode == Mode::kReadWrite) {
    if (auto begun = beginWriting(db, incident); !begun) return tl::unexpected(begun.error());
    study.version = schemaSteps().back().version;
  } else {
    auto ready = guarded(db, [&] { readAsNewest(db, study.version); });
    if (!ready) return tl::unexpected(ready.error());
  }
  if (incident) study.notices.push_back({Notice::Kind::kJournal, incident->detail});
  if (mode == Mode::kReadWrite) {
    auto unfinished = guarded(db, [&] { return unfinishedErasure(db); });
    if (!unfinished) return tl::unexpected(unfinished.error());
    if (!unfinished->empty()) study.notices.push_back({Notice::Kind::kErasure, std::move(*unfinished)});
  }
  return study;
}

}  // namespace

Result<std::unique_ptr<Connection>> connect(const std::string& path, Mode mode, const std::string& vfs) {
  try {
    return std::make_unique<Connection>(path, mode, vfs);
  } catch (const Refusal& refusal) {
    return base::inFile(refusal.error, path);
  } catch (const SQLite::Exception& exception) {
    return tl::unexpected(describeFailure(path, failureOf(exception)));
  }
}

Result<OpenedStudy> openStudy(const std::string& path, const OpenOptions& options) {
  if (auto there = requireFile(path); !there) return tl::unexpected(there.error());
  if (auto alone = requireNoRollbackJournal(path); !alone) return tl::unexpected(alone.error());
  Mode mode = Mode::kReadWrite;
  if (options.access == Access::kReadOnly) {
    TACTUS_TRY(auto reading, readingMode(path));
    mode = reading;
  }
  return openAs(path, options, mode, {});
}

}  // namespace tactus::store
