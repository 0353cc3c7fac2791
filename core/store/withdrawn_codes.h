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

// Removes the codes of a participant who withdrew from the remaining records: texts of other persons, and models.
// Private to core/store.

/// The texts of a model version that may contain a code.
struct ModelTexts {
  std::string author;
  std::string label;
  std::string text;
};

/// Removes names from texts. The result depends only on text and names, not on the order of the removals.
class NameCleaning {
 public:
  explicit NameCleaning(std::vector<std::string> names);

  bool isEmpty() const { return names_.empty(); }
  /// The names, and their spelling in JSON if it differs.
  const std::vector<std::string>& names() const { return names_; }

  /// The cleaned form of a record's text, plain or JSON.
  std::string cleaned(std::string_view text) const;
  /// Removes the experts with these names from the texts of a model version (model_io/expert_removal.h). A label about
  /// one of them keeps only its first word (`edit: (withdrawn)`), because it may repeat a rule. Returns false if there
  /// was no change.
  bool clean(ModelTexts& version) const;

 private:
  std::vector<std::string> names_;
};

/// A column with text typed by users.
struct FreeText {
  std::string_view table;
  std::string_view column;
};

/// All free-text columns except those of the models.
const std::vector<FreeText>& freeTexts();

/// Cleans all records and models of the file. A changed model version gets a new SHA-256 and a note with `utc_ms`. Call
/// only inside a transaction in which an erasure is noted, because the guards require it. Returns the number of changed
/// model versions. Throws as Query does.
long long cleanRecords(Connection& connection, const NameCleaning& cleaning, std::int64_t utc_ms);

/// The ids of the experts in the file's models, without duplicates. A code may occur in a model only.
std::vector<std::string> expertsOfModels(Connection& connection);

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
