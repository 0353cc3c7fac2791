#include "app/session/study_export.h"

#include <filesystem>
#include <random>
#include <utility>

#include "app/cli/findings_text.h"
#include "app/cli/study_build.h"
#include "app/cli/study_commands.h"
#include "app/cli/study_text.h"
#include "app/dataset/dataset.h"
#include "app/session/data_checks.h"
#include "app/session/export_folder.h"
#include "app/session/study_import.h"
#include "app/session/study_source.h"
#include "app/session/trials.h"
#include "app/version.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/store/record_import.h"
#include "core/store/study_info.h"
#include "core/study/csv_tables.h"
#include "core/study/table_line.h"

namespace tactus::cli {
namespace {

using base::Result;

/// What the tables of a folder gave, and what is to be said besides.
struct Imported {
  session::StudyImport import;
  std::vector<std::string> notices = {};   ///< of the opening of the study
  std::vector<std::string> warnings = {};  ///< of its end
};

Result<Imported> intoStudy(const std::string& path, const study::Study& tables, const session::ImportSource& source) {
  std::error_code ignored;
  if (!path.empty() && !std::filesystem::exists(path, ignored)) {
    TACTUS_TRY(auto imported, session::importAsNewStudy(tables, path, source, std::string(kGenerator)));
    return Imported{std::move(imported)};
  }
  std::vector<std::string> notices;
  TACTUS_TRY(auto file, openToWrite(path, notices));
  auto imported = session::importTables(tables, file, source);
  if (!imported) return base::inFile(imported.error(), path);
  for (auto& notice : noticesOf(file)) notices.push_back(std::move(notice));
  return Imported{std::move(*imported), std::move(notices), closeSaved(file)};
}

Result<Output> importFolder(const StudyImportOptions& options) {
  const std::string& folder = options.sources.front();
  TACTUS_TRY(const auto accepted, acceptedKinds(options.accept));
  // Everything that can be wrong with the tables is found before a file is made.
  TACTUS_TRY(auto procedure, session::procedureAt(options.file));
  TACTUS_TRY(const auto tables, session::readTables(folder, std::move(procedure)));
  const auto data = session::dataFindings(tables.study);
  if (auto ok = study::refuseData(data, accepted); !ok) return study::inStudyFolder(ok.error(), folder);
  TACTUS_TRY(const auto source, session::tablesSource(folder, tables.study.name, utcNowMs()));
  TACTUS_TRY(auto done, intoStudy(options.file, tables.study, source));
  const auto* imported = &done.import;

  std::vector<std::string> notes = std::move(done.warnings);
  notes.insert(notes.end(), tables.notes.begin(), tables.notes.end());
  notes.insert(notes.end(), imported->notes.begin(), imported->notes.end());
  for (auto& note : acceptedNotes(data, accepted)) notes.push_back(std::move(note));
  if (options.json) {
    base::JsonWriter json;
    json.beginObject().key("file").value(options.file).key("folder").value(folder);
    json.key("persons").value(imported->persons).key("sessions").value(imported->sessions);
    json.key("records").value(imported->records).key("notes").values(notes);
    json.key("notices").values(done.notices);
    writeData(data, json);
    json.endObject();
    return Output{json.text(), std::move(done.notices)};
  }
  notes.insert(notes.begin(), done.notices.begin(), done.notices.end());
  return Output{dataAsText(data, accepted) + "Added persons " + std::to_string(imported->persons) + ", sessions " +
                    std::to_string(imported->sessions) + ", records " + std::to_string(imported->records) + " to " +
                    base::oneLine(options.file) + '\n',
                std::move(notes)};
}

/// Makes the study that a full export was made of.
Result<Output> restore(const StudyImportOptions& options, const std::string& records) {
  const std::string& folder = options.sources.front();
  if (auto restored = store::restoreRecords(records, options.file); !restored) return tl::unexpected(restored.error());
  TACTUS_TRY(const auto file, store::StudyFile::open(options.file, {store::Access::kReadOnly}));
  TACTUS_TRY(auto info, store::studyInfo(file));
  if (!options.json) return Output{"Made " + base::oneLine(options.file) + " from the export\n", {}};
  store::Merge merge;
  merge.added = std::move(info.counts);
  std::erase_if(merge.added, [](const store::TableCount& count) { return count.rows == 0; });
  base::JsonWriter json;
  json.beginObject().key("file").value(options.file).key("folder").value(folder);
  writeMerge(merge, json);
  json.key("notices").values(std::vector<std::string>{}).endObject();  // a study that was made just now
  return Output{json.text(), {}};
}

/// Adds a full export to a study that is there.
Result<Output> importRecords(const StudyImportOptions& options, const std::string& records) {
  const std::string& folder = options.sources.front();
  std::vector<std::string> warnings;
  TACTUS_TRY(auto file, openToWrite(options.file, warnings));
  TACTUS_TRY(const auto merge, store::importRecords(file, records, study::RecordIds().next(), utcNowMs()));
  for (auto& notice : noticesOf(file)) warnings.push_back(std::move(notice));
  const auto notices = warnings;
  for (auto& warning : closeSaved(file)) warnings.push_back(std::move(warning));
  if (!options.json) return Output{base::oneLine(folder) + ": " + mergeAsText(merge), std::move(warnings)};
  base::JsonWriter json;
  json.beginObject().key("file").value(options.file).key("folder").value(folder);
  writeMerge(merge, json);
  json.key("notices").values(notices).endObject();
  return Output{json.text(), std::move(warnings)};
}

}  // namespace

Result<Output> studyImport(const StudyImportOptions& options) {
  std::error_code ignored;
  const bool are_files =
      options.sources.size() > 1 || std::filesystem::is_regular_file(options.sources.front(), ignored);
  if (are_files) return studyAnswers(options);
  session::removeOurs(session::leftoversOfStudy(options.file));  // of an import that was stopped
  const std::string records = (std::filesystem::path(options.sources.front()) / "records").string();
  if (!std::filesystem::is_directory(records, ignored)) return importFolder(options);
  const bool is_there = std::filesystem::exists(options.file, ignored);
  return is_there ? importRecords(options, records) : restore(options, records);
}

namespace {

/// A random seed that is not kept, so that the order of the participants stays secret.
std::uint64_t secretSeed() {
  std::random_device device;
  return (static_cast<std::uint64_t>(device()) << 32U) | device();
}

base::Result<Output> dataSet(const StudyExportOptions& options) {
  TACTUS_TRY(auto tables, session::readStudy(options.file));
  const auto layout = options.layout == "bids" ? dataset::Layout::kBids : dataset::Layout::kPsychDs;
  TACTUS_TRY(auto trials, session::trialsAt(options.file));
  TACTUS_TRY(const auto done,
             dataset::writeDataSet(tables.study, layout, options.folder, secretSeed(), kGenerator, std::move(trials)));
  std::vector<std::string> notes = std::move(tables.notes);
  notes.insert(notes.end(), done.notes.begin(), done.notes.end());
  if (options.json) {
    base::JsonWriter json;
    json.beginObject().key("file").value(options.file).key("folder").value(options.folder);
    json.key("layout").value(options.layout).key("profile").value("shareable");
    json.key("participants").value(done.participants).key("files").value(done.files);
    json.key("notes").values(notes).key("notices").values(tables.notices).endObject();
    return Output{json.text(), std::move(tables.notices)};
  }
  notes.insert(notes.begin(), tables.notices.begin(), tables.notices.end());
  return Output{"Wrote " + std::to_string(done.participants) + " participants in the layout " + options.layout +
                    " to " + base::oneLine(options.folder) +
                    "; read README and enter authors and license before it is published\n",
                std::move(notes)};
}

}  // namespace

base::Result<Output> studyExport(const StudyExportOptions& options) {
  if (!options.layout.empty()) return dataSet(options);
  TACTUS_TRY(const auto file, store::StudyFile::open(options.file, {store::Access::kReadOnly}));
  session::ExportOptions settings;
  settings.shareable = options.shareable;
  settings.seed = secretSeed();
  settings.mark = options.mark ? store::ByteOrderMark::kWrite : store::ByteOrderMark::kNone;
  TACTUS_TRY(auto done, session::exportStudy(file, options.folder, settings));
  auto notices = noticesOf(file);
  const std::string profile = options.shareable ? "shareable" : "full";
  if (options.json) {
    base::JsonWriter json;
    json.beginObject().key("file").value(options.file).key("folder").value(options.folder);
    json.key("profile").value(profile).key("participants").value(done.participants);
    json.key("notes").values(done.notes).key("notices").values(notices).endObject();
    return Output{json.text(), std::move(notices)};
  }
  done.notes.insert(done.notes.begin(), notices.begin(), notices.end());
  return Output{"Wrote the " + profile + " export of " + std::to_string(done.participants) + " participants to " +
                    base::oneLine(options.folder) + "; codebook.md describes the tables\n",
                std::move(done.notes)};
}

}  // namespace tactus::cli
