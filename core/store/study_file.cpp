#include "core/store/study_file.h"

#include <filesystem>
#include <sqlite3.h>
#include <system_error>
#include <utility>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/store/connection.h"
#include "core/store/copies.h"
#include "core/store/migrations.h"
#include "core/store/opening.h"
#include "core/store/query.h"
#include "core/store/record_checksum.h"

namespace tactus::store {

std::optional<base::Error> readOnlyReason(const std::string& path) {
  std::error_code problem;
  if (!std::filesystem::exists(path, problem)) return std::nullopt;
  auto reason = whyNotWritable(path);
  return reason.found.empty() ? std::nullopt : std::optional(std::move(reason));
}

namespace {

using base::Result;
using Mode = Connection::Mode;

}  // namespace

StudyFile::StudyFile(std::unique_ptr<Connection> connection, Access access, int version, std::vector<Notice> notices)
    : connection_(std::move(connection)),
      path_(connection_->path()),
      access_(access),
      version_(version),
      notices_(std::move(notices)) {}
StudyFile::StudyFile(StudyFile&&) noexcept = default;
StudyFile& StudyFile::operator=(StudyFile&&) noexcept = default;
StudyFile::~StudyFile() = default;

Connection& StudyFile::connection() const {
  TACTUS_CHECK(connection_ != nullptr);
  return *connection_;
}

Result<StudyFile> StudyFile::create(const std::string& path, const NewStudy& study, const OpenOptions& options) {
  TACTUS_TRY(auto fresh, FreshFile::beside(path));
  {
    auto connection = connect(fresh.temporary(), Mode::kReadWrite, options.vfs);
    if (!connection) return tl::unexpected(fresh.renamed(connection.error()));
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
    if (!made) return tl::unexpected(fresh.renamed(made.error()));
  }
  if (auto placed = fresh.place(); !placed) return tl::unexpected(placed.error());
  return open(path, options);
}

Result<StudyFile> StudyFile::open(const std::string& path, const OpenOptions& options) {
  TACTUS_TRY(auto opened, openStudy(path, options));
  return StudyFile(std::move(opened.connection), options.access, opened.version, std::move(opened.notices));
}

Result<void> StudyFile::close() {
  if (!connection_) return {};
  auto done = guarded(*connection_, [&] {
    if (!connection_->opening) return;
    connection_->leaveJournalOnClose(true);
    auto opening = std::move(connection_->opening);
    opening->close();
    connection_->leaveJournalOnClose(false);
  });
  connection_.reset();
  return done;
}

std::string sqliteVersion() { return sqlite3_libversion(); }

}  // namespace tactus::store
