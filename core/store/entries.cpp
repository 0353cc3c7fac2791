#include "core/store/entries.h"

#include <string>
#include <type_traits>
#include <utility>

#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/store/query.h"
#include "core/store/record_checksum.h"
#include "core/store/recording_codec.h"
#include "core/store/words.h"

namespace tactus::store {
namespace {

using base::ErrorCode;

std::string conditionsText(const std::vector<study::ItemCondition>& conditions) {
  PairList pairs;
  for (const auto& condition : conditions) pairs.emplace_back(condition.input, condition.term);
  return pairListText(pairs);
}

std::vector<study::ItemCondition> parseConditions(const std::string& text) {
  auto pairs = pairListIn(text);
  if (!pairs) refuse(ErrorCode::kSchema, "rule", base::quoted(text), "a list of [input, term]");
  std::vector<study::ItemCondition> conditions;
  for (auto& [input, term] : *pairs) conditions.push_back({std::move(input), std::move(term)});
  return conditions;
}

/// `name`, an id of a term, level, series or form.
const std::string& plainName(const std::string& name, const char* place) {
  if (base::looksLikeFormula(name)) refuse(ErrorCode::kValue, place, base::quoted(name), base::kNoFormula);
  return name;
}

}  // namespace

void putColumns(Query& query, const study::ProfileRecord& record) {
  query.put(record.years_experience).put(record.insertions_per_month).put(record.category).put(record.handedness);
  query.put(record.gloves).put(record.tube_size).put(record.haptic_experience).put(record.weight);
  query.put(record.comfort);
}
void takeColumns(Query& query, study::ProfileRecord& record) {
  record.years_experience = query.numberOrNothing();
  record.insertions_per_month = query.numberOrNothing();
  record.category = query.text();
  record.handedness = query.text();
  record.gloves = query.text();
  record.tube_size = query.text();
  record.haptic_experience = query.text();
  record.weight = query.numberOrNothing();
  record.comfort = query.text();
}

void putColumns(Query& query, const study::EventRecord& record) { query.put(record.kind).putJson(record.detail); }
void takeColumns(Query& query, study::EventRecord& record) {
  record.kind = query.text();
  record.detail = query.text();
}

void putColumns(Query& query, const study::StrokeRecord& record) {
  if (record.last > record.recording.size()) {
    refuse(ErrorCode::kValue, "stroke", "an end at sample " + std::to_string(record.last),
           "one within the " + std::to_string(record.recording.size()) + " samples of its recording");
  }
  query.put(plainName(record.level, "level"))
      .put(record.number)
      .put(record.attempt)
      .put(record.practice)
      .put(record.verdict);
  query.put(static_cast<std::int64_t>(record.first)).put(static_cast<std::int64_t>(record.last));
}
void takeColumns(Query& query, study::StrokeRecord& record) {
  record.level = query.text();
  record.number = query.small();
  record.attempt = query.small();
  record.practice = query.flag();
  record.verdict = query.text();
  record.first = static_cast<std::size_t>(query.integer());
  record.last = static_cast<std::size_t>(query.integer());
}

void putColumns(Query& query, const study::JudgementRecord& record) {
  query.put(plainName(record.series, "series"))
      .put(record.step)
      .put(record.attempt)
      .put(record.commanded_n)
      .put(record.felt_n);
  query.put(wordFor(record.kind))
      .put(plainName(record.term, "term"))
      .put(record.scored)
      .put(record.catch_trial)
      .put(record.feel_again);
  query.put(record.forward_mm).put(record.forward_speed_mm_s).put(record.response_s).put(record.delivered_share);
}
void takeColumns(Query& query, study::JudgementRecord& record) {
  record.series = query.text();
  record.step = query.small();
  record.attempt = query.small();
  record.commanded_n = query.number();
  record.felt_n = query.numberOrNothing();
  record.kind = fromWord<study::ForceJudgement::Kind>(query.text());
  record.term = query.text();
  record.scored = query.flag();
  record.catch_trial = query.flag();
  record.feel_again = query.small();
  record.forward_mm = query.number();
  record.forward_speed_mm_s = query.number();
  record.response_s = query.number();
  record.delivered_share = query.numberOrNothing();
}

void putColumns(Query& query, const study::AnswerRecord& record) {
  query.put(plainName(record.form, "form")).put(record.form_version).put(record.item).put(record.position);
  const bool is_number = base::parseNumber(record.value).has_value();  // on a rating scale
  query.put(wordFor(record.status)).put(is_number ? record.value : plainName(record.value, "answer"));
  query.put(record.response_s).put(plainName(record.wording, "wording"));
}
void takeColumns(Query& query, study::AnswerRecord& record) {
  record.form = query.text();
  record.form_version = query.small();
  record.item = query.small();
  record.position = query.small();
  record.status = fromWord<study::Answer::Status>(query.text());
  record.value = query.text();
  record.response_s = query.number();
  record.wording = query.text();
}

void putColumns(Query& query, const study::RatingRecord& record) {
  query.put(record.block).put(record.effort).put(record.comfort);
}
void takeColumns(Query& query, study::RatingRecord& record) {
  record.block = query.text();
  record.effort = query.small();
  record.comfort = query.small();
}

void putColumns(Query& query, const study::RuleRecord& record) {
  for (const auto& condition : record.rule.conditions) plainName(condition.term, "rule");
  query.put(plainName(record.rule.form, "rule")).put(conditionsText(record.rule.conditions));
  query.put(plainName(record.rule.then, "rule")).put(record.rule.weight);
}
void takeColumns(Query& query, study::RuleRecord& record) {
  record.rule.form = query.text();
  record.rule.conditions = parseConditions(query.text());
  record.rule.then = query.text();
  record.rule.weight = query.number();
}

namespace {

using base::ErrorCode;
using base::Result;
using study::Entry;
using study::RecordId;

constexpr std::string_view kEntryColumns =
    "id, session_id, sequence, utc_ms, monotonic_ns, entered_by, supersedes, reason";

/// The number that the next record of the session gets, over all kinds.
std::int64_t nextSequence(Connection& connection, const RecordId& session) {
  std::string sql = "SELECT coalesce(max(highest), 0) + 1 FROM (";
  for (std::size_t i = 0; i < kEntryTables.size(); ++i) {
    if (i > 0) sql += " UNION ALL ";
    sql += "SELECT max(sequence) AS highest FROM " + std::string(kEntryTables[i]) + " WHERE session_id = ?1";
  }
  KeptQuery query(connection, sql + ")");
  query.put(session).next();
  return query.integer();
}

/// A record has one correction at most: the next one corrects the correction.
void requireUncorrected(Connection& connection, std::string_view table, const RecordId& superseded) {
  Query query(connection, "SELECT 1 FROM " + std::string(table) + " WHERE supersedes = ?");
  if (query.put(superseded).next()) {
    refuse(ErrorCode::kReference, std::string(table), "a correction of a record that was corrected before",
           "a correction of its latest correction");
  }
}

template <class Record>
void insertEntry(Connection& connection, const Record& record) {
  constexpr EntryTable kTable = kEntryTable<Record>;
  const Entry& entry = record.entry;
  if (entry.supersedes) requireUncorrected(connection, kTable.name, *entry.supersedes);
  KeptQuery insert(connection, insertion(connection, kTable.name));
  insert.put(entry.id).put(entry.session).put(nextSequence(connection, entry.session));
  insert.put(entry.when.utc_ms).put(entry.when.monotonic_ns).put(wordFor(entry.entered_by));
  insert.put(entry.supersedes).put(entry.reason);
  putColumns(insert, record);
  insert.run();
}

void insertRecording(Connection& connection, const study::StrokeRecord& record) {
  auto bytes = encodeRecording(record.recording);
  if (!bytes) throw Refusal{bytes.error()};
  std::string channels;
  for (const auto& channel : record.recording.channels) {
    channels += (channels.empty() ? "" : ", ") + channel.name + " " + channel.unit;
  }
  KeptQuery insert(connection, insertion(connection, "recording",
                                         {{"place", "(SELECT coalesce(max(place), 0) + 1 FROM recording)"}}));
  insert.put(record.entry.id).put(record.entry.session).put(record.recording.sample_rate_hz);
  insert.put(static_cast<std::int64_t>(record.recording.size())).put(channels).putBlob(*bytes).run();
}

template <class Record>
Result<void> appendEntry(StudyFile& file, const Record& record) {
  Connection& connection = file.connection();
  return inTransaction(connection, [&] {
    insertEntry(connection, record);
    if constexpr (std::is_same_v<Record, study::StrokeRecord>) insertRecording(connection, record);
  });
}

study::Recording takeRecording(Query& query, const RecordId& stroke) {
  auto recording = decodeRecording(query.text());
  if (!recording) throw Refusal{recording.error()};
  query.requireIntact("recording of stroke", stroke);
  return *std::move(recording);
}

template <class Record>
Result<std::vector<Record>> readEntries(const StudyFile& file, const Selection& selection,
                                        Recordings recordings = Recordings::kLeaveOut) {
  constexpr EntryTable kTable = kEntryTable<Record>;
  constexpr bool kIsStroke = std::is_same_v<Record, study::StrokeRecord>;
  const bool with_recording = kIsStroke && recordings == Recordings::kRead;
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    // The columns of a record are unambiguous but for the id, the kind and what a session has too.
    std::string columns;
    for (const std::string_view list : {kEntryColumns, kTable.columns}) {
      std::string qualified = "r." + std::string(list);
      for (std::size_t at = 0; (at = qualified.find(", ", at)) != std::string::npos; at += 4) {
        qualified.insert(at + 2, "r.");
      }
      columns += (columns.empty() ? "" : ", ") + qualified;
    }
    columns += ", " + fitsChecksum(connection, kTable.name, "r");
    if (with_recording) columns += ", recording.data, " + fitsChecksum(connection, "recording", "recording");
    std::string sql = "SELECT " + columns + " FROM " + std::string(kTable.name) +
                      (selection.history ? "" : "_current") + " AS r JOIN session AS s ON s.id = r.session_id";
    if (with_recording) sql += " JOIN recording ON recording.stroke_id = r.id";
    sql += " WHERE (?1 IS NULL OR s.person_id = ?1) AND (?2 IS NULL OR s.id = ?2)";
    sql += " ORDER BY s.started_utc_ms, s.id, r.sequence, r.id";
    Query query(connection, sql);
    query.put(selection.person).put(selection.session);
    std::vector<Record> found;
    while (query.next()) {
      Record record;
      record.entry.id = query.id();
      record.entry.session = query.id();
      query.integer();  // the sequence, which the order of the rows tells
      record.entry.when.utc_ms = query.integer();
      record.entry.when.monotonic_ns = query.integer();
      record.entry.entered_by = fromWord<study::EnteredBy>(query.text());
      record.entry.supersedes = query.idOrNothing();
      record.entry.reason = query.text();
      takeColumns(query, record);
      query.requireIntact(kTable.name, record.entry.id);
      if constexpr (kIsStroke) {
        if (with_recording) record.recording = takeRecording(query, record.entry.id);
      }
      found.push_back(std::move(record));
    }
    return found;
  });
}

}  // namespace

Result<void> append(StudyFile& file, const study::ProfileRecord& record) { return appendEntry(file, record); }
Result<void> append(StudyFile& file, const study::EventRecord& record) { return appendEntry(file, record); }
Result<void> append(StudyFile& file, const study::StrokeRecord& record) { return appendEntry(file, record); }
Result<void> append(StudyFile& file, const study::JudgementRecord& record) { return appendEntry(file, record); }
Result<void> append(StudyFile& file, const study::AnswerRecord& record) { return appendEntry(file, record); }
Result<void> append(StudyFile& file, const study::RatingRecord& record) { return appendEntry(file, record); }
Result<void> append(StudyFile& file, const study::RuleRecord& record) { return appendEntry(file, record); }

Result<std::vector<study::ProfileRecord>> profiles(const StudyFile& file, const Selection& selection) {
  return readEntries<study::ProfileRecord>(file, selection);
}
Result<std::vector<study::EventRecord>> events(const StudyFile& file, const Selection& selection) {
  return readEntries<study::EventRecord>(file, selection);
}
Result<std::vector<study::StrokeRecord>> strokes(const StudyFile& file, const Selection& selection,
                                                 Recordings recordings) {
  return readEntries<study::StrokeRecord>(file, selection, recordings);
}
Result<std::vector<study::JudgementRecord>> judgements(const StudyFile& file, const Selection& selection) {
  return readEntries<study::JudgementRecord>(file, selection);
}
Result<std::vector<study::AnswerRecord>> answers(const StudyFile& file, const Selection& selection) {
  return readEntries<study::AnswerRecord>(file, selection);
}
Result<std::vector<study::RatingRecord>> ratings(const StudyFile& file, const Selection& selection) {
  return readEntries<study::RatingRecord>(file, selection);
}
Result<std::vector<study::RuleRecord>> rules(const StudyFile& file, const Selection& selection) {
  return readEntries<study::RuleRecord>(file, selection);
}

Result<std::map<RecordId, std::int64_t>> sequences(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    std::map<RecordId, std::int64_t> found;
    for (const std::string_view table : kEntryTables) {
      Query query(connection, "SELECT id, sequence FROM " + std::string(table));
      while (query.next()) {
        const RecordId id = query.id();
        found[id] = query.integer();
      }
    }
    return found;
  });
}

Result<study::Recording> recordingOf(const StudyFile& file, const RecordId& stroke) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    Query query(connection, "SELECT data, " + fitsChecksum(connection, "recording", "recording") +
                                " FROM recording WHERE stroke_id = ?");
    if (!query.put(stroke).next()) {
      refuse(ErrorCode::kReference, {}, "no stroke " + study::toText(stroke), "the id of a stroke of the study");
    }
    return takeRecording(query, stroke);
  });
}

}  // namespace tactus::store
