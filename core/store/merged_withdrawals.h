// Who withdrew from one of two studies that are merged: their data come in nowhere, and go where they are.
// Private to core/store.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/store/connection.h"
#include "core/store/merge.h"
#include "core/store/name_cleaning.h"
#include "core/store/withdrawn_codes.h"

namespace tactus::store {

/// The names of one person who withdrew, to be taken out of texts.
struct TimedCleaning {
  NameCleaning cleaning;
  std::int64_t utc_ms = 0;  ///< when the person withdrew
};

/// Within the transaction of a merge. Throws as Query does.
class MergedWithdrawals {
 public:
  /// Refuses the merge where a participant of one file has the code of somebody else who withdrew from the other: it
  /// may be the same person, recorded again, or another one, who needs another code.
  MergedWithdrawals(Connection& ours, Connection& theirs);

  /// Takes over the tombstones of the other file, removes here who withdrew there, and cleans our models and texts.
  /// What was removed and what stays out is told in `merge`.
  void apply(Merge& merge);

  /// For each text that comes in.
  const std::vector<TimedCleaning>& cleanings() const { return cleanings_; }

  /// To be called when all rows are in. Whether traces in this file are to be erased after the commit.
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
  std::vector<TombstoneRow> all_;  ///< of both, each person once
  std::vector<TimedCleaning> cleanings_;
  std::vector<study::RecordId> unfinished_before_;
  bool must_erase_ = false;
};

}  // namespace tactus::store
