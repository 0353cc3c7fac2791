#include "core/store/record_tables.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "core/base/check.h"
#include "core/base/files/checksums.h"
#include "core/base/files/file.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/store/migrations.h"
#include "core/store/query.h"
#include "core/store/record_checksum.h"
#include "core/store/recording_codec.h"

namespace tactus::store {
namespace {

namespace fs = std::filesystem;
using base::ErrorCode;
using base::Result;
using study::RecordId;

std::string channelList(const study::Recording& recording) {
  PairList pairs;
  for (const auto& channel : recording.channels) pairs.emplace_back(channel.name, channel.unit);
  return pairListText(pairs);
}

/// `depth_mm`, `speed_mm_s`: what people and programs can use as the name of a column, each once.
std::vector<std::string> sampleColumns(const study::Recording& recording) {
  std::vector<std::string> columns = {"sample"};
  std::set<std::string> taken = {"sample"};
  for (const auto& channel : recording.channels) {
    std::string column = base::lowered(channel.name + '_' + channel.unit);
    for (char& c : column) {
      const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
      if (!plain) c = '_';
    }
    if (!taken.insert(column).second) {
      column += "_channel_" + std::to_string(columns.size());
      taken.insert(column);
    }
    columns.push_back(column);
  }
  return columns;
}

std::string samplesText(const study::Recording& recording) {
  const auto columns = sampleColumns(recording);
  base::CsvWriter csv{std::span<const std::string>(columns)};
  for (std::size_t i = 0; i < recording.size(); ++i) {
    csv.cell(i);
    for (const auto& channel : recording.channels) csv.cell(channel.values[i]);
    csv.endRow();
  }
  return csv.text();
}

/// Writes one table after the other; throws as Query does.
class Writer {
 public:
  Writer(Connection& connection, const std::string& folder, ByteOrderMark mark)
      : connection_(connection), folder_(folder), mark_(mark) {}

  void write(const RecordTable& table) {
    std::vector<std::string> names;
    for (const auto& column : table.columns) names.emplace_back(column.name);
    base::CsvWriter csv{std::span<const std::string>(names)};
    Query query(connection_, selection(table));
    while (query.next()) {
      key_.reset();
      for (const auto& column : table.columns) csv.cell(std::string_view(cell(column, query)));
      query.requireIntact(table.name, *key_);
      csv.endRow();
    }
    writeTable(fs::path(table.file), csv.text());
  }

 private:
  std::string selection(const RecordTable& table) const {
    std::string sql;
    for (const auto& column : table.columns) {
      std::string what(column.name);
      if (column.kind == ColumnKind::kChannels) what = "data";
      if (column.kind == ColumnKind::kRecording) what = "NULL";  // the channels brought it along
      if (column.kind == ColumnKind::kModel) what = "sha256, text";
      if (column.name == "schema_version") what = std::to_string(schemaSteps().back().version);
      if (column.kind == ColumnKind::kBytes) what = "lower(hex(" + what + "))";
      sql += (sql.empty() ? "SELECT " : ", ") + what;
    }
    sql += ", " + fitsChecksum(connection_, table.name, table.name);
    return sql + " FROM " + std::string(table.name) + " ORDER BY " + std::string(table.order);
  }

  std::string cell(const RecordColumn& column, Query& query) {
    switch (column.kind) {
      case ColumnKind::kId: {
        const auto id = query.idOrNothing();
        if (!key_) key_ = id;
        return id ? study::toText(*id) : std::string();
      }
      case ColumnKind::kBytes:
      case ColumnKind::kText: return mark_ == ByteOrderMark::kWrite ? base::guarded(query.text()) : query.text();
      case ColumnKind::kJson: return query.text();
      case ColumnKind::kInteger:
      case ColumnKind::kFlag: {
        const auto integer = query.integerOrNothing();
        return integer ? std::to_string(*integer) : std::string();
      }
      case ColumnKind::kNumber: {
        const auto number = query.numberOrNothing();
        return number ? base::formatNumber(*number) : std::string();
      }
      case ColumnKind::kChannels: {
        auto recording = decodeRecording(query.text());
        if (!recording) {
          recording.error().place = "recording of stroke " + study::toText(*key_);
          throw Refusal{recording.error()};
        }
        recording_ = std::move(*recording);
        return channelList(recording_);
      }
      case ColumnKind::kRecording: {
        query.idOrNothing();
        const fs::path path = fs::path(kRecordingsFolder) / (study::toText(*key_) + ".csv");
        writeTable(path, samplesText(recording_));
        return path.generic_string();
      }
      case ColumnKind::kModel: {
        const std::string hash = query.text();
        const std::string text = query.text();
        if (base::sha256(text) != hash) {
          refuse(ErrorCode::kMismatch, "model version " + study::toText(*key_), "a text that does not fit its SHA-256",
                 "the text that was saved");
        }
        const fs::path path = fs::path(kModelsFolder) / (study::toText(*key_) + ".json");
        writeFile(path, text);
        return path.generic_string();
      }
    }
    return {};
  }

  void writeTable(const fs::path& path, const std::string& text) {
    writeFile(path, (mark_ == ByteOrderMark::kWrite ? std::string(kByteOrderMark) : std::string()) + text);
  }

  void writeFile(const fs::path& path, const std::string& text) {
    const fs::path whole = folder_ / path;
    if (auto made = base::makeFolder(whole.parent_path().string()); !made) throw Refusal{made.error()};
    if (auto written = base::writeFileAtomically(whole.string(), text); !written) throw Refusal{written.error()};
  }

  Connection& connection_;
  fs::path folder_;
  ByteOrderMark mark_;
  std::optional<RecordId> key_;  // of the row; its files are named after it
  study::Recording recording_;
};

}  // namespace

Result<void> writeRecords(const StudyFile& file, const std::string& folder, ByteOrderMark mark) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    Writer writer(connection, folder, mark);
    for (const auto& table : recordTables()) writer.write(table);
  });
}

namespace {

using Kind = ColumnKind;
using Columns = std::vector<RecordColumn>;

constexpr std::string_view kBySession =
    "(SELECT started_utc_ms FROM session WHERE session.id = session_id), session_id, sequence, id";

/// The columns that every kind of session record begins with, and then `more`.
Columns entryColumns(std::string_view table, const Columns& more) {
  Columns columns = {
      {"id", Kind::kId, "", "The record"},
      {"session_id", Kind::kId, "", "The session that it belongs to", "session"},
      {"sequence", Kind::kInteger, "", "Counts 1, 2, 3, … through the session over all kinds of record"},
      {"utc_ms", Kind::kInteger, "ms", "When, since 1970-01-01 UTC"},
      {"monotonic_ns", Kind::kInteger, "ns",
       "When, by a clock that never jumps; only differences within a session mean something"},
      {"entered_by", Kind::kText, "",
       "participant, researcher (for the participant) or program (a simulation or an import)"},
      {"supersedes", Kind::kId, "", "The record of this table that this one corrects, which no longer counts", table,
       true},
      {"reason", Kind::kText, "", "Reason of the correction", "", true},
  };
  columns.insert(columns.end(), more.begin(), more.end());
  return columns;
}

RecordTable entryTable(std::string_view name, std::string_view file, std::string_view meaning, const Columns& more) {
  return {name, file, meaning, kBySession, entryColumns(name, more)};
}

std::vector<RecordTable> makeTables() {
  std::vector<RecordTable> tables;
  tables.push_back({"study",
                    "study.csv",
                    "The study itself, one row",
                    "id",
                    {{"id", Kind::kId, "", "The study"},
                     {"name", Kind::kText, "", "Its name"},
                     {"created_utc_ms", Kind::kInteger, "ms", "When the study file was made, since 1970-01-01 UTC"},
                     {"program", Kind::kText, "", "Program and version that made the study file"},
                     {"schema_version", Kind::kInteger, "", "Version of the study file's tables"}}});
  tables.push_back(
      {"tombstone",
       "tombstones.csv",
       "A participant who withdrew; nothing else of them is left",
       "utc_ms, person_id",
       {{"person_id", Kind::kId, "", "The participant"},
        {"utc_ms", Kind::kInteger, "ms", "When they withdrew, since 1970-01-01 UTC"},
        {"code_salt", Kind::kBytes, "", "16 bytes of this participant alone", "", true, 2},
        {"code_hash", Kind::kBytes, "",
         "SHA-256 of these bytes and the participant's code, 32 bytes for each code they had; tells a code that comes "
         "back",
         "", true, 2}}});
  tables.push_back({"person",
                    "persons.csv",
                    "A participant",
                    "code, id",
                    {{"id", Kind::kId, "", "The participant"},
                     {"code", Kind::kText, "", "Random code, never a name"},
                     {"simulated", Kind::kFlag, "", "1 where a program made all data of this participant"}}});
  tables.push_back({"person_code",
                    "person_codes.csv",
                    "A later code of a participant, where two had the same; the latest counts",
                    "utc_ms, id",
                    {{"id", Kind::kId, "", "The change of code"},
                     {"person_id", Kind::kId, "", "The participant", "person"},
                     {"utc_ms", Kind::kInteger, "ms", "When, since 1970-01-01 UTC"},
                     {"code", Kind::kText, "", "Code, never a name"}},
                    2});
  tables.push_back({"protocol",
                    "protocols.csv",
                    "A version of the study's protocol: what each participant is asked",
                    "version, utc_ms, id",
                    {{"id", Kind::kId, "", "The record of the protocol"},
                     {"version", Kind::kInteger, "", "From 1; of the rows of one version the latest counts"},
                     {"utc_ms", Kind::kInteger, "ms", "When, since 1970-01-01 UTC"},
                     {"author", Kind::kText, "", "By whom", "", true},
                     {"reason", Kind::kText, "", "Reason of the change", "", true},
                     {"text", Kind::kJson, "", "Settings, languages, consent texts, device"}},
                    3});
  tables.push_back(
      {"depth_measurement",
       "depth_measurements.csv",
       "How the depths of the regions were measured on an image; the latest counts",
       "image_id IS NOT NULL, utc_ms, id",
       {{"id", Kind::kId, "", "The record of the measurement"},
        {"utc_ms", Kind::kInteger, "ms", "When, since 1970-01-01 UTC"},
        {"author", Kind::kText, "", "By whom", "", true},
        {"text", Kind::kJson, "", "Scale, way of the tube, boundaries, overlaps, anatomical scale"},
        {"image_id", Kind::kId, "", "The record that holds the image; empty: this one", "depth_measurement", true},
        {"image", Kind::kBytes, "", "The bytes of the image's file", "", true}},
       4});
  tables.push_back(
      {"session",
       "sessions.csv",
       "One visit of one participant",
       "started_utc_ms, id",
       {{"id", Kind::kId, "", "The session"},
        {"person_id", Kind::kId, "", "The participant", "person"},
        {"kind", Kind::kText, "", "elicitation, usability or import (tables that were read from files)"},
        {"started_utc_ms", Kind::kInteger, "ms",
         "Beginning, since 1970-01-01 UTC; in a session of the kind import, when it was imported"},
        {"started_monotonic_ns", Kind::kInteger, "ns", "Beginning, by a clock that never jumps"},
        {"consent_version", Kind::kText, "", "Version of the text that the participant agreed to", "", true},
        {"seed", Kind::kText, "", "Seed of every random order of the session, a whole number below 2^64"},
        {"language", Kind::kText, "", "Language of the forms", "", true},
        {"station", Kind::kText, "", "Place of recording", "", true},
        {"program", Kind::kText, "", "Program and version"},
        {"device", Kind::kText, "", "Haptic device and its serial number", "", true},
        {"device_friction_n", Kind::kNumber, "N", "The device's own friction against forward motion", "", true},
        {"settings", Kind::kJson, "", "Settings of the protocols", "", true},
        {"protocol_id", Kind::kId, "", "The record of the study's protocol that it follows", "protocol", true, 3}}});
  tables.push_back(
      entryTable("profile", "profiles.csv", "What a participant told of themselves",
                 {{"years_experience", Kind::kNumber, "years", "Experience", "", true},
                  {"insertions_per_month", Kind::kNumber, "1/month", "Tubes placed in a month", "", true},
                  {"category", Kind::kText, "", "For example beginner, intermediate, expert", "", true},
                  {"handedness", Kind::kText, "", "left, right or both", "", true},
                  {"gloves", Kind::kText, "", "Gloves that are usually worn", "", true},
                  {"tube_size", Kind::kText, "", "Usual size of the tube", "", true},
                  {"haptic_experience", Kind::kText, "", "Experience with haptic devices", "", true},
                  {"weight", Kind::kNumber, "", "Weight in the mean of the experts, given by the researcher", "", true},
                  {"comfort", Kind::kText, "", "How hand and arm felt before the session", "", true, 3}}));
  tables.push_back(entryTable("event", "events.csv", "A line of a session's log",
                              {{"kind", Kind::kText, "", "What happened, for example stage_entered, paused"},
                               {"detail", Kind::kJson, "", "More about it", "", true}}));
  tables.push_back(entryTable(
      "stroke", "strokes.csv",
      "An insertion movement of the speed experiment, or with the level feel a piece of a recording of feeling a model",
      {{"level", Kind::kText, "", "The speed that was asked for"},
       {"number", Kind::kInteger, "", "From 1 within the level and session; a repeated stroke keeps its number"},
       {"attempt", Kind::kInteger, "", "From 1"},
       {"practice", Kind::kFlag, "", "1 for practice"},
       {"verdict", Kind::kText, "", "accepted, or why the stroke is not used", "", true},
       {"first_sample", Kind::kInteger, "samples", "First sample of the forward movement in the recording, from 0"},
       {"end_sample", Kind::kInteger, "samples", "One past its last sample"}}));
  tables.push_back(
      {"recording",
       "recordings.csv",
       "What was recorded during a stroke; the samples stand in a table of their own",
       "place",
       {{"place", Kind::kInteger, "", "Counts the recordings of the study file"},
        {"stroke_id", Kind::kId, "", "The stroke", "stroke"},
        {"session_id", Kind::kId, "", "The session", "session"},
        {"sample_rate_hz", Kind::kNumber, "Hz", "Samples per second"},
        {"samples", Kind::kInteger, "samples", "Number of samples of each channel"},
        {"channels", Kind::kText, "", "The recorded channels with their units, for reading"},
        {"channel_list", Kind::kChannels, "",
         "The same as a list of [name, unit], in the order of the columns of the table of samples"},
        {"data", Kind::kRecording, "",
         "The table of samples: sample counts from 0, then a column for each channel, named after channel and unit"}}});
  tables.push_back(entryTable(
      "judgement", "judgements.csv", "A force stimulus and what was said of it",
      {{"series", Kind::kText, "", "ascending, descending or random"},
       {"step", Kind::kInteger, "", "Place in the series, from 1"},
       {"attempt", Kind::kInteger, "", "From 1; another where the step was repeated"},
       {"commanded_n", Kind::kNumber, "N", "Force of the stimulus"},
       {"felt_n", Kind::kNumber, "N", "Estimate of the force that was felt: the device's friction added", "", true},
       {"kind", Kind::kText, "", "term, not_felt, beyond_practice (larger than in real placements) or no_answer"},
       {"term", Kind::kText, "", "The answer, where the kind is term", "", true},
       {"scored", Kind::kFlag, "", "0 without forward motion, without the whole force, and for practice"},
       {"catch_trial", Kind::kFlag, "", "1 for a blank of 0 N or a hidden repeat"},
       {"feel_again", Kind::kInteger, "", "How often the participant asked to feel it again"},
       {"forward_mm", Kind::kNumber, "mm", "Way forward while judging"},
       {"forward_speed_mm_s", Kind::kNumber, "mm/s", "Mean speed on that way"},
       {"response_s", Kind::kNumber, "s", "From the full force to the answer"},
       {"delivered_share", Kind::kNumber, "",
        "Least share of the force that was in the hand from the full force on, 0 to 1; empty: not known", "", true,
        3}}));
  tables.push_back(entryTable(
      "answer", "answers.csv", "The answer to one item of a form",
      {{"form", Kind::kText, "", "Id of the form"},
       {"form_version", Kind::kInteger, "", "Its version"},
       {"item", Kind::kInteger, "", "The form's number of the item"},
       {"position", Kind::kInteger, "", "Place in the order in which the items were shown, from 1"},
       {"status", Kind::kText, "", "answered, skipped, cant_tell or cleared (answered, then taken back)"},
       {"value", Kind::kText, "", "Id of a term, or a number on a rating scale; empty unless answered", "", true},
       {"response_s", Kind::kNumber, "s", "From showing the item to the answer"},
       {"wording", Kind::kText, "", "Id of the words in which the item was asked: plain, published; empty: not known",
        "", true, 5}}));
  tables.push_back(entryTable("rating", "ratings.csv", "How a participant felt after a block",
                              {{"block", Kind::kText, "", "speed, force, questionnaire, …"},
                               {"effort", Kind::kInteger, "", "1 (none) to 7 (very much)"},
                               {"comfort", Kind::kInteger, "", "1 (very uncomfortable) to 7 (very comfortable)"}}));
  tables.push_back(entryTable("rule", "rules.csv", "A rule given directly instead of through answers",
                              {{"form", Kind::kText, "", "Form or reading whose depth terms the rule uses", "", true},
                               {"conditions", Kind::kJson, "", "List of [input, term]"},
                               {"then_term", Kind::kText, "", "Term of the force"},
                               {"weight", Kind::kNumber, "", "Weight of the rule"}}));
  tables.push_back({"model_version",
                    "model_versions.csv",
                    "A state of a force model",
                    "place",
                    {{"place", Kind::kInteger, "", "Counts the versions of the study file"},
                     {"id", Kind::kId, "", "The version"},
                     {"sequence", Kind::kInteger, "", "Orders the versions"},
                     {"parent", Kind::kId, "", "The version that this one was made from", "model_version", true},
                     {"utc_ms", Kind::kInteger, "ms", "When, since 1970-01-01 UTC"},
                     {"author", Kind::kText, "", "By whom", "", true},
                     {"label", Kind::kText, "", "What for", "", true},
                     {"sha256", Kind::kText, "", "SHA-256 of the model's file, hexadecimal"},
                     {"text", Kind::kModel, "", "The model's file"},
                     {"cleaned_utc_ms", Kind::kInteger, "ms",
                      "When a withdrawal took a participant out of it, since 1970-01-01 UTC; empty: as it was stored",
                      "", true, 2}}});
  tables.push_back({"import_log",
                    "import_log.csv",
                    "What was read into the study file",
                    "utc_ms, id",
                    {{"id", Kind::kId, "", "The import"},
                     {"utc_ms", Kind::kInteger, "ms", "When, since 1970-01-01 UTC"},
                     {"kind", Kind::kText, "", "merge (another study file or a full export) or tables"},
                     {"source", Kind::kText, "", "Name of what was read, without its folder"},
                     {"detail", Kind::kJson, "", "Rows that were new, by table", "", true},
                     {"sha256", Kind::kText, "", "SHA-256 of what was read, hexadecimal", "", true, 2}}});
  tables.push_back({"incident",
                    "incidents.csv",
                    "Records that were lost or may have been",
                    "utc_ms, id",
                    {{"id", Kind::kId, "", "The incident"},
                     {"utc_ms", Kind::kInteger, "ms", "When it was noticed, since 1970-01-01 UTC"},
                     {"kind", Kind::kText, "", "For example journal_missing, journal_cut, journal_damaged"},
                     {"detail", Kind::kText, "", "What is known about it", "", true}},
                    2});
  return tables;
}

}  // namespace

std::string_view name(ColumnKind kind) {
  switch (kind) {
    case ColumnKind::kId: return "id";
    case ColumnKind::kBytes: return "hexadecimal bytes";
    case ColumnKind::kText: return "text";
    case ColumnKind::kJson:
    case ColumnKind::kChannels: return "JSON text";
    case ColumnKind::kInteger: return "integer";
    case ColumnKind::kFlag: return "0 or 1";
    case ColumnKind::kNumber: return "number";
    case ColumnKind::kRecording:
    case ColumnKind::kModel: return "file name";
  }
  return {};
}

std::span<const RecordTable> recordTables() {
  static const std::vector<RecordTable> tables = makeTables();
  return tables;
}

const RecordColumn& keyOf(const RecordTable& table) {
  const auto key = std::find_if(table.columns.begin(), table.columns.end(),
                                [](const RecordColumn& column) { return column.kind == ColumnKind::kId; });
  TACTUS_CHECK(key != table.columns.end());
  return *key;
}

}  // namespace tactus::store
