// The codes of participants who withdrew. A tombstone recognizes a code without containing it. Private to core/store.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/store/connection.h"
#include "core/study/record_id.h"

namespace tactus::store {

/// A tombstone as stored in the study file. Tombstones of version 1 have no salt and no hashes.
struct TombstoneRow {
  study::RecordId person;
  std::int64_t utc_ms = 0;
  std::string code_salt;    ///< 16 bytes derived from the person's id, equal at all stations
  std::string code_hashes;  ///< SHA-256(salt, code) of each code that only this person had, 32 bytes each, sorted
};

/// The tombstone of a person who had `codes`.
TombstoneRow tombstoneFor(const study::RecordId& person, std::int64_t utc_ms, const std::vector<std::string>& codes);

/// Joins two tombstones of one person: the earlier time and all hashes.
TombstoneRow joined(const TombstoneRow& one, const TombstoneRow& other);

/// All tombstones of the file, by time and person. This and the following functions throw as Query does.
std::vector<TombstoneRow> readTombstones(Connection& connection);

/// Notes an unfinished erasure for the person, who has a tombstone. Only then may texts be cleaned.
void noteErasure(Connection& connection, const study::RecordId& person, std::int64_t utc_ms);

/// Adds the tombstone or joins it with the existing one. Notes the erasure if that changes anything.
void leaveTombstone(Connection& connection, const TombstoneRow& tombstone);

/// `the erasure of 1 participant who withdrew was interrupted; finish it: tactus study erase FILE`, or an empty text.
std::string unfinishedErasure(Connection& connection);

/// The tombstone of the person who had `code`, or null.
const TombstoneRow* withdrawnWith(const std::vector<TombstoneRow>& tombstones, std::string_view code);

/// E.g. `the code 'N01' of a participant who withdrew on 2026-11-22T10:00:00Z`.
std::string describeWithdrawn(std::string_view code, const TombstoneRow& tombstone);

/// Refuses a code of a participant who withdrew from the study.
void refuseWithdrawnCode(Connection& connection, std::string_view code);

/// All codes that the person has or had, the oldest first.
std::vector<std::string> codesOf(Connection& connection, const study::RecordId& person);

/// The elements of `codes` that no other person of the file has or had. Removing another code from texts would affect
/// that person.
std::vector<std::string> codesOfNobodyElse(Connection& connection, const study::RecordId& person,
                                           const std::vector<std::string>& codes);

}  // namespace tactus::store
