// The persons who withdrew from one of two studies being merged: their data do not enter and are removed where present.
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

}  // namespace tactus::store
