#include "core/store/feel_records.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/store/felt_events.h"
#include "core/store/query.h"

namespace tactus::store {

using base::JsonMembers;
using base::JsonWriter;
using base::kAnyNumber;
using base::required;
using base::Result;
using study::EventRecord;

EventRecord eventOf(const study::PlacementRecord& record) {
  JsonWriter json;
  json.beginObject(JsonWriter::Layout::kInline).key("duration_s").value(record.duration_s);
  json.key("strokes").value(record.strokes).key("peak_force_n").value(record.peak_force_n);
  json.key("mean_force_n").value(record.mean_force_n).key("depth_mm").value(record.depth_mm);
  writeSetting(record.setting, json);
  return eventWith(record.entry, kPlacementKind, json.endObject());
}

EventRecord eventOf(const study::FeelMark& record) {
  JsonWriter json;
  json.beginObject(JsonWriter::Layout::kInline).key("depth_mm").value(record.depth_mm);
  json.key("speed_mm_s").value(record.speed_mm_s).key("force_n").value(record.force_n);
  json.key("model_force_n").value(record.model_force_n);
  writeSetting(record.setting, json);
  return eventWith(record.entry, kFeelMarkKind, json.endObject());
}

EventRecord eventOf(const study::FeelStart& record) {
  JsonWriter json;
  json.beginObject(JsonWriter::Layout::kInline).key("recording").value(record.number);
  writeSetting(record.setting, json);
  return eventWith(record.entry, kFeelStartKind, json.endObject());
}

EventRecord eventOf(const study::FeelEnd& record) {
  JsonWriter json;
  json.beginObject(JsonWriter::Layout::kInline).key("recording").value(record.recording);
  return eventWith(record.entry, kFeelEndKind, json.key("pieces").value(record.pieces).endObject());
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
  return recordOf<study::PlacementRecord>(event, [](auto& out, JsonMembers& members, auto&) {
    members.number(required("duration_s"), out.duration_s, kPositive);
    members.integer(required("strokes"), out.strokes, kCount);
    members.number(required("peak_force_n"), out.peak_force_n, kPositive);
    members.number(required("mean_force_n"), out.mean_force_n, kAnyNumber);
    members.number(required("depth_mm"), out.depth_mm, kAnyNumber);
    readSetting(members, out.setting);
  });
}

Result<study::FeelMark> feelMarkOf(const EventRecord& event) {
  return recordOf<study::FeelMark>(event, [](auto& out, JsonMembers& members, auto&) {
    members.number(required("depth_mm"), out.depth_mm, kAnyNumber);
    members.number(required("speed_mm_s"), out.speed_mm_s, kAnyNumber);
    members.number(required("force_n"), out.force_n, kAnyNumber);
    members.number(required("model_force_n"), out.model_force_n, kAnyNumber);
    readSetting(members, out.setting);
  });
}

Result<study::FeelStart> feelStartOf(const EventRecord& event) {
  return recordOf<study::FeelStart>(event, [](auto& out, JsonMembers& members, auto&) {
    members.integer(required("recording"), out.number, kFromOne);
    readSetting(members, out.setting);
  });
}

Result<study::FeelEnd> feelEndOf(const EventRecord& event) {
  return recordOf<study::FeelEnd>(event, [](auto& out, JsonMembers& members, auto&) {
    members.integer(required("recording"), out.recording, kFromOne);
    members.integer(required("pieces"), out.pieces, kCount);
  });
}

namespace {

using base::ErrorCode;
using study::RecordId;

/// Recordings count from 1 within their session.
using RecordingKey = std::pair<RecordId, int>;

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
  return appendEvent(file, eventOf(record), placementOf);
}
Result<void> append(StudyFile& file, const study::FeelMark& record) {
  return appendEvent(file, eventOf(record), feelMarkOf);
}
Result<void> append(StudyFile& file, const study::FeelStart& record) {
  return appendEvent(file, eventOf(record), feelStartOf);
}
Result<void> append(StudyFile& file, const study::FeelEnd& record) {
  return appendEvent(file, eventOf(record), feelEndOf);
}
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

Result<std::vector<study::FeelMark>> feelMarks(const StudyFile& file) {
  TACTUS_TRY(const auto all, events(file));
  std::optional<base::Error> first;
  auto out = readEvents(all, kFeelMarkKind, feelMarkOf, [&](const base::Error& error) {
    if (!first) first = error;
  });
  if (first) return base::inFile(*first, file.path());
  std::stable_sort(out.begin(), out.end(), [](const study::FeelMark& a, const study::FeelMark& b) {
    return a.entry.when.utc_ms < b.entry.when.utc_ms;
  });
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
  readEvents(all, kFeelMarkKind, feelMarkOf, tell);
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
