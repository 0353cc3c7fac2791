#include "core/store/withdrawal.h"

#include <filesystem>

#include "core/store/query.h"
#include "core/store/record_checksum.h"
#include "core/store/removal.h"

namespace tactus::store {
namespace {

using base::ErrorCode;
using base::Result;
using study::RecordId;

/// Copies that migrations made (migrations.h).
std::vector<std::string> copiesBeside(const std::string& path) {
  const std::filesystem::path study(path);
  const std::string beginning = study.filename().string() + ".before-v";
  std::vector<std::string> copies;
  std::error_code error;
  const auto folder = study.has_parent_path() ? study.parent_path() : std::filesystem::path(".");
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().filename().string().starts_with(beginning)) copies.push_back(entry.path().string());
  }
  return copies;
}

}  // namespace

Result<Withdrawal> withdraw(StudyFile& file, const RecordId& person, std::int64_t utc_ms) {
  Connection& connection = file.connection();
  if (connection.batch != Connection::BatchState::kNone) {
    return base::inFile({ErrorCode::kIo, {}, {}, "a batch that is not finished", "a study at rest"}, file.path());
  }
  Withdrawal withdrawal;
  auto removed = inTransaction(connection, [&] {
    Query find(connection, "SELECT 1 FROM person WHERE id = ?");
    if (!find.put(person).next()) {
      refuse(ErrorCode::kReference, {}, "no person " + study::toText(person), "a person of the study");
    }
    Query leave(connection, insertion(connection, "tombstone", {{"code_salt", "NULL"}, {"code_hash", "NULL"}}));
    leave.put(person).put(utc_ms).run();
    withdrawal.records = removePerson(connection, person);
  });
  if (!removed) return tl::unexpected(removed.error());
  if (auto erased = eraseTraces(file); !erased) {
    base::Error error = erased.error();
    error.place = "the records are removed, but not yet their traces in unused pages of the file";
    return tl::unexpected(error);
  }
  withdrawal.copies = copiesBeside(file.path());
  return withdrawal;
}

Result<void> eraseTraces(StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    // VACUUM may write temporary pages, so they stay in memory.
    connection.database().exec("PRAGMA temp_store = MEMORY");
    connection.database().exec("VACUUM");
    Query truncate(connection, "PRAGMA wal_checkpoint(TRUNCATE)");
    if (!truncate.next() || truncate.integer() != 0) {
      refuse(ErrorCode::kIo, {}, "a journal that could not be emptied", "a study that nobody else uses");
    }
  });
}

Result<std::vector<Tombstone>> tombstones(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    Query query(connection, "SELECT person_id, utc_ms, " + fitsChecksum(connection, "tombstone", "tombstone") +
                                " FROM tombstone ORDER BY utc_ms, person_id");
    std::vector<Tombstone> found;
    while (query.next()) {
      Tombstone tombstone;
      tombstone.person = query.id();
      tombstone.utc_ms = query.integer();
      query.requireIntact("tombstone", tombstone.person);
      found.push_back(tombstone);
    }
    return found;
  });
}

}  // namespace tactus::store
