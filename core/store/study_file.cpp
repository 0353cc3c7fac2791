#include "core/store/study_file.h"

#include <filesystem>
#include <sqlite3.h>
#include <system_error>
#include <utility>

#include "core/base/check.h"
#include "core/store/connection.h"
#include "core/store/fresh_file.h"
#include "core/store/query.h"
#include "core/store/record_checksum.h"
#include "core/store/schema.h"

namespace tactus::store {
namespace {

using base::Error;
using base::ErrorCode;
using base::Result;
using Mode = Connection::Mode;

/// Opens `path`, or the error in a sentence; the constructor of a connection may throw both kinds of exception.
Result<std::unique_ptr<Connection>> connect(const std::string& path, Mode mode, const std::string& vfs) {
  try {
    return std::make_unique<Connection>(path, mode, vfs);
  } catch (const Refusal& refusal) {
    return base::inFile(refusal.error, path);
  } catch (const SQLite::Exception& exception) {
    return tl::unexpected(describeFailure(path, failureOf(exception)));
  }
}

Result<void> requireFile(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::regular) return {};
  std::string found = "a name of something else";
  if (path.empty()) {
    found = "an empty file name";
  } else if (status.type() == std::filesystem::file_type::directory) {
    found = "a folder";
  } else if (status.type() == std::filesystem::file_type::not_found) {
    found = "no such file";
  } else if (error) {
    found = error.message();
  }
  return tl::unexpected(Error{ErrorCode::kIo, path, {}, std::move(found), "a Tactus study file"});
}

/// For reading only: as usual where a journal can be worked in, without locks where nothing can be written.
Result<Mode> readingMode(const std::string& path) {
  if (whyNotWritable(path).found.empty()) return Mode::kQueryOnly;
  std::error_code error;
  const auto journal_bytes = std::filesystem::file_size(path + "-wal", error);
  if (error || journal_bytes == 0) return Mode::kImmutable;
  return tl::unexpected(Error{ErrorCode::kIo,
                              path,
                              {},
                              "a journal beside the study that was not worked in after a crash, in a place that cannot "
                              "be written to",
                              "both files together in a folder that can be written to"});
}

/// Lets everything read a file of another version as if it were of the newest. Temporary views come before what the
/// file itself has under the same name.
void readAsNewest(Connection& connection, int version) {
  if (version == schemaSteps().back().version) return;
  connection.database().exec("PRAGMA query_only = OFF");
  connection.database().exec("PRAGMA temp_store = MEMORY");
  if (version == 1) connection.database().exec(std::string(readingVersion1()));
  connection.database().exec(viewsForReading());
  connection.database().exec("PRAGMA query_only = ON");
}

/// Looks whether the file is a study of a version that this program may open so; returns the version.
int inspect(Connection& connection, Access access) {
  if (connection.applicationId() != kApplicationId) {
    refuse(ErrorCode::kSyntax, {}, "a database of another program", "a Tactus study file");
  }
  const int version = connection.version();
  const int newest = schemaSteps().back().version;
  if (version > newest && access == Access::kReadWrite) {
    refuse(ErrorCode::kVersion, {}, "a study of version " + std::to_string(version),
           "at most version " + std::to_string(newest) +
               ": a newer Tactus wrote it, and this one can open it for reading only");
  }
  const std::string finding = connection.firstFinding("quick_check");
  if (!finding.empty() || version < 1) {
    refuse(ErrorCode::kMismatch, {}, "a damaged file (" + (version < 1 ? "no version" : finding) + ")",
           "an intact study file; restore a backup");
  }
  return version;
}

}  // namespace

StudyFile::StudyFile(std::unique_ptr<Connection> connection, Access access, int version)
    : connection_(std::move(connection)), path_(connection_->path()), access_(access), version_(version) {}
StudyFile::StudyFile(StudyFile&&) noexcept = default;
StudyFile& StudyFile::operator=(StudyFile&&) noexcept = default;
StudyFile::~StudyFile() = default;

Connection& StudyFile::connection() const {
  TACTUS_CHECK(connection_ != nullptr);
  return *connection_;
}

Result<StudyFile> StudyFile::create(const std::string& path, const NewStudy& study, const OpenOptions& options) {
  auto fresh = FreshFile::beside(path);
  if (!fresh) return tl::unexpected(fresh.error());
  {
    auto connection = connect(fresh->temporary(), Mode::kReadWrite, options.vfs);
    if (!connection) return tl::unexpected(fresh->renamed(connection.error()));
    Connection& db = **connection;
    auto made = guarded(db, [&] {
      db.database().exec("PRAGMA application_id = " + std::to_string(kApplicationId));
      db.startJournal();
    });
    if (made) made = migrate(db, schemaSteps());
    if (made) {
      made = inTransaction(db, [&] {
        Query insert(db, insertion(db, "study", {{"one", "1"}}));
        insert.put(study.id).put(study.name).put(study.created_utc_ms).put(study.program).run();
      });
    }
    if (made) made = guarded(db, [&] { db.database().exec("PRAGMA wal_checkpoint(TRUNCATE)"); });
    if (!made) return tl::unexpected(fresh->renamed(made.error()));
  }
  if (auto placed = fresh->place(); !placed) return tl::unexpected(placed.error());
  return open(path, options);
}

Result<StudyFile> StudyFile::open(const std::string& path, const OpenOptions& options) {
  if (auto there = requireFile(path); !there) return tl::unexpected(there.error());
  Mode mode = Mode::kReadWrite;
  if (options.access == Access::kReadOnly) {
    auto reading = readingMode(path);
    if (!reading) return tl::unexpected(reading.error());
    mode = *reading;
  }
  auto connected = connect(path, mode, options.vfs);
  if (!connected) return tl::unexpected(connected.error());
  Connection& connection = **connected;

  auto version = guarded(connection, [&] {
    const int found = inspect(connection, options.access);
    if (mode == Mode::kReadWrite) connection.startJournal();
    if (mode != Mode::kReadWrite) readAsNewest(connection, found);
    if (mode == Mode::kQueryOnly) connection.leaveJournalOnClose(false);
    return found;
  });
  if (!version) return tl::unexpected(version.error());
  if (mode == Mode::kReadWrite) {
    if (auto migrated = migrate(connection, schemaSteps()); !migrated) return tl::unexpected(migrated.error());
    version = guarded(connection, [&] { return connection.version(); });
    if (!version) return tl::unexpected(version.error());
  }
  return StudyFile(std::move(*connected), options.access, *version);
}

Result<void> StudyFile::close() {
  if (!connection_) return {};
  auto done = guarded(*connection_, [&] {
    if (connection_->isWritable()) connection_->database().exec("PRAGMA wal_checkpoint(TRUNCATE)");
  });
  connection_.reset();
  return done;
}

std::string sqliteVersion() { return sqlite3_libversion(); }

}  // namespace tactus::store
