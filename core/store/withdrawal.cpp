#include "core/store/withdrawal.h"

#include <algorithm>
#include <iterator>

#include "core/store/name_cleaning.h"
#include "core/store/query.h"
#include "core/store/removal.h"
#include "core/store/rewriting.h"
#include "core/store/rolling_copies.h"
#include "core/store/withdrawn_codes.h"

namespace tactus::store {
namespace {

using base::ErrorCode;
using base::Result;
using study::RecordId;

Result<void> requireRest(const StudyFile& file) {
  if (file.connection().batch == Connection::BatchState::kNone) return {};
  return base::inFile({ErrorCode::kIo, {}, {}, "a batch that is not finished", "a study at rest"}, file.path());
}

std::vector<RecordId> readErasures(Connection& connection) {
  Query query(connection, "SELECT person_id FROM erasure ORDER BY utc_ms, person_id");
  std::vector<RecordId> persons;
  while (query.next()) persons.push_back(query.id());
  return persons;
}

}  // namespace

Result<Withdrawal> withdraw(StudyFile& file, const RecordId& person, std::int64_t utc_ms) {
  if (auto rest = requireRest(file); !rest) return tl::unexpected(rest.error());
  Connection& connection = file.connection();
  Withdrawal withdrawal;
  auto removed = inTransaction(connection, [&] {
    const auto codes = codesOf(connection, person);
    if (codes.empty()) {
      refuse(ErrorCode::kReference, {}, "no person " + study::toText(person), "a person of the study");
    }
    const auto own = codesOfNobodyElse(connection, person, codes);
    std::copy_if(codes.begin(), codes.end(), std::back_inserter(withdrawal.shared_codes),
                 [&](const std::string& code) { return std::find(own.begin(), own.end(), code) == own.end(); });
    leaveTombstone(connection, tombstoneFor(person, utc_ms, own));
    withdrawal.records = removePerson(connection, person);
    withdrawal.models = cleanRecords(connection, NameCleaning(own), utc_ms);
  });
  if (!removed) return tl::unexpected(removed.error());
  if (auto erased = eraseTraces(file); !erased) {
    base::Error error = erased.error();
    error.place = "the records are removed, but not yet their traces in unused pages of the file (study erase does it)";
    return tl::unexpected(error);
  }
  return withdrawal;
}

Result<void> eraseTraces(StudyFile& file) {
  if (auto rest = requireRest(file); !rest) return rest;
  Connection& connection = file.connection();
  auto rewritten = guarded(connection, [&] {
    if (!connection.isWritable()) {
      refuse(ErrorCode::kIo, {}, "a study that is open for reading only", "one that is open for writing");
    }
    rewriteWithoutTraces(connection);
  });
  if (!rewritten) return rewritten;
  // Only now, so that an erasure that was interrupted is known as such.
  auto noted = inTransaction(connection, [&] { connection.database().exec("DELETE FROM erasure"); });
  if (!noted) return noted;
  if (auto emptied = guarded(connection, [&] { emptyJournal(connection); }); !emptied) return emptied;
  return removeCopies(file.path());
}

Result<Erasure> erase(StudyFile& file) {
  if (auto rest = requireRest(file); !rest) return tl::unexpected(rest.error());
  Connection& connection = file.connection();
  Erasure erasure;
  auto cleaned = inTransaction(connection, [&] {
    erasure.unfinished = readErasures(connection);
    const auto tombstones = readTombstones(connection);
    const bool has_hashes = std::any_of(tombstones.begin(), tombstones.end(),
                                        [](const TombstoneRow& row) { return !row.code_hashes.empty(); });
    if (!has_hashes) return;
    for (const auto& expert : expertsOfModels(connection)) {
      const TombstoneRow* const row = withdrawnWith(tombstones, expert);
      if (row == nullptr || codesOfNobodyElse(connection, row->person, {expert}).empty()) continue;
      noteErasure(connection, row->person, row->utc_ms);
      erasure.models += cleanRecords(connection, NameCleaning({expert}), row->utc_ms);
    }
  });
  if (!cleaned) return tl::unexpected(cleaned.error());
  if (auto erased = eraseTraces(file); !erased) return tl::unexpected(erased.error());
  return erasure;
}

Result<std::vector<RecordId>> unfinishedErasures(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] { return readErasures(connection); });
}

Result<std::vector<Tombstone>> tombstones(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    std::vector<Tombstone> found;
    for (const auto& row : readTombstones(connection)) found.push_back({row.person, row.utc_ms});
    return found;
  });
}

Result<std::optional<Tombstone>> withdrawnWithCode(const StudyFile& file, const std::string& code) {
  Connection& connection = file.connection();
  return guarded(connection, [&]() -> std::optional<Tombstone> {
    const auto rows = readTombstones(connection);
    const TombstoneRow* const row = withdrawnWith(rows, code);
    if (row == nullptr) return std::nullopt;
    return Tombstone{row->person, row->utc_ms};
  });
}

}  // namespace tactus::store
