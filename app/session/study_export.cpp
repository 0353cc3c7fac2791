#include "app/session/study_export.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/session/export_folder.h"
#include "app/session/shareable.h"
#include "app/session/study_source.h"
#include "app/session/study_view.h"
#include "app/session/trials.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/json/json_writer.h"
#include "core/base/tables/csv.h"
#include "core/procedure/procedure.h"
#include "core/study/csv_tables.h"
#include "core/study/table_line.h"
#include "elicitation/force/word_intervals.h"

namespace tactus::session {
namespace {

using store::ColumnKind;
using store::RecordColumn;
using store::RecordTable;

constexpr std::string_view kTitleOfAll = "Full export of a study";
constexpr std::string_view kTitleOfShareable = "Export of a study for sharing";

const RecordColumn kParticipant{"participant", ColumnKind::kText, "", "Code of the participant"};

/// `text` as a cell of a Markdown table.
std::string inCell(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '|') out += '\\';
    out += c;
  }
  return out;
}

std::string row(const RecordColumn& column) {
  std::string meaning = inCell(column.meaning);
  if (!column.refers_to.empty()) meaning += " (an id of `" + std::string(column.refers_to) + "`)";
  if (column.optional) meaning += "; may be empty";
  return "| `" + inCell(column.name) + "` | " + std::string(name(column.kind)) + " | " + std::string(column.unit) +
         " | " + meaning + " |\n";
}

}  // namespace

std::vector<RecordTable> viewTables(const std::vector<std::string>& input_ids, bool shareable) {
  RecordTable participants{
      study::kParticipantsTable,
      study::kParticipantsTable,
      "A participant",
      "",
      {kParticipant,
       {"years_experience", ColumnKind::kNumber, "years", "Experience", "", true},
       {"category", ColumnKind::kText, "", "For example beginner, intermediate, expert", "", true},
       {"handedness", ColumnKind::kText, "", "left, right or both", "", true},
       {"weight", ColumnKind::kNumber, "", "Weight in the mean of the experts", "", true},
       {"simulated", ColumnKind::kFlag, "", "1 where a program made all data of this participant"}}};
  if (shareable) {
    participants.columns.push_back({"years_experience_band", ColumnKind::kText, "years",
                                    "Experience: <5, 5-9 (below 10), 10-14 (below 15) or 15+", "", true});
  }
  RecordTable rules{
      study::kRulesTable,
      study::kRulesTable,
      "A rule given directly instead of through answers",
      "",
      {kParticipant, {"form", ColumnKind::kText, "", "Form or reading whose depth terms the rule uses", "", true}}};
  for (const auto& input : input_ids) {
    rules.columns.push_back({input, ColumnKind::kText, "",
                             "Term of this input in the rule's conditions; empty without a condition", "", true});
  }
  rules.columns.push_back({"then", ColumnKind::kText, "", "Term of the force"});
  rules.columns.push_back({"weight", ColumnKind::kNumber, "", "Weight of the rule"});
  return {std::move(participants),
          {study::kSpeedsTable,
           study::kSpeedsTable,
           "A sample of an accepted stroke",
           "",
           {kParticipant,
            {"level", ColumnKind::kText, "", "The speed that was asked for"},
            {"stroke", ColumnKind::kInteger, "", "Number of the stroke within participant and level, from 1"},
            {"time_s", ColumnKind::kNumber, "s", "From the start of the stroke"},
            {"depth_mm", ColumnKind::kNumber, "mm", "Depth"},
            {"speed_mm_s", ColumnKind::kNumber, "mm/s", "Speed, from the positions"}}},
          {study::kJudgementsTable,
           study::kJudgementsTable,
           "A force that a participant judged",
           "",
           {kParticipant,
            {"series", ColumnKind::kText, "", "ascending, descending or random"},
            {"step", ColumnKind::kInteger, "", "Place in the series, from 1"},
            {"force_n", ColumnKind::kNumber, "N", "Commanded force"},
            {"term", ColumnKind::kText, "", "Term, not_felt, beyond_practice, empty: no answer", "", true}}},
          {study::kAnswersTable,
           study::kAnswersTable,
           "The last answer to an item of a form",
           "",
           {kParticipant,
            {"form", ColumnKind::kText, "", "Id of the form"},
            {"item", ColumnKind::kInteger, "", "The form's number of the item"},
            {"term", ColumnKind::kText, "", "The answer; empty unless answered", "", true},
            {"status", ColumnKind::kText, "", "answered, skipped, cant_tell or cleared"}}},
          std::move(rules)};
}

namespace {

constexpr std::string_view kSeriesOfWords = "ascending";  // the series that votes unless another one is chosen

RecordTable wordIntervalsTable() {
  return {kWordIntervalsTable,
          kWordIntervalsTable,
          "A word that a participant used for a force of the ascending series",
          "",
          {{"person", ColumnKind::kText, "", "Code of the participant"},
           {"word", ColumnKind::kText, "", "Term of the force"},
           {"left_n", ColumnKind::kNumber, "N", "Lowest force called so"},
           {"right_n", ColumnKind::kNumber, "N", "Highest force called so"}}};
}

std::string wordIntervalsText(const study::Study& study) {
  const auto& words = procedure::of(study).output.terms;
  base::CsvWriter csv({"person", "word", "left_n", "right_n"});
  for (const auto& one : elicitation::wordIntervals(study.judgements, kSeriesOfWords, words))
    csv.cell(one.participant).cell(words[one.word].id).cell(one.left_n).cell(one.right_n).endRow();
  return csv.text();
}

RecordTable stopForcesTable() {
  return {kStopForcesTable,
          kStopForcesTable,
          "A judged force, and whether the participant would stop at it",
          "",
          {kParticipant,
           {"series", ColumnKind::kText, "", "ascending, descending or random"},
           {"step", ColumnKind::kInteger, "", "Place in the series, from 1"},
           {"force_n", ColumnKind::kNumber, "N", "Commanded force"},
           {"would_stop", ColumnKind::kFlag, "", "1 where the participant would not push on"}}};
}

/// In the order of the new codes: P10 comes after P9.
std::vector<experiments::StopAnswer> withNewCodes(std::vector<experiments::StopAnswer> stops,
                                                  const std::map<std::string, std::string>& codes) {
  std::erase_if(stops, [&](const auto& stop) { return !codes.contains(stop.participant); });
  for (auto& stop : stops) stop.participant = codes.at(stop.participant);
  std::stable_sort(stops.begin(), stops.end(), [](const auto& a, const auto& b) {
    return std::pair(a.participant.size(), a.participant) < std::pair(b.participant.size(), b.participant);
  });
  return stops;
}

std::string stopForcesText(const std::vector<experiments::StopAnswer>& answers) {
  base::CsvWriter csv({"participant", "series", "step", "force_n", "would_stop"});
  for (const auto& one : answers)
    csv.cell(one.participant).cell(one.series).cell(one.step).cell(one.force_n).cell(one.would_stop ? 1 : 0).endRow();
  return csv.text();
}

}  // namespace

std::string asJson(const Codebook& codebook) {
  using Layout = base::JsonWriter::Layout;
  base::JsonWriter json;
  json.beginObject().key("format").value(kCodebookFormat).key("version").value(1);
  json.key("profile").value(codebook.shareable ? "shareable" : "full").key("notes").beginArray();
  for (const auto& note : codebook.notes) json.value(note);
  json.endArray().key("tables").beginArray();
  for (const auto& [file, table] : codebook.tables) {
    json.beginObject().key("file").value(file).key("row").value(table->meaning).key("columns").beginArray();
    for (const auto& column : table->columns) {
      json.beginObject(Layout::kInline).key("name").value(column.name).key("kind").value(name(column.kind));
      json.key("unit");
      column.unit.empty() ? json.null() : json.value(column.unit);
      json.key("meaning").value(column.meaning).key("may_be_empty").value(column.optional);
      if (!column.refers_to.empty()) json.key("refers_to").value(column.refers_to);
      json.endObject();
    }
    json.endArray().endObject();
  }
  json.endArray().endObject();
  return json.text();
}

std::string asMarkdown(const Codebook& codebook) {
  std::string text = "# " + std::string(codebook.shareable ? kTitleOfShareable : kTitleOfAll) + "\n\n";
  for (const auto& note : codebook.notes) text += "- " + note + '\n';
  for (const auto& [file, table] : codebook.tables) {
    text += "\n## " + file + "\n\nA row: " + std::string(table->meaning) +
            ".\n\n| column | kind | unit | meaning |\n|---|---|---|---|\n";
    for (const auto& column : table->columns) text += row(column);
  }
  return text;
}

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
  TACTUS_TRY(const auto table, base::CsvTable::read(path));
  auto columns = table.columns();
  columns.emplace_back("years_experience_band");
  base::CsvWriter csv{std::span<const std::string>(columns)};
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    for (std::size_t column = 0; column < table.columns().size(); ++column) csv.cell(table.cell(row, column));
    csv.cell(std::string_view(bands[row])).endRow();
  }
  return base::writeFileAtomically(path, csv.text());
}

/// Makes the table one for spreadsheet programs: with a byte order mark, and guards before what looks like a formula.
Result<void> addMark(const std::string& path, const store::RecordTable& description) {
  TACTUS_TRY(const auto table, base::CsvTable::read(path));
  const auto is_text = [&](const std::string& name) {
    return std::any_of(description.columns.begin(), description.columns.end(), [&](const store::RecordColumn& column) {
      return column.name == name && column.kind == store::ColumnKind::kText;
    });
  };
  std::vector<bool> texts;
  for (const auto& name : table.columns()) texts.push_back(is_text(name));
  base::CsvWriter csv{std::span<const std::string>(table.columns())};
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    for (std::size_t column = 0; column < texts.size(); ++column) {
      const auto cell = table.cell(row, column);
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
    TACTUS_TRY(auto all_trials, trials(file_, view));
    TACTUS_TRY(auto stops, stopAnswers(file_, view));
    std::vector<std::string> bands;
    if (options_.shareable) {
      auto anonymous = shareable(view.study, options_.seed);
      all_trials = shareable(std::move(all_trials), anonymous.codes);
      stops = withNewCodes(std::move(stops), anonymous.codes);
      view.study = std::move(anonymous.study);
      bands = std::move(anonymous.bands);
    }
    if (auto note = virtualNote(view.study); !note.empty()) codebook_.notes.push_back(std::move(note));
    inputs_ = inputsOf(view.study);
    if (auto ok = study::writeStudyFolder(view.study, inputs_, folder_); !ok) return ok;
    if (auto ok = writePack(view.study, folder_); !ok) return ok;
    if (options_.shareable) {
      if (auto ok = addBands(path(study::kParticipantsTable), bands); !ok) return ok;
    }
    if (auto ok = base::writeFileAtomically(path(kTrialsTable), trialsText(all_trials, options_.shareable)); !ok)
      return ok;
    if (auto ok = base::writeFileAtomically(path(kWordIntervalsTable), wordIntervalsText(view.study)); !ok) return ok;
    view_tables_ = viewTables(inputs_, options_.shareable);
    view_tables_.push_back(trialsTable(options_.shareable));
    view_tables_.push_back(wordIntervalsTable());
    if (procedure::of(view.study).stop_question) {
      if (auto ok = base::writeFileAtomically(path(kStopForcesTable), stopForcesText(stops)); !ok) return ok;
      view_tables_.push_back(stopForcesTable());
    }
    for (const auto& table : view_tables_) {
      codebook_.tables.push_back({std::string(table.file), &table});
      if (options_.mark == store::ByteOrderMark::kNone) continue;
      if (auto ok = addMark(path(table.file), table); !ok) return ok;
    }
    codebook_.notes.emplace_back(
        "The tables at the top hold what counts now: no corrected records, no practice, no strokes that were not "
        "accepted, no judgements that are not scored; of a block that was done again, the session that counts (the "
        "latest complete one).");
    codebook_.notes.emplace_back(
        "trials.csv holds in one table what every participant did, practice and repeats too, with what it was done "
        "under; `counts` tells what the other tables hold.");
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
  TACTUS_TRY(auto place, ExportFolder::beside(folder));
  std::vector<std::string> removed = removeOurs(leftoversOfStudy(file.path()));
  for (auto& path : removeOurs(leftoversOfExport(folder))) removed.push_back(std::move(path));
  auto done = Exporter(file, place.path(), options).write();
  if (!done) return done;
  if (auto placed = place.place(); !placed) return tl::unexpected(placed.error());
  for (const auto& path : removed) done->notes.push_back(path + ": left by a crash; deleted");
  return done;
}

}  // namespace tactus::session
