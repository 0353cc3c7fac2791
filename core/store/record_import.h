// Reads the CSV tables of a full export (record_tables.h).
#pragma once

#include <cstdint>
#include <string>

#include "core/base/error.h"
#include "core/store/merge.h"
#include "core/store/study_file.h"

namespace tactus::store {

/// Creates the study file `target` from the tables in `folder`: every stored column has its exported value. The file
/// appears completely or not at all.
/// Returns an error with file, line and column for: an existing `target`, a missing table or column, an extra column, a
/// value of the wrong kind or outside its range, a duplicate id, a reference to a missing record, rows of a participant
/// who withdrew, a wrong number of samples, a model that does not match its SHA-256, tables of another schema version.
base::Result<void> restoreRecords(const std::string& folder, const std::string& target);

/// Adds the records of the tables in `folder` that `file` lacks, by the rules of mergeStudy (merge.h): by id, without
/// overwriting, with a list of conflicts, without persons who withdrew in either. Returns the same errors as
/// restoreRecords.
base::Result<Merge> importRecords(StudyFile& file, const std::string& folder, const study::RecordId& log_id,
                                  std::int64_t utc_ms);

}  // namespace tactus::store
