#include "app/session/session_order.h"

#include <algorithm>
#include <map>
#include <utility>

#include "app/session/session_state.h"
#include "core/base/json/json_members.h"
#include "core/store/entries.h"
#include "core/store/sessions.h"

namespace tactus::session {
namespace {

using base::Result;
using study::RecordId;

constexpr const char* kAfter = "after";

std::optional<RecordId> afterIn(const std::string& detail_text) {
  const auto id = base::readJson(detail_text, {}, [](base::JsonMembers& json, auto&) {
    std::string after;
    json.text(kAfter, after);
    return after;
  });
  return id ? study::parseRecordId(*id) : std::nullopt;
}

}  // namespace

std::string afterDetail(const std::optional<RecordId>& latest) {
  return latest ? detail(kAfter, toText(*latest)) : std::string();
}

Result<std::vector<study::SessionRecord>> sessionsInOrder(const store::StudyFile& file, const RecordId& person) {
  auto waiting = store::sessions(file, person);  // by time and id
  if (!waiting || waiting->size() < 2) return waiting;
  const auto events = store::events(file, {person, {}, false});
  if (!events) return tl::unexpected(events.error());
  std::map<RecordId, RecordId> after;
  for (const auto& event : *events) {
    if (const auto before = afterIn(event.detail); before && event.kind == kBegan) {
      after.emplace(event.entry.session, *before);
    }
  }
  std::vector<study::SessionRecord> ordered;
  while (!waiting->empty()) {
    const auto is_free = [&](const study::SessionRecord& session) {
      const auto it = after.find(session.id);
      return it == after.end() ||
             std::none_of(waiting->begin(), waiting->end(), [&](const study::SessionRecord& other) {
               return other.id == it->second && other.id != session.id;
             });
    };
    auto next = std::find_if(waiting->begin(), waiting->end(), is_free);
    if (next == waiting->end()) next = waiting->begin();  // logs that contradict each other leave the time
    ordered.push_back(std::move(*next));
    waiting->erase(next);
  }
  return ordered;
}

Result<std::optional<RecordId>> latestSession(const store::StudyFile& file, const RecordId& person) {
  const auto ordered = sessionsInOrder(file, person);
  if (!ordered) return tl::unexpected(ordered.error());
  return ordered->empty() ? std::nullopt : std::optional(ordered->back().id);
}

}  // namespace tactus::session
