#include "core/store/record_import.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sqlite3.h>
#include <string>
#include <type_traits>
#include <utility>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/files/checksums.h"
#include "core/base/files/file.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/store/connection.h"
#include "core/store/copies.h"
#include "core/store/migrations.h"
#include "core/store/query.h"
#include "core/store/record_checksum.h"
#include "core/store/record_tables.h"
#include "core/store/recording_codec.h"

namespace tactus::store {

// Inserts the rows of one CSV table of a full export into its database table. Private to core/store.

/// Throws SQLite::Exception if the file fails, and Refusal with table, line and column for invalid data.
class RecordRows {
 public:
  /// Reads the table in `folder`.
  RecordRows(const RecordTable& table, const std::string& folder);

  const base::CsvTable& csv() const { return csv_; }

  /// Inserts all rows within the open transaction. A correction is inserted after the record it corrects, regardless of
  /// their order in the CSV table.
  void insert(Connection& connection);

  [[noreturn]] void refuseCell(std::size_t row, const RecordColumn& column, std::string wanted) const;

 private:
  void insertRow(Connection& connection, Query& query, std::size_t row);
  void putCell(Query& query, std::size_t row, const RecordColumn& column);
  void putRecording(Query& query, std::size_t row, const RecordColumn& column);
  /// Binds a cell that was not given.
  static void putNothing(Query& query, const RecordColumn& column);
  void requireReferences(Connection& connection, std::size_t row) const;
  std::string cell(std::size_t row, const RecordColumn& column) const;
  std::optional<study::RecordId> idIn(std::size_t row, const RecordColumn& column) const;
  std::int64_t integerIn(std::size_t row, const RecordColumn& column) const;
  /// The row's own file below the folder. The cell must hold exactly this name.
  std::string ownFile(std::size_t row, const RecordColumn& column, std::string_view below,
                      std::string_view ending) const;

  const RecordTable& table_;
  std::string folder_;
  base::CsvTable csv_;
};

/// The value of `result`. Throws its error as a Refusal.
template <class Value>
Value orRefuse(base::Result<Value> result) {
  if (!result) throw Refusal{std::move(result.error())};
  if constexpr (!std::is_void_v<Value>) return *std::move(result);
}

namespace {

namespace fs = std::filesystem;
using base::ErrorCode;
using study::RecordId;

constexpr std::size_t kMostModelBytes = std::size_t{256} << 20U;

/// The bytes that an even number of hexadecimal digits stands for, or nothing.
std::optional<std::string> bytesOf(const std::string& digits) {
  const auto value = [](char c) { return c <= '9' ? c - '0' : std::tolower(static_cast<unsigned char>(c)) - 'a' + 10; };
  const auto is_digit = [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; };
  if (digits.size() % 2 != 0 || !std::all_of(digits.begin(), digits.end(), is_digit)) return std::nullopt;
  std::string bytes;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    bytes += static_cast<char>(value(digits[i]) * 16 + value(digits[i + 1]));
  }
  return bytes;
}

const RecordColumn& columnOf(const RecordTable& table, std::string_view name) {
  const auto it = std::find_if(table.columns.begin(), table.columns.end(),
                               [name](const RecordColumn& column) { return column.name == name; });
  TACTUS_CHECK(it != table.columns.end());
  return *it;
}

const RecordTable& tableCalled(std::string_view name) {
  const auto tables = recordTables();
  const auto it = std::find_if(tables.begin(), tables.end(), [name](const auto& table) { return table.name == name; });
  TACTUS_CHECK(it != tables.end());
  return *it;
}

/// Whether the cell is a code or an id of a term, level, series or form: what tables are joined by.
bool isName(const RecordColumn& column, const std::string& text) {
  if (column.name == "value") return !base::parseNumber(text);  // of an answer: a term, or a number on a scale
  constexpr std::array<std::string_view, 6> kNames = {"code", "level", "series", "term", "form", "then"};
  return std::find(kNames.begin(), kNames.end(), column.name) != kNames.end();
}

/// Whether `text` names the column as a whole word.
bool names(const std::string& text, std::string_view column) {
  const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (auto at = text.find(column); at != std::string::npos; at = text.find(column, at + 1)) {
    const auto end = at + column.size();
    if ((at == 0 || !is_word(text[at - 1])) && (end == text.size() || !is_word(text[end]))) return true;
  }
  return false;
}

std::vector<study::Channel> channelsIn(const std::string& text) {
  auto pairs = pairListIn(text);
  if (!pairs) refuse(ErrorCode::kSchema, {}, base::quoted(text), "a list of [name, unit]");
  std::vector<study::Channel> channels;
  for (auto& [name, unit] : *pairs) channels.push_back({std::move(name), std::move(unit), {}});
  return channels;
}

/// The file `below` the folder; refuses one that a link takes elsewhere.
std::string inside(const std::string& folder, const fs::path& below) {
  std::string path = (fs::path(folder) / below).string();
  if (auto below_it = base::requireBelow(folder, path); !below_it) throw Refusal{std::move(below_it.error())};
  return path;
}

}  // namespace

RecordRows::RecordRows(const RecordTable& table, const std::string& folder)
    : table_(table), folder_(folder), csv_(orRefuse(base::CsvTable::read(inside(folder, table.file)))) {
  for (const auto& column : table.columns) {
    orRefuse(csv_.require(column.name));
  }
  for (const auto& found : csv_.columns()) {
    const bool known = std::any_of(table.columns.begin(), table.columns.end(),
                                   [&](const RecordColumn& column) { return column.name == found; });
    if (!known) {
      throw Refusal{{ErrorCode::kSchema, csv_.file(), "header", "a column " + base::quoted(found),
                     "the columns of a full export only"}};
    }
  }
}

void RecordRows::insert(Connection& connection) {
  const auto own = std::find_if(table_.columns.begin(), table_.columns.end(),
                                [&](const RecordColumn& column) { return column.refers_to == table_.name; });
  Query query(connection, insertion(connection, table_.name));
  std::set<RecordId> done;
  std::vector<std::size_t> waiting;
  for (std::size_t row = 0; row < csv_.rowCount(); ++row) waiting.push_back(row);
  // Each round inserts the rows that correct nothing or what is there already.
  while (!waiting.empty()) {
    std::vector<std::size_t> later;
    for (const std::size_t row : waiting) {
      const auto before = own == table_.columns.end() ? std::nullopt : idIn(row, *own);
      if (before && !done.contains(*before)) {
        later.push_back(row);
        continue;
      }
      insertRow(connection, query, row);
      if (own != table_.columns.end()) done.insert(*idIn(row, keyOf(table_)));
    }
    if (later.size() == waiting.size()) refuseCell(later.front(), *own, "the id of another row of this table");
    waiting = std::move(later);
  }
}

void RecordRows::insertRow(Connection& connection, Query& query, std::size_t row) {
  requireReferences(connection, row);
  try {
    for (const auto& column : table_.columns) {
      putCell(query, row, column);
    }
    query.run();
  } catch (const SQLite::Exception& exception) {
    if ((exception.getErrorCode() & 0xFF) != SQLITE_CONSTRAINT) throw;  // the low byte of an extended code
    const std::string what = exception.what();
    if (what.ends_with("this record is there already")) refuseCell(row, keyOf(table_), "each record once");
    for (const auto& column : table_.columns) {
      if (what.starts_with("CHECK") && names(what, column.name))
        refuseCell(row, column, "a value of the study (" + what + ")");
    }
    throw Refusal{{ErrorCode::kData, csv_.file(), "line " + std::to_string(csv_.line(row)),
                   "a row that a study refuses (" + what + ")", "a row as it was exported"}};
  }
}

void RecordRows::requireReferences(Connection& connection, std::size_t row) const {
  for (const auto& column : table_.columns) {
    if (column.refers_to.empty() || column.refers_to == table_.name) continue;
    const auto id = idIn(row, column);
    if (!id && column.optional) continue;
    const RecordTable& target = tableCalled(column.refers_to);
    Query there(connection,
                "SELECT 1 FROM " + std::string(target.name) + " WHERE " + std::string(keyOf(target).name) + " = ?");
    if (!id || !there.put(*id).next()) {
      throw Refusal{
          csv_.refuse(row, *csv_.find(column.name), ErrorCode::kReference, "an id of " + std::string(target.file))
              .value()};
    }
  }
}

void RecordRows::putNothing(Query& query, const RecordColumn& column) {
  if (column.kind == ColumnKind::kText) {
    query.put("");
  } else {
    query.put(std::optional<double>());
  }
}

void RecordRows::putCell(Query& query, std::size_t row, const RecordColumn& column) {
  const std::string text = cell(row, column);
  const std::size_t at = *csv_.find(column.name);
  switch (column.kind) {
    case ColumnKind::kId: query.put(idIn(row, column)); return;
    case ColumnKind::kText:
    case ColumnKind::kJson:
      if (text.find('\0') != std::string::npos) refuseCell(row, column, "text without a byte 0");
      if (isName(column, text) && base::looksLikeFormula(text)) refuseCell(row, column, base::kNoFormula);
      if (column.kind == ColumnKind::kJson && !text.empty() && !nlohmann::json::accept(text))
        refuseCell(row, column, "JSON text, or none");
      query.put(text);
      return;
    case ColumnKind::kBytes: {
      const auto bytes = bytesOf(text);
      if (!bytes) refuseCell(row, column, "hexadecimal digits");
      if (bytes->empty()) {
        putNothing(query, column);
      } else {
        query.putBlob(*bytes);
      }
      return;
    }
    case ColumnKind::kInteger:
    case ColumnKind::kFlag:
      query.put(column.optional && text.empty() ? std::nullopt : std::optional(integerIn(row, column)));
      return;
    case ColumnKind::kNumber:
      query.put(column.optional && text.empty() ? std::nullopt : std::optional(orRefuse(csv_.number(row, at))));
      return;
    case ColumnKind::kChannels: return;  // with the recording
    case ColumnKind::kRecording: putRecording(query, row, column); return;
    case ColumnKind::kModel: {
      const auto model = orRefuse(base::readFile(ownFile(row, column, kModelsFolder, ".json"), kMostModelBytes));
      const RecordColumn& hash = columnOf(table_, "sha256");
      if (base::sha256(model) != cell(row, hash)) refuseCell(row, hash, "the SHA-256 of the model's file");
      query.put(model);
      return;
    }
  }
}

void RecordRows::putRecording(Query& query, std::size_t row, const RecordColumn& column) {
  const auto samples = orRefuse(base::CsvTable::read(ownFile(row, column, kRecordingsFolder, ".csv")));
  study::Recording recording;
  recording.sample_rate_hz = orRefuse(csv_.number(row, *csv_.find("sample_rate_hz")));
  const RecordColumn& list = columnOf(table_, "channel_list");
  try {
    recording.channels = channelsIn(cell(row, list));
  } catch (const Refusal&) {
    refuseCell(row, list, "a list of [name, unit]");
  }
  if (samples.columns().size() != recording.channels.size() + 1) {
    throw Refusal{
        {ErrorCode::kSchema, samples.file(), "header", std::to_string(samples.columns().size()) + " columns",
         "the column sample and one for each of the " + std::to_string(recording.channels.size()) + " channels"}};
  }
  for (std::size_t sample = 0; sample < samples.rowCount(); ++sample) {
    if (orRefuse(samples.integer(sample, 0)) != static_cast<long long>(sample)) {
      throw Refusal{samples.refuse(sample, 0, ErrorCode::kValue, "sample " + std::to_string(sample)).value()};
    }
    for (std::size_t i = 0; i < recording.channels.size(); ++i) {
      recording.channels[i].values.push_back(orRefuse(samples.number(sample, i + 1)));
    }
  }
  const RecordColumn& count = columnOf(table_, "samples");
  if (cell(row, count) != std::to_string(recording.size()))
    refuseCell(row, count, std::to_string(recording.size()) + ", as in the table of samples");
  const auto bytes = encodeRecording(recording);
  if (!bytes) throw Refusal{base::inFile(bytes.error(), samples.file()).value()};
  query.putBlob(*bytes);
}

std::string RecordRows::ownFile(std::size_t row, const RecordColumn& column, std::string_view below,
                                std::string_view ending) const {
  const fs::path path = fs::path(below) / (study::toText(*idIn(row, keyOf(table_))) + std::string(ending));
  if (cell(row, column) != path.generic_string()) refuseCell(row, column, path.generic_string());
  return inside(folder_, path);
}

std::string RecordRows::cell(std::size_t row, const RecordColumn& column) const {
  const auto text = csv_.cell(row, *csv_.find(column.name));
  const bool is_guarded = csv_.hasMark() && column.kind == ColumnKind::kText;
  return std::string(is_guarded ? base::withoutGuard(text) : text);
}

std::optional<RecordId> RecordRows::idIn(std::size_t row, const RecordColumn& column) const {
  const std::string text = cell(row, column);
  if (text.empty() && column.optional) return std::nullopt;
  const auto id = study::parseRecordId(text);
  if (!id || id->isNil()) refuseCell(row, column, "an id of 32 hexadecimal digits");
  return id;
}

std::int64_t RecordRows::integerIn(std::size_t row, const RecordColumn& column) const {
  const std::int64_t value = orRefuse(csv_.integer(row, *csv_.find(column.name)));
  const bool is_time = column.unit == "ms" || column.unit == "ns";
  if (!is_time && std::abs(value) > std::numeric_limits<int>::max()) refuseCell(row, column, "a number of 32 bits");
  return value;
}

void RecordRows::refuseCell(std::size_t row, const RecordColumn& column, std::string wanted) const {
  throw Refusal{csv_.refuse(row, *csv_.find(column.name), ErrorCode::kValue, std::move(wanted)).value()};
}

namespace {

namespace fs = std::filesystem;
using base::Error;
using base::ErrorCode;
using base::Result;

/// The name of the folder itself, which import_log keeps.
std::string nameOf(const std::string& folder) {
  std::error_code ignored;
  auto path = fs::weakly_canonical(folder, ignored);
  if (path.filename() == "records") path = path.parent_path();
  return path.filename().empty() ? "tables" : path.filename().string();
}

/// Over everything that is read of an export.
Result<std::string> recordsSha256(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (at->is_regular_file(error)) names.push_back(at->path().lexically_relative(folder).generic_string());
  }
  std::sort(names.begin(), names.end());
  return base::listingSha256(folder, names);
}

/// The version of the exports from before the release that have the tables of version 1.
constexpr int kLastBeforeRelease = 5;

NewStudy firstRecordIn(const std::string& folder) {
  const RecordTable& table = recordTables().front();
  const RecordRows rows(table, folder);
  const base::CsvTable& csv = rows.csv();
  if (csv.rowCount() != 1) {
    throw Refusal{{ErrorCode::kData, csv.file(), {}, std::to_string(csv.rowCount()) + " rows", "one row"}};
  }
  const auto text = [&](const char* column) { return std::string(csv.cell(0, *csv.find(column))); };
  const auto version = orRefuse(csv.integer(0, *csv.find("schema_version")));
  const int newest = schemaSteps().back().version;
  if ((version < 1 || version > newest) && version != kLastBeforeRelease) {
    throw Refusal{csv.refuse(0, *csv.find("schema_version"), ErrorCode::kVersion,
                             "a version up to " + std::to_string(newest) + ", or " +
                                 std::to_string(kLastBeforeRelease) + " (the last one from before the release)")
                      .value()};
  }
  const auto id = study::parseRecordId(text("id"));
  if (!id || id->isNil()) rows.refuseCell(0, table.columns.front(), "an id of 32 hexadecimal digits");
  const auto created_utc_ms = orRefuse(csv.integer(0, *csv.find("created_utc_ms")));
  return {*id, text("name"), created_utc_ms, text("program")};
}

/// The tables as a study file of their own at `path`.
Result<StudyFile> studyFromTables(const std::string& folder, const std::string& path) {
  NewStudy first;
  try {
    first = firstRecordIn(folder);
  } catch (const Refusal& refusal) {
    return tl::unexpected(refusal.error);
  }
  auto file = StudyFile::create(path, first);
  if (!file) return file;
  Connection& connection = file->connection();
  auto filled = inTransaction(connection, [&] {
    for (const auto& table : recordTables().subspan(1)) {
      RecordRows(table, folder).insert(connection);
    }
  });
  if (!filled) return tl::unexpected(filled.error());
  return file;
}

}  // namespace

Result<void> restoreRecords(const std::string& folder, const std::string& target) {
  TACTUS_TRY(auto work, WorkFolder::beside(target));
  TACTUS_TRY(auto made, studyFromTables(folder, work.file(nameOf(folder))));
  return backUp(made, target);
}

Result<Merge> importRecords(StudyFile& file, const std::string& folder, const study::RecordId& log_id,
                            std::int64_t utc_ms) {
  TACTUS_TRY(auto work, WorkFolder::beside(file.path()));
  const std::string path = work.file(nameOf(folder));
  TACTUS_TRY(auto made, studyFromTables(folder, path));
  if (auto closed = made.close(); !closed) return tl::unexpected(closed.error());
  TACTUS_TRY(const auto hash, recordsSha256(folder));
  return mergeStudy(file, path, log_id, utc_ms, hash);
}

}  // namespace tactus::store
