#include "core/store/feel_records.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/base/json/json_members.h"
#include "core/base/json/json_writer.h"
#include "core/store/query.h"
#include "core/store/words.h"

namespace tactus::store {
namespace {

using base::JsonDocument;
using base::JsonMembers;
using base::JsonWriter;
using base::kAnyNumber;
using base::NumberRange;
using base::required;
using base::Result;
using study::EventRecord;

constexpr NumberRange kPositive{0, std::numeric_limits<double>::max()};
constexpr NumberRange kCount{0, std::numeric_limits<int>::max()};
constexpr NumberRange kFromOne{1, std::numeric_limits<int>::max()};

std::string oneLine(const JsonWriter& json) {
  std::string text = json.text();
  text.pop_back();  // the newline of a whole file
  return text;
}

void write(const study::FeltSetting& setting, JsonWriter& json) {
  if (!setting.device.empty()) json.key("device").value(setting.device);
  json.key("simulated").value(setting.simulated);
  if (!setting.model.empty()) json.key("model").value(setting.model);
  if (setting.model_version) json.key("model_version").value(study::toText(*setting.model_version));
  json.key("conditions").beginObject(JsonWriter::Layout::kInline);
  for (const auto& [input, value] : setting.conditions) json.key(input).value(value);
  json.endObject();
}

void read(JsonMembers& members, study::FeltSetting& setting) {
  members.text("device", setting.device);
  members.flag(required("simulated"), setting.simulated);
  members.text("model", setting.model);
  members.numbers(required("conditions"), setting.conditions, kAnyNumber);
  if (!members.has("model_version")) return;
  std::string version;
  members.text("model_version", version);
  setting.model_version = study::parseRecordId(version);
  if (!setting.model_version) members.refuse("model_version", "32 hexadecimal digits");
}

/// Reads the detail of `event` with `read`, which gets the members of its object. Ignores members of a newer program.
template <class Read>
Result<void> readDetail(const EventRecord& event, Read read) {
  const std::string place = event.kind + " " + study::toText(event.entry.id);
  const auto named = [&](base::Error error) {
    error.place = error.place.empty() ? place : place + ": " + error.place;
    return tl::unexpected(std::move(error));
  };
  const auto document = JsonDocument::parse(event.detail);
  if (!document) return named(document.error());
  std::optional<base::Error> error;
  JsonMembers members(document->root(), error);
  read(members);
  if (error) return named(*std::move(error));
  return {};
}

EventRecord event(const study::Entry& entry, std::string_view kind, const JsonWriter& json) {
  return {entry, std::string(kind), oneLine(json)};
}

}  // namespace

EventRecord eventOf(const study::PlacementRecord& record) {
  JsonWriter json;
  json.beginObject(JsonWriter::Layout::kInline).key("duration_s").value(record.duration_s);
  json.key("strokes").value(record.strokes).key("peak_force_n").value(record.peak_force_n);
  json.key("mean_force_n").value(record.mean_force_n).key("depth_mm").value(record.depth_mm);
  write(record.setting, json);
  return event(record.entry, kPlacementKind, json.endObject());
}

EventRecord eventOf(const study::FeelStart& record) {
  JsonWriter json;
  json.beginObject(JsonWriter::Layout::kInline).key("recording").value(record.number);
  write(record.setting, json);
  return event(record.entry, kFeelStartKind, json.endObject());
}

EventRecord eventOf(const study::FeelEnd& record) {
  JsonWriter json;
  json.beginObject(JsonWriter::Layout::kInline).key("recording").value(record.recording);
  return event(record.entry, kFeelEndKind, json.key("pieces").value(record.pieces).endObject());
}

study::StrokeRecord strokeOf(const study::FeelPiece& record) {
  study::StrokeRecord stroke;
  stroke.entry = record.entry;
  stroke.level = kFeelLevel;
  stroke.number = record.number;
  stroke.attempt = record.recording;
  stroke.verdict = record.gap_follows ? kFeelGapVerdict : kFeelVerdict;
  stroke.last = record.samples.size();
  stroke.recording = record.samples;
  return stroke;
}

Result<study::PlacementRecord> placementOf(const EventRecord& event) {
  study::PlacementRecord out;
  out.entry = event.entry;
  const auto ok = readDetail(event, [&](JsonMembers& members) {
    members.number(required("duration_s"), out.duration_s, kPositive);
    members.integer(required("strokes"), out.strokes, kCount);
    members.number(required("peak_force_n"), out.peak_force_n, kPositive);
    members.number(required("mean_force_n"), out.mean_force_n, kAnyNumber);
    members.number(required("depth_mm"), out.depth_mm, kAnyNumber);
    read(members, out.setting);
  });
  if (!ok) return tl::unexpected(ok.error());
  return out;
}

Result<study::FeelStart> feelStartOf(const EventRecord& event) {
  study::FeelStart out;
  out.entry = event.entry;
  const auto ok = readDetail(event, [&](JsonMembers& members) {
    members.integer(required("recording"), out.number, kFromOne);
    read(members, out.setting);
  });
  if (!ok) return tl::unexpected(ok.error());
  return out;
}

Result<study::FeelEnd> feelEndOf(const EventRecord& event) {
  study::FeelEnd out;
  out.entry = event.entry;
  const auto ok = readDetail(event, [&](JsonMembers& members) {
    members.integer(required("recording"), out.recording, kFromOne);
    members.integer(required("pieces"), out.pieces, kCount);
  });
  if (!ok) return tl::unexpected(ok.error());
  return out;
}

namespace {

using base::ErrorCode;
using base::Result;
using study::RecordId;

/// Recordings count from 1 within their session.
using RecordingKey = std::pair<RecordId, int>;

Result<void> requireUsability(const StudyFile& file, const RecordId& session) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    Query query(connection, "SELECT kind FROM session WHERE id = ?");
    if (!query.put(session).next()) {
      refuse(ErrorCode::kReference, {}, "no session " + study::toText(session), "the id of a session");
    }
    const std::string kind = query.text();
    if (fromWord<study::SessionKind>(kind) != study::SessionKind::kUsability) {
      refuse(ErrorCode::kReference, "session " + study::toText(session), "one of the kind " + kind,
             "one of the kind usability, in which models are felt");
    }
  });
}

/// Appends `record` as `event`, which has to tell it without loss.
template <class Record>
Result<void> appendEvent(StudyFile& file, const Record& record, Result<Record> (*read)(const study::EventRecord&)) {
  if (auto ok = requireUsability(file, record.entry.session); !ok) return ok;
  const study::EventRecord event = eventOf(record);
  if (auto again = read(event); !again) return base::inFile(again.error(), file.path());
  return append(file, event);
}

/// The events of one kind, read; each that cannot be is handed to `unreadable`, which returns whether to go on.
template <class Record, class Unreadable>
std::vector<Record> readEvents(const std::vector<study::EventRecord>& events, std::string_view kind,
                               Result<Record> (*read)(const study::EventRecord&), Unreadable unreadable) {
  std::vector<Record> out;
  for (const auto& event : events) {
    if (event.kind != kind) continue;
    auto record = read(event);
    if (record) {
      out.push_back(std::move(*record));
    } else {
      unreadable(record.error());
    }
  }
  return out;
}

/// A piece without its samples.
struct PieceRow {
  RecordId stroke;
  int number = 0;
  double length_s = 0;
  bool gap_follows = false;
};

/// The pieces of all recordings, by number; two of one number stay beside each other.
Result<std::map<RecordingKey, std::vector<PieceRow>>> pieceRows(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    Query query(connection,
                "SELECT s.id, s.session_id, s.attempt, s.number, r.samples / r.sample_rate_hz, s.verdict FROM "
                "stroke_current AS s"
                " JOIN session ON session.id = s.session_id JOIN recording AS r ON r.stroke_id = s.id"
                " WHERE session.kind = 'usability' AND s.level = ? ORDER BY s.session_id, s.attempt, s.number, s.id");
    query.put(kFeelLevel);
    std::map<RecordingKey, std::vector<PieceRow>> out;
    while (query.next()) {
      PieceRow row;
      row.stroke = query.id();
      const RecordId session = query.id();
      const int recording = query.small();
      row.number = query.small();
      row.length_s = query.number();
      row.gap_follows = query.text() == kFeelGapVerdict;
      out[{session, recording}].push_back(row);
    }
    return out;
  });
}

Result<std::map<RecordId, std::string>> codesOfSessions(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    Query query(connection, "SELECT s.id, p.code FROM session AS s JOIN person_current AS p ON p.id = s.person_id");
    std::map<RecordId, std::string> out;
    while (query.next()) {
      const RecordId session = query.id();
      out[session] = query.text();
    }
    return out;
  });
}

std::string nameOf(const study::FeelStart& start) { return "recording " + study::toText(start.entry.id); }

/// Appends the samples of `piece` to `all`, the pieces before it.
Result<void> join(study::Recording& all, study::Recording piece, const std::string& name) {
  const bool fits = all.channels.size() == piece.channels.size() && all.sample_rate_hz == piece.sample_rate_hz &&
                    std::equal(all.channels.begin(), all.channels.end(), piece.channels.begin(),
                               [](const auto& a, const auto& b) { return a.name == b.name && a.unit == b.unit; });
  if (!fits) return base::fail(ErrorCode::kSchema, name, "pieces with other channels", "the same in every piece");
  for (std::size_t i = 0; i < all.channels.size(); ++i) {
    auto& to = all.channels[i].values;
    const auto& from = piece.channels[i].values;
    to.insert(to.end(), from.begin(), from.end());
  }
  return {};
}

/// What is wrong with the pieces of one recording.
void checkPieces(const std::string& name, const std::vector<PieceRow>& pieces, std::optional<int> told,
                 std::vector<std::string>& findings) {
  int expected = 1;
  for (const PieceRow& piece : pieces) {
    if (piece.number != expected) {
      findings.push_back(name + ": piece " + std::to_string(piece.number) + " where piece " + std::to_string(expected) +
                         " was to come");
      return;
    }
    ++expected;
  }
  if (told && *told != expected - 1) {
    findings.push_back(name + ": its end tells of " + std::to_string(*told) + " pieces, there are " +
                       std::to_string(expected - 1));
  }
}

}  // namespace

Result<void> append(StudyFile& file, const study::PlacementRecord& record) {
  return appendEvent(file, record, placementOf);
}
Result<void> append(StudyFile& file, const study::FeelStart& record) { return appendEvent(file, record, feelStartOf); }
Result<void> append(StudyFile& file, const study::FeelEnd& record) { return appendEvent(file, record, feelEndOf); }
Result<void> append(StudyFile& file, const study::FeelPiece& record) {
  if (auto ok = requireUsability(file, record.entry.session); !ok) return ok;
  return append(file, strokeOf(record));
}

Result<std::vector<study::PlacementRecord>> placements(const StudyFile& file, const Selection& selection) {
  TACTUS_TRY(const auto all, events(file, selection));
  std::optional<base::Error> first;
  auto out = readEvents(all, kPlacementKind, placementOf, [&](const base::Error& error) {
    if (!first) first = error;
  });
  if (first) return base::inFile(*first, file.path());
  return out;
}

Result<std::vector<FeelSummary>> feelRecordings(const StudyFile& file) {
  TACTUS_TRY(const auto all, events(file));
  TACTUS_TRY(const auto codes, codesOfSessions(file));
  TACTUS_TRY(const auto pieces, pieceRows(file));
  std::optional<base::Error> first;
  const auto keep = [&](const base::Error& error) {
    if (!first) first = error;
  };
  std::set<RecordingKey> finished;
  for (const auto& end : readEvents(all, kFeelEndKind, feelEndOf, keep)) {
    finished.emplace(end.entry.session, end.recording);
  }
  std::vector<FeelSummary> out;
  for (auto& start : readEvents(all, kFeelStartKind, feelStartOf, keep)) {
    FeelSummary summary;
    const RecordingKey key(start.entry.session, start.number);
    summary.code = codes.at(start.entry.session);
    if (const auto found = pieces.find(key); found != pieces.end()) {
      summary.pieces = static_cast<int>(found->second.size());
      for (const PieceRow& piece : found->second) {
        summary.length_s += piece.length_s;
        summary.gaps += piece.gap_follows ? 1 : 0;
      }
    }
    summary.finished = finished.contains(key);
    summary.start = std::move(start);
    out.push_back(std::move(summary));
  }
  if (first) return base::inFile(*first, file.path());
  std::stable_sort(out.begin(), out.end(), [](const FeelSummary& a, const FeelSummary& b) {
    return a.start.entry.when.utc_ms < b.start.entry.when.utc_ms;
  });
  return out;
}

Result<study::Recording> feelRecording(const StudyFile& file, const RecordId& start) {
  TACTUS_TRY(const auto all, feelRecordings(file));
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const FeelSummary& one) { return one.start.entry.id == start; });
  const auto refused = [&](ErrorCode code, std::string what, std::string wanted) {
    return base::inFile({code, {}, "recording " + study::toText(start), std::move(what), std::move(wanted)},
                        file.path());
  };
  if (found == all.end()) return refused(ErrorCode::kReference, "none", "a recording of the study");
  TACTUS_TRY(const auto rows, pieceRows(file));
  const auto pieces = rows.find({found->start.entry.session, found->start.number});
  if (pieces == rows.end()) return refused(ErrorCode::kData, "no samples", "a recording with samples");
  std::vector<std::string> findings;
  checkPieces(nameOf(found->start), pieces->second, {}, findings);
  if (!findings.empty()) return refused(ErrorCode::kData, "a piece that is missing", "all pieces in their order");
  std::optional<study::Recording> out;
  for (const PieceRow& piece : pieces->second) {
    TACTUS_TRY(auto samples, recordingOf(file, piece.stroke));
    if (!out) {
      out = std::move(samples);
    } else if (auto ok = join(*out, std::move(samples), nameOf(found->start)); !ok) {
      return base::inFile(ok.error(), file.path());
    }
  }
  return *std::move(out);
}

Result<std::vector<std::string>> checkFeelRecords(const StudyFile& file) {
  TACTUS_TRY(const auto all, events(file));
  TACTUS_TRY(auto pieces, pieceRows(file));
  std::vector<std::string> findings;
  const auto tell = [&](const base::Error& error) { findings.push_back(error.message()); };
  readEvents(all, kPlacementKind, placementOf, tell);
  std::map<RecordingKey, int> ends;
  for (const auto& end : readEvents(all, kFeelEndKind, feelEndOf, tell)) {
    ends[{end.entry.session, end.recording}] = end.pieces;
  }
  for (const auto& start : readEvents(all, kFeelStartKind, feelStartOf, tell)) {
    const RecordingKey key(start.entry.session, start.number);
    const auto end = ends.find(key);
    const auto found = pieces.find(key);
    checkPieces(nameOf(start), found == pieces.end() ? std::vector<PieceRow>() : found->second,
                end == ends.end() ? std::nullopt : std::optional(end->second), findings);
    if (found == pieces.end()) continue;
    for (const PieceRow& piece : found->second) {
      if (!piece.gap_follows) continue;
      findings.push_back(nameOf(start) + ": samples were lost behind piece " + std::to_string(piece.number));
    }
    pieces.erase(found);
  }
  for (const auto& [key, rows] : pieces) {
    findings.push_back("session " + study::toText(key.first) + ": pieces of recording " + std::to_string(key.second) +
                       ", whose beginning is missing");
  }
  return findings;
}

Result<FeelCounts> feelCounts(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    FeelCounts out;
    Query query(connection, "SELECT count(*) FROM event_current WHERE kind = ?");
    query.put(kPlacementKind).next();
    out.placements = query.integer();
    Query recordings(connection, "SELECT count(*) FROM event_current WHERE kind = ?");
    recordings.put(kFeelStartKind).next();
    out.recordings = recordings.integer();
    return out;
  });
}

}  // namespace tactus::store
