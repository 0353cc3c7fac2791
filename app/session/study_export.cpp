#include "app/session/study_export.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/session/codebook.h"
#include "app/session/export_folder.h"
#include "app/session/leftovers.h"
#include "app/session/shareable.h"
#include "app/session/study_view.h"
#include "core/base/files/file.h"
#include "core/base/tables/csv.h"
#include "core/study/csv_tables.h"

namespace tactus::session {
namespace {

namespace fs = std::filesystem;
using base::Result;

constexpr const char* kGuarded =
    "For spreadsheet programs: text that begins with = + - @, a tab or a carriage return has an apostrophe in front, "
    "so "
    "that none of it is run as a formula; `tactus study import` and `tactus build` take it away again.";
constexpr const char* kNotGuarded =
    "Text is exported as entered. A spreadsheet program may run text that begins with = + - @ as a formula: for such "
    "a "
    "program export with `--bom`, which puts an apostrophe in front.";

/// Adds the column of the bands of experience to the table of participants.
Result<void> addBands(const std::string& path, const std::vector<std::string>& bands) {
  const auto table = base::CsvTable::read(path);
  if (!table) return tl::unexpected(table.error());
  auto columns = table->columns();
  columns.emplace_back("years_experience_band");
  base::CsvWriter csv{std::span<const std::string>(columns)};
  for (std::size_t row = 0; row < table->rowCount(); ++row) {
    for (std::size_t column = 0; column < table->columns().size(); ++column) csv.cell(table->cell(row, column));
    csv.cell(std::string_view(bands[row])).endRow();
  }
  return base::writeFileAtomically(path, csv.text());
}

/// Makes the table one for spreadsheet programs: with a byte order mark, and guards before what looks like a formula.
Result<void> addMark(const std::string& path, const store::RecordTable& description) {
  const auto table = base::CsvTable::read(path);
  if (!table) return tl::unexpected(table.error());
  const auto is_text = [&](const std::string& name) {
    return std::any_of(description.columns.begin(), description.columns.end(), [&](const store::RecordColumn& column) {
      return column.name == name && column.kind == store::ColumnKind::kText;
    });
  };
  std::vector<bool> texts;
  for (const auto& name : table->columns()) texts.push_back(is_text(name));
  base::CsvWriter csv{std::span<const std::string>(table->columns())};
  for (std::size_t row = 0; row < table->rowCount(); ++row) {
    for (std::size_t column = 0; column < texts.size(); ++column) {
      const auto cell = table->cell(row, column);
      csv.cell(std::string_view(texts[column] ? base::guarded(cell) : std::string(cell)));
    }
    csv.endRow();
  }
  return base::writeFileAtomically(path, std::string(store::kByteOrderMark) + csv.text());
}

class Exporter {
 public:
  Exporter(const store::StudyFile& file, std::string folder, const ExportOptions& options)
      : file_(file), folder_(std::move(folder)), options_(options) {}

  Result<StudyExport> write() {
    codebook_.shareable = options_.shareable;
    auto view = studyForElicitation(file_);
    if (view) {
      if (auto ok = writeView(*view); !ok) return tl::unexpected(ok.error());
    } else if (options_.shareable) {
      return base::inFile(view.error(), file_.path());
    } else {
      done_.notes.push_back("The five tables for elicitation are left out: " + view.error().message() + '.');
    }
    if (auto ok = options_.shareable ? noteWhatIsMissing() : writeRecords(); !ok) return tl::unexpected(ok.error());
    codebook_.notes.emplace_back(options_.mark == store::ByteOrderMark::kWrite ? kGuarded : kNotGuarded);
    for (const auto& [name, text] :
         {std::pair("codebook.json", asJson(codebook_)), std::pair("codebook.md", asMarkdown(codebook_))}) {
      if (auto ok = base::writeFileAtomically(path(name), text); !ok) return tl::unexpected(ok.error());
    }
    return std::move(done_);
  }

 private:
  std::string path(std::string_view name) const { return (fs::path(folder_) / name).string(); }

  Result<void> writeView(StudyView& view) {
    done_.notes = std::move(view.notes);
    done_.participants = view.study.participants.size();
    if (auto note = simulatedNote(view.study); !note.empty()) codebook_.notes.push_back(std::move(note));
    std::vector<std::string> bands;
    if (options_.shareable) {
      auto anonymous = shareable(view.study, options_.seed);
      view.study = std::move(anonymous.study);
      bands = std::move(anonymous.bands);
    }
    if (auto note = virtualNote(view.study); !note.empty()) codebook_.notes.push_back(std::move(note));
    inputs_ = inputsOf(view.study);
    if (auto ok = study::writeStudyFolder(view.study, inputs_, folder_); !ok) return ok;
    if (options_.shareable) {
      if (auto ok = addBands(path(study::kParticipantsTable), bands); !ok) return ok;
    }
    view_tables_ = viewTables(inputs_, options_.shareable);
    for (const auto& table : view_tables_) {
      codebook_.tables.push_back({std::string(table.file), &table});
      if (options_.mark == store::ByteOrderMark::kNone) continue;
      if (auto ok = addMark(path(table.file), table); !ok) return ok;
    }
    codebook_.notes.emplace_back(
        "The tables at the top hold what counts now: no corrected records, no practice, no strokes that were not "
        "accepted, no judgements that are not scored; of a block that was done again, the session that counts (the "
        "latest complete one).");
    return {};
  }

  Result<void> noteWhatIsMissing() {
    for (const char* note :
         {"For sharing: without codes, dates and times of day, place, device, notes, log and records.",
          "The participants have new codes in a random order.",
          "Years of experience are given as bands; weights, and categories and hands in other than the usual words, "
          "are "
          "left out."}) {
      codebook_.notes.emplace_back(note);
    }
    return {};
  }

  Result<void> writeRecords() {
    codebook_.notes.emplace_back(
        "The tables below `records` hold everything that was recorded, corrected records too; `tactus study import` "
        "makes the same study of them.");
    codebook_.notes.emplace_back(
        "`sequence` counts all records of a session; a missing number would be a lost record.");
    for (const auto& table : store::recordTables()) {
      codebook_.tables.push_back({"records/" + std::string(table.file), &table});
    }
    return store::writeRecords(file_, path("records"), options_.mark);
  }

  const store::StudyFile& file_;
  std::string folder_;
  const ExportOptions& options_;
  Codebook codebook_;
  std::vector<std::string> inputs_;
  std::vector<store::RecordTable> view_tables_;
  StudyExport done_;
};

}  // namespace

Result<StudyExport> exportStudy(const store::StudyFile& file, const std::string& folder, const ExportOptions& options) {
  auto place = ExportFolder::beside(folder);
  if (!place) return tl::unexpected(place.error());
  std::vector<std::string> removed = removeOurs(leftoversOfStudy(file.path()));
  for (auto& path : removeOurs(leftoversOfExport(folder))) removed.push_back(std::move(path));
  auto done = Exporter(file, place->path(), options).write();
  if (!done) return done;
  if (auto placed = place->place(); !placed) return tl::unexpected(placed.error());
  for (const auto& path : removed) done->notes.push_back(path + ": left by a crash; deleted");
  return done;
}

}  // namespace tactus::session
