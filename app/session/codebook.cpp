#include "app/session/codebook.h"

#include "core/base/json/json_writer.h"
#include "core/study/table_line.h"

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
                                    "Experience: <5, 5-10 (below 10), 10-15 (15 too) or >15", "", true});
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

}  // namespace tactus::session
