#include "core/store/felt_events.h"

#include "core/store/query.h"
#include "core/store/words.h"

namespace tactus::store {

using base::ErrorCode;
using base::JsonMembers;
using base::JsonWriter;
using base::Result;
using study::RecordId;

study::EventRecord eventWith(const study::Entry& entry, std::string_view kind, const JsonWriter& json) {
  std::string text = json.text();
  text.pop_back();  // the newline of a whole file
  return {entry, std::string(kind), std::move(text)};
}

void writeSetting(const study::FeltSetting& setting, JsonWriter& json) {
  if (!setting.device.empty()) json.key("device").value(setting.device);
  json.key("simulated").value(setting.simulated);
  if (!setting.model.empty()) json.key("model").value(setting.model);
  if (setting.model_version) json.key("model_version").value(study::toText(*setting.model_version));
  json.key("conditions").beginObject(JsonWriter::Layout::kInline);
  for (const auto& [input, value] : setting.conditions) json.key(input).value(value);
  json.endObject();
}

void readSetting(JsonMembers& members, study::FeltSetting& setting) {
  members.text("device", setting.device);
  members.flag(base::required("simulated"), setting.simulated);
  members.text("model", setting.model);
  members.numbers(base::required("conditions"), setting.conditions, base::kAnyNumber);
  readId(members, "model_version", setting.model_version);
}

void readId(JsonMembers& members, base::JsonKey key, RecordId& id) {
  std::string text;
  members.text(key, text);
  if (text.empty()) return;
  if (const auto read = study::parseRecordId(text)) {
    id = *read;
  } else {
    members.refuse(key.name, "32 hexadecimal digits");
  }
}

void readId(JsonMembers& members, std::string_view key, std::optional<RecordId>& id) {
  if (!members.has(key)) return;
  RecordId read;
  readId(members, base::JsonKey(key), read);
  id = read;
}

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

}  // namespace tactus::store
