// Writes everything that a study file holds as CSV tables (record_tables.h).
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/store/study_file.h"

namespace tactus::store {

enum class ByteOrderMark { kNone, kWrite };

/// Writes the tables of recordTables() into the new folder `folder`, corrected records too, and with them each
/// recording as `recordings/<stroke id>.csv` and each model as `models/<id>.json`. The same study gives the same bytes.
/// Numbers are written so that they read back exactly. `mark`: a UTF-8 byte order mark at the beginning of each CSV
/// table, for spreadsheet programs, and an apostrophe before text that they would take for a formula (base::guarded).
/// Refused: a recording or model that does not fit its checksum. After an error the
/// folder may hold a part of the tables.
base::Result<void> writeRecords(const StudyFile& file, const std::string& folder,
                                ByteOrderMark mark = ByteOrderMark::kNone);

inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace tactus::store
