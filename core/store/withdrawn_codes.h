// Codes of participants who withdrew: a tombstone knows them again without holding them. Private to core/store.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/store/connection.h"
#include "core/study/record_id.h"

namespace tactus::store {

/// A tombstone as it stands in the study file. Those of version 1 have no salt and no hashes.
struct TombstoneRow {
  study::RecordId person;
  std::int64_t utc_ms = 0;
  std::string code_salt;    ///< 16 bytes that follow from the person's id, so that all stations have the same
  std::string code_hashes;  ///< for each code that was the person's alone SHA-256(salt, code), 32 bytes, in their order
};

/// The tombstone of a person who had `codes`.
TombstoneRow tombstoneFor(const study::RecordId& person, std::int64_t utc_ms, const std::vector<std::string>& codes);

/// What two stations know of one withdrawal: the earlier time and all hashes.
TombstoneRow joined(const TombstoneRow& one, const TombstoneRow& other);

/// All tombstones of the file by time and person. Throws as Query does, as the functions below.
std::vector<TombstoneRow> readTombstones(Connection& connection);

/// Notes that an erasure for the person, whose tombstone stands, is not finished; only then texts may be cleaned.
void noteErasure(Connection& connection, const study::RecordId& person, std::int64_t utc_ms);

/// Adds the tombstone, or joins it with the one that is there, and notes the erasure where it changes anything.
void leaveTombstone(Connection& connection, const TombstoneRow& tombstone);

/// `the erasure of 1 participant who withdrew was interrupted; finish it: tactus study erase FILE`, or an empty text.
std::string unfinishedErasure(Connection& connection);

/// The one of `tombstones` whose person had `code`, or null.
const TombstoneRow* withdrawnWith(const std::vector<TombstoneRow>& tombstones, std::string_view code);

/// `the code 'N01' of a participant who withdrew on 2026-11-22T10:00:00Z`
std::string describeWithdrawn(std::string_view code, const TombstoneRow& tombstone);

/// Refuses a code whose participant withdrew from the study.
void refuseWithdrawnCode(Connection& connection, std::string_view code);

/// Every code that the person has or had, the first one first.
std::vector<std::string> codesOf(Connection& connection, const study::RecordId& person);

/// Those of `codes` that no other person of the file has or had: to take one out of texts must not touch another.
std::vector<std::string> codesOfNobodyElse(Connection& connection, const study::RecordId& person,
                                           const std::vector<std::string>& codes);

}  // namespace tactus::store
