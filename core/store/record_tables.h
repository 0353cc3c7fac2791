// The tables of a full export: every column of a study file, what it holds and in which unit. The writer, the reader
// and the codebook go by this one description.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tactus::store {

enum class ColumnKind {
  kId,     ///< 32 hexadecimal digits
  kBytes,  ///< hexadecimal digits
  kText,
  kJson,  ///< JSON text, or none
  kInteger,
  kFlag,  ///< 0 or 1
  kNumber,
  kChannels,   ///< JSON, a list of [name, unit]: the columns of the recording's own table
  kRecording,  ///< name of the recording's own table below the folder, `recordings/<id>.csv`
  kModel,      ///< name of the model's file below the folder, `models/<id>.json`
};

/// `id`, `text`, `JSON text`, …
std::string_view name(ColumnKind kind);

struct RecordColumn {
  std::string_view name;  ///< in the study file and in the CSV table
  ColumnKind kind = ColumnKind::kText;
  std::string_view unit;  ///< empty: none
  std::string_view meaning;
  std::string_view refers_to = {};  ///< table that the ids are of
  /// The cell may be empty; an empty number, integer, id or block of bytes is one that was not given.
  bool optional = false;
  int since = 1;  ///< version of the schema that brought it; tables of an older one come without it
};

struct RecordTable {
  std::string_view name;     ///< of the table in the study file
  std::string_view file;     ///< of the CSV table
  std::string_view meaning;  ///< what a row is
  std::string_view order;    ///< of the rows, in SQL
  std::vector<RecordColumn> columns;
  int since = 1;  ///< version of the schema that brought it
};

/// All tables, those first that others refer to.
std::span<const RecordTable> recordTables();

/// The column called `id`, `stroke_id` or `person_id` that tells rows apart: the first one of ids.
const RecordColumn& keyOf(const RecordTable& table);

/// Where the parts of a record that stand in files of their own are, below the folder of the tables.
inline constexpr std::string_view kRecordingsFolder = "recordings";
inline constexpr std::string_view kModelsFolder = "models";

}  // namespace tactus::store
