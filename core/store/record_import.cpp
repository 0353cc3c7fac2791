#include "core/store/record_import.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "core/base/files/file.h"
#include "core/store/backup.h"
#include "core/store/record_rows.h"
#include "core/store/schema.h"
#include "core/store/work_folder.h"

namespace tactus::store {
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

/// The first record of the new study, and the version of the schema that its tables are of.
struct FirstRecord {
  NewStudy study;
  int version = 0;
};

FirstRecord firstRecordIn(const std::string& folder) {
  const RecordTable& table = recordTables().front();
  const RecordRows rows(table, folder, 1);
  const base::CsvTable& csv = rows.csv();
  if (csv.rowCount() != 1) {
    throw Refusal{{ErrorCode::kData, csv.file(), {}, std::to_string(csv.rowCount()) + " rows", "one row"}};
  }
  const auto text = [&](const char* column) { return std::string(csv.cell(0, *csv.find(column))); };
  const auto version = orRefuse(csv.integer(0, *csv.find("schema_version")));
  const int newest = schemaSteps().back().version;
  if (version < 1 || version > newest) {
    throw Refusal{csv.refuse(0, *csv.find("schema_version"), ErrorCode::kVersion,
                             "a version up to " + std::to_string(newest) + ", which this program knows")
                      .value()};
  }
  const auto id = study::parseRecordId(text("id"));
  if (!id || id->isNil()) rows.refuseCell(0, table.columns.front(), "an id of 32 hexadecimal digits");
  const auto created_utc_ms = orRefuse(csv.integer(0, *csv.find("created_utc_ms")));
  return {{*id, text("name"), created_utc_ms, text("program")}, static_cast<int>(version)};
}

/// The tables as a study file of their own at `path`.
Result<StudyFile> studyFromTables(const std::string& folder, const std::string& path) {
  FirstRecord first;
  try {
    first = firstRecordIn(folder);
  } catch (const Refusal& refusal) {
    return tl::unexpected(refusal.error);
  }
  auto file = StudyFile::create(path, first.study);
  if (!file) return file;
  Connection& connection = file->connection();
  auto filled = inTransaction(connection, [&] {
    for (const auto& table : recordTables().subspan(1)) {
      if (table.since <= first.version) RecordRows(table, folder, first.version).insert(connection);
    }
  });
  if (!filled) return tl::unexpected(filled.error());
  return file;
}

}  // namespace

Result<void> restoreRecords(const std::string& folder, const std::string& target) {
  auto work = WorkFolder::beside(target);
  if (!work) return tl::unexpected(work.error());
  auto made = studyFromTables(folder, work->file(nameOf(folder)));
  if (!made) return tl::unexpected(made.error());
  return backUp(*made, target);
}

Result<Merge> importRecords(StudyFile& file, const std::string& folder, const study::RecordId& log_id,
                            std::int64_t utc_ms) {
  auto work = WorkFolder::beside(file.path());
  if (!work) return tl::unexpected(work.error());
  const std::string path = work->file(nameOf(folder));
  auto made = studyFromTables(folder, path);
  if (!made) return tl::unexpected(made.error());
  if (auto closed = made->close(); !closed) return tl::unexpected(closed.error());
  const auto hash = recordsSha256(folder);
  if (!hash) return tl::unexpected(hash.error());
  return mergeStudy(file, path, log_id, utc_ms, *hash);
}

}  // namespace tactus::store
