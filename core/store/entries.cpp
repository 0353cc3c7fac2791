#include "core/store/entries.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

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
const std::string& plainName(const std::string& name, std::string_view place) {
  if (base::looksLikeFormula(name)) refuse(ErrorCode::kValue, std::string(place), base::quoted(name), base::kNoFormula);
  return name;
}

/// How a text is stored.
enum class TextIs {
  kAny,
  kName,          ///< a plain name
  kNameOrNumber,  ///< the same, or a number on a rating scale
  kJson,
};

template <class T, class Record>
concept MayBeConst = std::is_same_v<std::remove_const_t<T>, Record>;

// The columns of each kind of record after those of study::Entry, in the order of the table: written, read and named by
// the same list.

void describe(auto& column, MayBeConst<study::ProfileRecord> auto& record) {
  column("years_experience", record.years_experience);
  column("insertions_per_month", record.insertions_per_month);
  column("category", record.category);
  column("handedness", record.handedness);
  column("gloves", record.gloves);
  column("tube_size", record.tube_size);
  column("haptic_experience", record.haptic_experience);
  column("weight", record.weight);
  column("comfort", record.comfort);
}

void describe(auto& column, MayBeConst<study::EventRecord> auto& record) {
  column("kind", record.kind);
  column("detail", record.detail, TextIs::kJson);
}

void describe(auto& column, MayBeConst<study::StrokeRecord> auto& record) {
  column("level", record.level, TextIs::kName);
  column("number", record.number);
  column("attempt", record.attempt);
  column("practice", record.practice);
  column("verdict", record.verdict);
  column("first_sample", record.first);
  column("end_sample", record.last);
}

void describe(auto& column, MayBeConst<study::JudgementRecord> auto& record) {
  column("series", record.series, TextIs::kName);
  column("step", record.step);
  column("attempt", record.attempt);
  column("commanded_n", record.commanded_n);
  column("felt_n", record.felt_n);
  column("kind", record.kind);
  column("term", record.term, TextIs::kName);
  column("scored", record.scored);
  column("catch_trial", record.catch_trial);
  column("feel_again", record.feel_again);
  column("forward_mm", record.forward_mm);
  column("forward_speed_mm_s", record.forward_speed_mm_s);
  column("response_s", record.response_s);
  column("delivered_share", record.delivered_share);
}

void describe(auto& column, MayBeConst<study::AnswerRecord> auto& record) {
  column("form", record.form, TextIs::kName);
  column("form_version", record.form_version);
  column("item", record.item);
  column("position", record.position);
  column("status", record.status);
  column("value", record.value, TextIs::kNameOrNumber);
  column("response_s", record.response_s);
  column("wording", record.wording, TextIs::kName);
}

void describe(auto& column, MayBeConst<study::RatingRecord> auto& record) {
  column("block", record.block);
  column("effort", record.effort);
  column("comfort", record.comfort);
}

void describe(auto& column, MayBeConst<study::RuleRecord> auto& record) {
  column("form", record.rule.form, TextIs::kName);
  column("conditions", record.rule.conditions);
  column("then_term", record.rule.then, TextIs::kName);
  column("weight", record.rule.weight);
}

/// Binds the columns of a record.
class PutColumns {
 public:
  explicit PutColumns(Query& query) : query_(query) {}

  template <class Value>
  void operator()(std::string_view /*name*/, const Value& value) {
    if constexpr (std::is_enum_v<Value>) {
      query_.put(wordFor(value));
    } else if constexpr (std::is_same_v<Value, std::size_t>) {
      query_.put(static_cast<std::int64_t>(value));
    } else {
      query_.put(value);
    }
  }
  void operator()(std::string_view name, const std::string& text, TextIs is) {
    if (is == TextIs::kJson) {
      query_.putJson(text);
    } else {
      const bool may_be_any = is == TextIs::kNameOrNumber && base::parseNumber(text).has_value();
      query_.put(may_be_any ? text : plainName(text, name));
    }
  }
  void operator()(std::string_view name, const std::vector<study::ItemCondition>& conditions) {
    for (const study::ItemCondition& condition : conditions) plainName(condition.term, name);
    query_.put(conditionsText(conditions));
  }

 private:
  Query& query_;
};

/// Reads the columns of a record.
class TakeColumns {
 public:
  explicit TakeColumns(Query& query) : query_(query) {}

  void operator()(std::string_view /*name*/, std::string& text, TextIs /*is*/ = TextIs::kAny) { text = query_.text(); }
  void operator()(std::string_view /*name*/, int& number) { number = query_.small(); }
  void operator()(std::string_view /*name*/, bool& flag) { flag = query_.flag(); }
  void operator()(std::string_view /*name*/, double& number) { number = query_.number(); }
  void operator()(std::string_view /*name*/, std::optional<double>& number) { number = query_.numberOrNothing(); }
  void operator()(std::string_view /*name*/, std::size_t& count) { count = static_cast<std::size_t>(query_.integer()); }
  void operator()(std::string_view /*name*/, std::vector<study::ItemCondition>& conditions) {
    conditions = parseConditions(query_.text());
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void operator()(std::string_view /*name*/, Enum& word) { word = fromWord<Enum>(query_.text()); }

 private:
  Query& query_;
};

/// `r.level, r.number, …`, of the table `r`.
template <class Record>
std::string columnNames() {
  std::string names;
  const auto add = [&names](std::string_view name, const auto&...) {
    names += (names.empty() ? "r." : ", r.") + std::string(name);
  };
  const Record record;
  describe(add, record);
  return names;
}

template <class Record>
constexpr std::string_view kTable = {};
template <>
constexpr std::string_view kTable<study::ProfileRecord> = "profile";
template <>
constexpr std::string_view kTable<study::EventRecord> = "event";
template <>
constexpr std::string_view kTable<study::StrokeRecord> = "stroke";
template <>
constexpr std::string_view kTable<study::JudgementRecord> = "judgement";
template <>
constexpr std::string_view kTable<study::AnswerRecord> = "answer";
template <>
constexpr std::string_view kTable<study::RatingRecord> = "rating";
template <>
constexpr std::string_view kTable<study::RuleRecord> = "rule";

using base::Result;
using study::Entry;
using study::RecordId;

constexpr std::string_view kEntryColumns =
    "r.id, r.session_id, r.sequence, r.utc_ms, r.monotonic_ns, r.entered_by, r.supersedes, r.reason";

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
  const Entry& entry = record.entry;
  if (entry.supersedes) requireUncorrected(connection, kTable<Record>, *entry.supersedes);
  KeptQuery insert(connection, insertion(connection, kTable<Record>));
  insert.put(entry.id).put(entry.session).put(nextSequence(connection, entry.session));
  insert.put(entry.when.utc_ms).put(entry.when.monotonic_ns).put(wordFor(entry.entered_by));
  insert.put(entry.supersedes).put(entry.reason);
  PutColumns columns(insert);
  describe(columns, record);
  insert.run();
}

void insertRecording(Connection& connection, const study::StrokeRecord& record) {
  if (record.last > record.recording.size()) {
    refuse(ErrorCode::kValue, "stroke", "an end at sample " + std::to_string(record.last),
           "one within the " + std::to_string(record.recording.size()) + " samples of its recording");
  }
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
  constexpr bool kIsStroke = std::is_same_v<Record, study::StrokeRecord>;
  const bool with_recording = kIsStroke && recordings == Recordings::kRead;
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    std::string columns = std::string(kEntryColumns) + ", " + columnNames<Record>() + ", " +
                          fitsChecksum(connection, kTable<Record>, "r");
    if (with_recording) columns += ", recording.data, " + fitsChecksum(connection, "recording", "recording");
    std::string sql = "SELECT " + columns + " FROM " + std::string(kTable<Record>) +
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
      TakeColumns own(query);
      describe(own, record);
      query.requireIntact(kTable<Record>, record.entry.id);
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
