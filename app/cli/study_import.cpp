#include "app/session/study_import.h"

#include <filesystem>

#include "app/cli/data_text.h"
#include "app/cli/study_commands.h"
#include "app/cli/study_text.h"
#include "app/session/data_checks.h"
#include "core/store/record_import.h"
#include "core/store/study_info.h"
#include "core/study/csv_tables.h"
#include "elicitation/ngt_variables.h"

namespace tactus::cli {
namespace {

using base::Result;

/// Opens the study at `path`, or makes it with the name that `name` gives.
Result<store::StudyFile> openOrMake(const std::string& path, const std::string& name) {
  std::error_code ignored;
  if (!path.empty() && !std::filesystem::exists(path, ignored)) return newStudy(path, name);
  return store::StudyFile::open(path);
}

Result<Output> importFolder(const StudyImportOptions& options) {
  // Everything that can be wrong with the tables is found before a file is made.
  const auto tables = study::readStudyFolder(options.folder, elicitation::ngtInputIds());
  if (!tables) return tl::unexpected(tables.error());
  const auto data = session::dataFindings(tables->study);
  if (auto ok = study::refuseData(data); !ok) return study::inStudyFolder(ok.error(), options.folder);
  auto file = openOrMake(options.file, tables->study.name);
  if (!file) return tl::unexpected(file.error());
  auto imported = session::importTables(tables->study, *file);
  if (!imported) return base::inFile(imported.error(), options.file);
  if (auto closed = file->close(); !closed) return tl::unexpected(closed.error());

  std::vector<std::string> notes = tables->notes;
  notes.insert(notes.end(), imported->notes.begin(), imported->notes.end());
  if (options.json) {
    base::JsonWriter json;
    json.beginObject().key("file").value(options.file).key("folder").value(options.folder);
    json.key("persons").value(imported->persons).key("sessions").value(imported->sessions);
    json.key("records").value(imported->records).key("notes").values(notes);
    writeData(data, json);
    json.endObject();
    return Output{json.text(), {}};
  }
  return Output{dataAsText(data) + "Added persons " + std::to_string(imported->persons) + ", sessions " +
                    std::to_string(imported->sessions) + ", records " + std::to_string(imported->records) + " to " +
                    options.file + '\n',
                std::move(notes)};
}

/// Makes the study that a full export was made of.
Result<Output> restore(const StudyImportOptions& options, const std::string& records) {
  if (auto restored = store::restoreRecords(records, options.file); !restored) return tl::unexpected(restored.error());
  const auto file = store::StudyFile::open(options.file, {store::Access::kReadOnly});
  if (!file) return tl::unexpected(file.error());
  auto info = store::studyInfo(*file);
  if (!info) return tl::unexpected(info.error());
  if (!options.json) return Output{"Made " + options.file + " as it was exported\n", {}};
  store::Merge merge;
  merge.added = std::move(info->counts);
  std::erase_if(merge.added, [](const store::TableCount& count) { return count.rows == 0; });
  base::JsonWriter json;
  json.beginObject().key("file").value(options.file).key("folder").value(options.folder);
  writeMerge(merge, json);
  json.endObject();
  return Output{json.text(), {}};
}

/// Adds a full export to a study that is there.
Result<Output> importRecords(const StudyImportOptions& options, const std::string& records) {
  auto file = store::StudyFile::open(options.file);
  if (!file) return tl::unexpected(file.error());
  const auto merge = store::importRecords(*file, records, study::RecordIds().next(), utcNowMs());
  if (!merge) return tl::unexpected(merge.error());
  if (auto closed = file->close(); !closed) return tl::unexpected(closed.error());
  if (!options.json) return Output{options.folder + ": " + mergeAsText(*merge), {}};
  base::JsonWriter json;
  json.beginObject().key("file").value(options.file).key("folder").value(options.folder);
  writeMerge(*merge, json);
  json.endObject();
  return Output{json.text(), {}};
}

}  // namespace

Result<Output> studyImport(const StudyImportOptions& options) {
  std::error_code ignored;
  const std::string records = (std::filesystem::path(options.folder) / "records").string();
  if (!std::filesystem::is_directory(records, ignored)) return importFolder(options);
  const bool is_there = std::filesystem::exists(options.file, ignored);
  return is_there ? importRecords(options, records) : restore(options, records);
}

}  // namespace tactus::cli
