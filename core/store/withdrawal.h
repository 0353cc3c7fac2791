// Withdrawal of consent by a participant: the only way to remove records from a study.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"

namespace tactus::store {

/// The remaining record of a participant who withdrew.
struct Tombstone {
  study::RecordId person;
  std::int64_t utc_ms = 0;

  bool operator==(const Tombstone&) const = default;
};

struct Withdrawal {
  long long records = 0;  ///< number of removed records, including sessions and the person
  long long models = 0;   ///< number of model versions cleaned of the person's rules and code
  /// Codes that another person of the file also has or had. Texts and models with them are left unchanged.
  std::vector<std::string> shared_codes;
};

/// Removes the person in one transaction: their records, their rules and code in all model versions, and their code in
/// other persons' texts (replaced by `(withdrawn)`). A tombstone with salted hashes of the person's codes stays, so
/// that no entry, import or merge brings the data back.
/// Then calls `eraseTraces`. If that fails or is interrupted, the records are removed, and the error asks for `erase`.
/// Copies elsewhere are not changed; copies.h lists those that can be found.
base::Result<Withdrawal> withdraw(StudyFile& file, const study::RecordId& person, std::int64_t utc_ms);

/// The second part of `withdraw`: rewrites the file and empties its journal, so that no data remains in unused pages,
/// notes that the erasure is finished, and removes the copies that were kept when the study was opened
/// (rolling_copies.h). Memory use does not grow with the study. Needs disk space for two more copies. Can be
/// interrupted at any point and repeated.
base::Result<void> eraseTraces(StudyFile& file);

struct Erasure {
  std::vector<study::RecordId> unfinished;  ///< persons with an unfinished erasure before this call
  long long models = 0;                     ///< cleaned model versions that still named a person who withdrew
};

/// Completes an interrupted withdrawal: cleans models that name a person who withdrew (found by the hashes of the
/// tombstones), and erases the traces, even if none is noted as unfinished.
base::Result<Erasure> erase(StudyFile& file);

/// The persons with an unfinished erasure.
base::Result<std::vector<study::RecordId>> unfinishedErasures(const StudyFile& file);

/// All tombstones, by time and person.
base::Result<std::vector<Tombstone>> tombstones(const StudyFile& file);

/// The tombstone of the participant who had this code, or nothing. Tombstones of older versions have no code to
/// compare.
base::Result<std::optional<Tombstone>> withdrawnWithCode(const StudyFile& file, const std::string& code);

}  // namespace tactus::store
