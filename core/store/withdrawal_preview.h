// What a withdrawal would delete, said beforehand.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"

namespace tactus::store {

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

}  // namespace tactus::store
