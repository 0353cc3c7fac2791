// The tables of a full export: every column of a study file with meaning and unit. Writer, reader and codebook all use
// this description.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"

namespace tactus::store {

/// Writes the complete contents of a study file as CSV tables (record_tables.h).
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

enum class ColumnKind {
  kId,     ///< 32 hexadecimal digits
  kBytes,  ///< hexadecimal digits
  kText,
  kJson,  ///< JSON text, or empty
  kInteger,
  kFlag,  ///< 0 or 1
  kNumber,
  kChannels,   ///< JSON, a list of [name, unit]: the columns of the recording's own CSV table
  kRecording,  ///< name of the recording's own CSV table below the folder, `recordings/<id>.csv`
  kModel,      ///< name of the model's file below the folder, `models/<id>.json`
};

/// `id`, `text`, `JSON text`, …
std::string_view name(ColumnKind kind);

struct RecordColumn {
  std::string_view name;  ///< in the study file and in the CSV table
  ColumnKind kind = ColumnKind::kText;
  std::string_view unit;  ///< empty: no unit
  std::string_view meaning;
  std::string_view refers_to = {};  ///< table that the ids belong to
  /// The cell may be empty, which means that the value was not given.
  bool optional = false;
};

struct RecordTable {
  std::string_view name;     ///< of the table in the study file
  std::string_view file;     ///< of the CSV table
  std::string_view meaning;  ///< meaning of a row
  std::string_view order;    ///< of the rows, in SQL
  std::vector<RecordColumn> columns;
};

/// All tables. A table comes after those that it refers to.
std::span<const RecordTable> recordTables();

/// The key column of a table (`id`, `stroke_id` or `person_id`): the first column of ids.
const RecordColumn& keyOf(const RecordTable& table);

/// Folders for the separate files of records, below the folder of the tables.
inline constexpr std::string_view kRecordingsFolder = "recordings";
inline constexpr std::string_view kModelsFolder = "models";

}  // namespace tactus::store
