#include "app/dataset/dataset.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "app/dataset/bids.h"
#include "app/session/export_folder.h"
#include "app/session/study_export.h"
#include "core/base/error.h"
#include "core/base/files/descriptor.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/base/tables/csv.h"
#include "core/procedure/procedure.h"
#include "core/study/csv_tables.h"
#include "core/study/table_line.h"

namespace tactus::dataset {
namespace {

constexpr std::string_view kLeftOut =
    "Only what counts is here: no practice, no stroke that was not accepted, no judgement that is not scored, no "
    "corrected record. Participants have new codes in a random order. Years of experience are bands. Dates, times of "
    "day, places, names of devices and notes are left out, and so are categories and hands in other than the usual "
    "words. With "
    "few participants a rare combination may still tell who somebody is: look at the table of participants before the "
    "data set is published.";
constexpr std::string_view kToEnter =
    "Before the data set is published, enter its authors and its license in dataset_description.json.";

tl::unexpected<base::Error> refused(const std::string& path, std::string wanted) {
  return tl::unexpected(
      base::Error{base::ErrorCode::kIo, path, {}, std::generic_category().message(errno), std::move(wanted)});
}

}  // namespace

namespace {

/// The procedure within a sentence.
std::string procedureOf(const study::Study& study) {
  std::string title = procedure::of(study).titleIn("en");
  // Two capitals begin a short name such as MRI.
  if (title.size() > 1 && title[0] >= 'A' && title[0] <= 'Z' && title[1] >= 'a') title[0] += 'a' - 'A';
  return title;
}

std::string measuredIn(const study::Study& study) {
  return std::string(procedure::of(study).rate() ? "Insertion strokes at speeds that were asked for, forces"
                                                 : "Forces") +
         " judged in words, answers about the force in each situation, and rules given directly, for a force model "
         "of " +
         procedureOf(study) + ".";
}

}  // namespace

std::string PublishedStudy::name() const {
  return "Forces of " + procedureOf(study()) + " as experts feel them" +
         (simulated.empty() ? "" : " (with simulated data)") + (without_force.empty() ? "" : " (VIRTUAL)");
}

std::string PublishedStudy::description() const {
  return measuredIn(study()) + (simulated.empty() ? "" : " " + simulated) +
         (without_force.empty() ? "" : " " + without_force);
}

std::string PublishedStudy::readme(std::string_view layout) const {
  std::string text = name() + "\n\n";
  if (!simulated.empty()) text += simulated + "\n\n";
  if (!without_force.empty()) text += without_force + "\n\n";
  text += measuredIn(study()) + "\n\n" + std::string(layout) + "\n\n";
  text += std::string(kLeftOut) + "\n\n" + std::string(kToEnter) + "\n\nWritten by " + version + ".\n";
  return text;
}

PublishedStudy publishedStudy(const study::Study& study, std::uint64_t seed, std::string_view version,
                              std::vector<session::Trial> trials) {
  session::ShareableStudy shared = session::shareable(study, seed);
  auto shared_trials = session::shareable(std::move(trials), shared.codes);
  std::string without_force = session::virtualNote(shared.study);
  return {std::move(shared),        session::inputsOf(study), session::simulatedNote(study),
          std::move(without_force), std::string(version),     std::move(shared_trials)};
}

void FileSet::add(std::string_view below, std::string_view text) {
  if (!state_) return;
  const auto path = std::filesystem::path(folder_) / below;
  state_ = base::makeFolder(path.parent_path().string());
  if (!state_) return;
  std::ofstream file(path, std::ios::binary);
  file << text << std::flush;
  if (!file) state_ = refused(path.string(), "a file that can be written");
  ++files_;
}

base::Result<std::size_t> FileSet::finish() const {
  if (!state_) return tl::unexpected(state_.error());
  const base::Descriptor folder(::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder.isOpen() || ::syncfs(folder.number()) != 0) return refused(folder_, "a folder that can be written");
  return files_;
}

// A study in the layout of Psych-DS: CSV tables below `data`, one description of the data set with all columns.

/// How an earlier data set of this layout is recognized.
session::ExportKind psychDsExport();

/// Writes the files of the layout. `folder` is that of `files`. A table without rows is left out, except that of the
/// participants. Refuses what study::writeStudyFolder refuses.
base::Result<void> writePsychDs(const PublishedStudy& published, const std::string& folder, FileSet& files);

namespace {

namespace fs = std::filesystem;
using base::Result;

constexpr std::array<std::string_view, 5> kTables = {study::kParticipantsTable, study::kSpeedsTable,
                                                     study::kJudgementsTable, study::kAnswersTable, study::kRulesTable};

constexpr std::string_view kAbout = "dataset_description.json";
constexpr std::string_view kAboutFolder =
    "The layout is Psych-DS. The tables are below data; codebook.md and dataset_description.json say what each column "
    "holds. `tactus build` and `tactus study import` read this folder.";

bool isOfPsychDs(const fs::path& below) {
  const std::string path = below.generic_string();
  if (path == kAbout || path == "README.md" || path == "codebook.json" || path == "codebook.md") return true;
  if (path == study::publishedTable(session::kTrialsTable)) return true;
  return std::any_of(kTables.begin(), kTables.end(),
                     [&](std::string_view table) { return path == study::publishedTable(table); });
}

/// Columns of participants.csv that are always empty in what is shared.
bool isEmptied(std::string_view column) { return column == "years_experience" || column == "weight"; }

/// participants.csv without its emptied columns, with the bands of experience.
std::string participantsText(const base::CsvTable& table, const std::vector<std::string>& bands) {
  std::vector<std::size_t> kept;
  std::vector<std::string> names;
  for (std::size_t column = 0; column < table.columns().size(); ++column) {
    if (isEmptied(table.columns()[column])) continue;
    kept.push_back(column);
    names.push_back(table.columns()[column]);
  }
  names.emplace_back("years_experience_band");
  base::CsvWriter csv{std::span<const std::string>(names)};
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    for (const std::size_t column : kept) csv.cell(table.cell(row, column));
    csv.cell(std::string_view(bands[row])).endRow();
  }
  return csv.text();
}

/// The description as JSON-LD. Each column of any table is listed once; where tables mean different things by one name,
/// with both meanings.
std::string descriptionOf(const PublishedStudy& published, const session::Codebook& codebook) {
  std::vector<const store::RecordColumn*> columns;
  std::map<std::string_view, std::string> meanings;
  for (const auto& table : codebook.tables) {
    for (const auto& column : table.table->columns) {
      auto [it, is_new] = meanings.try_emplace(column.name, column.meaning);
      if (is_new) columns.push_back(&column);
      if (it->second.find(column.meaning) == std::string::npos) it->second += "; " + std::string(column.meaning);
    }
  }
  base::JsonWriter json;
  json.beginObject().key("@context").value("https://schema.org/").key("@type").value("Dataset");
  json.key("name").value(published.name()).key("description").value(published.description());
  json.key("variableMeasured").beginArray();
  for (const auto* column : columns) {
    json.beginObject(base::JsonWriter::Layout::kInline).key("@type").value("PropertyValue");
    json.key("name").value(column->name).key("description").value(meanings.at(column->name));
    if (!column->unit.empty()) json.key("unitText").value(column->unit);
    json.endObject();
  }
  return json.endArray().endObject().text();
}

}  // namespace

session::ExportKind psychDsExport() { return {"codebook.json", session::kCodebookFormat, isOfPsychDs}; }

Result<void> writePsychDs(const PublishedStudy& published, const std::string& folder, FileSet& files) {
  const std::string work = (fs::path(folder) / "tables").string();
  if (auto ok = study::writeStudyFolder(published.study(), published.inputs, work); !ok) return ok;
  auto described = session::viewTables(published.inputs, true);
  session::Codebook codebook;
  codebook.shareable = true;
  if (!published.simulated.empty()) codebook.notes.push_back(published.simulated);
  if (!published.without_force.empty()) codebook.notes.push_back(published.without_force);
  for (const std::string_view name : kTables) {
    TACTUS_TRY(const auto table, base::CsvTable::read((fs::path(work) / name).string()));
    const bool is_participants = name == study::kParticipantsTable;
    if (table.rowCount() == 0 && !is_participants) continue;
    const std::string path = study::publishedTable(name);
    TACTUS_TRY(const auto text, is_participants ? participantsText(table, published.shared.bands)
                                                : base::readFile(table.file(), std::size_t{1} << 31U));
    files.add(path, text);
    const auto it = std::find_if(described.begin(), described.end(), [&](const auto& one) { return one.file == name; });
    if (is_participants) std::erase_if(it->columns, [](const auto& column) { return isEmptied(column.name); });
    codebook.tables.push_back({path, &*it});
  }
  std::error_code error;
  fs::remove_all(work, error);
  const auto trials = session::trialsTable(true);
  if (!published.trials.empty()) {
    const std::string path = study::publishedTable(session::kTrialsTable);
    files.add(path, session::trialsText(published.trials, true));
    codebook.tables.push_back({path, &trials});
  }
  files.add(kAbout, descriptionOf(published, codebook));
  files.add("README.md", "# " + published.readme(kAboutFolder));
  files.add("codebook.json", session::asJson(codebook));
  files.add("codebook.md", session::asMarkdown(codebook));
  return {};
}

base::Result<DataSet> writeDataSet(const study::Study& study, Layout layout, const std::string& folder,
                                   std::uint64_t seed, std::string_view version, std::vector<session::Trial> trials) {
  if (study.participants.empty()) {
    return tl::unexpected(base::Error{base::ErrorCode::kData, study.name, {}, "no participant", "at least one"});
  }
  TACTUS_TRY(auto place,
             session::ExportFolder::beside(folder, layout == Layout::kBids ? bidsExport() : psychDsExport()));
  const auto removed = session::removeOurs(session::leftoversOfExport(folder));
  const PublishedStudy published = publishedStudy(study, seed, version, std::move(trials));
  FileSet files(place.path());
  DataSet done;
  done.participants = study.participants.size();
  if (layout == Layout::kBids) {
    done.notes = writeBids(published, files);
  } else if (auto ok = writePsychDs(published, place.path(), files); !ok) {
    return tl::unexpected(ok.error());
  }
  TACTUS_TRY(const auto written, files.finish());
  done.files = written;
  if (auto placed = place.place(); !placed) return tl::unexpected(placed.error());
  for (const auto& path : removed) done.notes.push_back(path + ": left by a crash; deleted");
  return done;
}

}  // namespace tactus::dataset
