#include "app/dataset/psych_ds.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

#include "app/session/study_export.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/base/tables/csv.h"
#include "core/study/csv_tables.h"
#include "core/study/table_line.h"

namespace tactus::dataset {
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
    const auto table = base::CsvTable::read((fs::path(work) / name).string());
    if (!table) return tl::unexpected(table.error());
    const bool is_participants = name == study::kParticipantsTable;
    if (table->rowCount() == 0 && !is_participants) continue;
    const std::string path = study::publishedTable(name);
    const auto text = is_participants ? participantsText(*table, published.shared.bands)
                                      : base::readFile(table->file(), std::size_t{1} << 31U);
    if (!text) return tl::unexpected(text.error());
    files.add(path, *text);
    const auto it = std::find_if(described.begin(), described.end(), [&](const auto& one) { return one.file == name; });
    if (is_participants) std::erase_if(it->columns, [](const auto& column) { return isEmptied(column.name); });
    codebook.tables.push_back({path, &*it});
  }
  std::error_code error;
  fs::remove_all(work, error);
  files.add(kAbout, descriptionOf(published, codebook));
  files.add("README.md", "# " + published.readme(kAboutFolder));
  files.add("codebook.json", session::asJson(codebook));
  files.add("codebook.md", session::asMarkdown(codebook));
  return {};
}

}  // namespace tactus::dataset
