#include "core/store/feel_events.h"

#include <limits>
#include <utility>

#include "core/base/json/json_members.h"
#include "core/base/json/json_writer.h"

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

}  // namespace tactus::store
