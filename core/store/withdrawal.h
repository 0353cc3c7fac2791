// Withdrawal of consent by a participant: the only way to remove records from a study.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/store/connection.h"
#include "core/store/merge.h"
#include "core/store/study_file.h"
#include "core/store/withdrawn_codes.h"
#include "core/study/record_id.h"

namespace tactus::store {

// The persons who withdrew from one of two studies being merged: their data do not enter and are removed where present.
// Private to core/store.

/// The names of one person who withdrew, for removal from texts.
struct TimedCleaning {
  NameCleaning cleaning;
  std::int64_t utc_ms = 0;  ///< time of the withdrawal
};

/// Use inside the transaction of a merge. Throws as Query does.
class MergedWithdrawals {
 public:
  /// Refuses the merge if a participant of one file has the code of another person who withdrew from the other file. It
  /// may be the same person, recorded again, or a different one who needs another code.
  MergedWithdrawals(Connection& ours, Connection& theirs);

  /// Adds the tombstones of the other file, removes from this file the persons who withdrew there, and cleans our
  /// models and texts. Reports the removed and excluded persons in `merge`.
  void apply(Merge& merge);

  /// The cleanings to apply to each incoming text.
  const std::vector<TimedCleaning>& cleanings() const { return cleanings_; }

  /// Call after all rows are added. Returns whether traces in this file must be erased after the commit.
  bool finish();

 private:
  void requireOtherCodes(Connection& living, Connection& withdrawn, const std::vector<TombstoneRow>& rows) const;
  bool hasWithdrawn(const study::RecordId& person) const;
  void findNames();
  void tellWhoStaysOut(Merge& merge) const;

  Connection& ours_;
  Connection& theirs_;
  std::vector<TombstoneRow> our_rows_;
  std::vector<TombstoneRow> their_rows_;
  std::vector<TombstoneRow> all_;  ///< tombstones of both files, each person once
  std::vector<TimedCleaning> cleanings_;
  std::vector<study::RecordId> unfinished_before_;
  bool must_erase_ = false;
};

// Deletes the rows of a person who withdrew. Private to core/store.

/// Deletes all records of the person within the open transaction. The caller has set the tombstone before. Returns the
/// number of deleted records. Throws as Query does.
long long removePerson(Connection& connection, const study::RecordId& person);

// What a withdrawal would delete, said beforehand.

/// Counts of everything that `withdraw` (withdrawal.h) removes, with corrected records, and of what stays.
struct WithdrawalPreview {
  long long sessions = 0;
  long long profiles = 0;
  long long strokes = 0;  ///< of the speed experiment
  long long judgements = 0;
  long long answers = 0;
  long long ratings = 0;
  long long rules = 0;            ///< given directly
  long long events = 0;           ///< lines of the logs
  long long placements = 0;       ///< of the events: of a tube while feeling a model
  long long feel_recordings = 0;  ///< of feeling a model
  /// All removed records, as Withdrawal::records.
  long long records = 0;
  /// Versions of models that hold rules of the participant: the versions stay, without these rules.
  long long models_cleaned = 0;
  /// Versions of models that stay as they are. The participant may have taken part in their membership functions.
  long long models_kept = 0;
};

/// Changes nothing. Returns an error for an unknown person.
base::Result<WithdrawalPreview> previewWithdrawal(const StudyFile& file, const study::RecordId& person);

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
/// (copies.h). Memory use does not grow with the study. Needs disk space for two more copies. Can be
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
