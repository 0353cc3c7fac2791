// Records of usability sessions that are stored as events: their detail as JSON, and back. Private to core/store.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/json/json_members.h"
#include "core/base/json/json_writer.h"
#include "core/store/entries.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::store {

inline constexpr base::NumberRange kPositive{0, std::numeric_limits<double>::max()};
inline constexpr base::NumberRange kCount{0, std::numeric_limits<int>::max()};
inline constexpr base::NumberRange kFromOne{1, std::numeric_limits<int>::max()};

// Kinds of the events of a sealed reference (sealed_references.h). No withdrawal changes their detail.
inline constexpr std::string_view kSealedKind = "reference_sealed";
inline constexpr std::string_view kOpenedKind = "reference_opened";
/// The condition of SQL for them.
inline constexpr const char* kIsOfSeal = "kind IN ('reference_sealed', 'reference_opened')";

/// The event whose detail is the complete object `json`.
study::EventRecord eventWith(const study::Entry& entry, std::string_view kind, const base::JsonWriter& json);
/// Reads the detail of `event` with `read(JsonMembers&, std::optional<Error>&)`. Ignores members of a newer program.
template <class Read>
base::Result<void> readDetail(const study::EventRecord& event, Read read) {
  const std::string place = event.kind + " " + study::toText(event.entry.id);
  const auto named = [&](base::Error error) {
    error.place = error.place.empty() ? place : place + ": " + error.place;
    return tl::unexpected(std::move(error));
  };
  const auto document = base::JsonDocument::parse(event.detail);
  if (!document) return named(document.error());
  std::optional<base::Error> error;
  base::JsonMembers members(document->root(), error);
  read(members, error);
  if (error) return named(*std::move(error));
  return {};
}

/// The record of `event`, whose detail `read(Record&, JsonMembers&, std::optional<Error>&)` reads.
template <class Record, class Read>
base::Result<Record> recordOf(const study::EventRecord& event, Read read) {
  Record out;
  out.entry = event.entry;
  const auto ok = readDetail(
      event, [&](base::JsonMembers& members, std::optional<base::Error>& error) { read(out, members, error); });
  if (!ok) return tl::unexpected(ok.error());
  return out;
}

void writeSetting(const study::FeltSetting& setting, base::JsonWriter& json);
void readSetting(base::JsonMembers& members, study::FeltSetting& setting);
/// The id of a record in the member `key`. Refuses a text that is none.
void readId(base::JsonMembers& members, base::JsonKey key, study::RecordId& id);
void readId(base::JsonMembers& members, std::string_view key, std::optional<study::RecordId>& id);

/// Refuses a session of another kind than usability.
base::Result<void> requireUsability(const StudyFile& file, const study::RecordId& session);

/// Appends `event`, the event of a record that `read` has to give back.
template <class Record>
base::Result<void> appendEvent(StudyFile& file, const study::EventRecord& event,
                               base::Result<Record> (*read)(const study::EventRecord&)) {
  if (auto ok = requireUsability(file, event.entry.session); !ok) return ok;
  if (auto again = read(event); !again) return base::inFile(again.error(), file.path());
  return append(file, event);
}

/// The events of one kind, read. Calls `unreadable` for each that cannot be.
template <class Record, class Unreadable>
std::vector<Record> readEvents(const std::vector<study::EventRecord>& events, std::string_view kind,
                               base::Result<Record> (*read)(const study::EventRecord&), Unreadable unreadable) {
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

/// The code of the person of each session.
base::Result<std::map<study::RecordId, std::string>> codesOfSessions(const StudyFile& file);

}  // namespace tactus::store
