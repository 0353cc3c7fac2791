// Reads the CSV tables of a full export (record_export.h).
#pragma once

#include <cstdint>
#include <string>

#include "core/base/error.h"
#include "core/store/merge.h"
#include "core/store/study_file.h"

namespace tactus::store {

/// Makes the study file `target`, which must not be there yet, with everything that the tables in `folder` say: every
/// stored column is as it was. It appears whole or not at all. Refused, with file, line and column: a table or column
/// that is missing, a column too many, a value of the wrong kind or outside its range, an id twice, a record of nothing
/// that is there, rows of a participant who withdrew, another number of samples, a model that does not fit its SHA-256,
/// tables of another version of the schema.
base::Result<void> restoreRecords(const std::string& folder, const std::string& target);

/// Adds what the tables in `folder` have and `file` has not, by the rules of mergeStudy (merge.h): by id, nothing is
/// overwritten, conflicts are listed, a person who withdrew in either stays out. Refused as above.
base::Result<Merge> importRecords(StudyFile& file, const std::string& folder, const study::RecordId& log_id,
                                  std::int64_t utc_ms);

}  // namespace tactus::store
