// Writes the complete contents of a study file as CSV tables (record_tables.h).
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/store/study_file.h"

namespace tactus::store {

enum class ByteOrderMark { kNone, kWrite };

/// Writes the tables of recordTables() into the new folder `folder`, including corrected records. Also writes each
/// recording as `recordings/<stroke id>.csv` and each model as `models/<id>.json`. The same study gives the same bytes;
/// numbers read back exactly.
/// `mark`: for spreadsheet programs, adds a UTF-8 byte order mark to each CSV table, and an apostrophe before text that
/// looks like a formula (base::guarded).
/// Returns an error if a recording or model does not match its checksum. After an error the folder may hold some of the
/// tables.
base::Result<void> writeRecords(const StudyFile& file, const std::string& folder,
                                ByteOrderMark mark = ByteOrderMark::kNone);

inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace tactus::store
