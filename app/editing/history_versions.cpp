#include "app/editing/history_versions.h"

#include <map>
#include <string_view>
#include <utility>

#include "core/base/check.h"
#include "core/base/files/checksums.h"
#include "core/model_io/model_file.h"

namespace tactus::editing {

using base::ErrorCode;
using base::fail;
using base::Result;
using study::ModelVersion;
using study::RecordId;

namespace {

constexpr EventKind kKinds[] = {EventKind::kOpened, EventKind::kEdit,     EventKind::kUndo,   EventKind::kRedo,
                                EventKind::kReturn, EventKind::kSnapshot, EventKind::kSignOff};
constexpr std::string_view kSeparator = ": ";

struct KindAndLabel {
  EventKind kind = EventKind::kEdit;
  std::string label;
};

KindAndLabel read(const std::string& label) {
  for (const EventKind kind : kKinds) {
    const std::string start = std::string(name(kind)).append(kSeparator);
    if (label.starts_with(start)) return {kind, label.substr(start.size())};
  }
  return {EventKind::kEdit, label};
}

}  // namespace

/// Makes a history from versions.
class HistoryReader {
 public:
  static Result<EditHistory> read(std::span<const ModelVersion> versions, study::RecordIds ids, std::size_t stored) {
    if (versions.empty()) return fail(ErrorCode::kData, "model versions", "none", "one or more");
    EditHistory out(ids);
    std::map<RecordId, std::size_t> events;
    for (const auto& version : versions) {
      if (!events.emplace(version.id, out.events_.size()).second) {
        return fail(ErrorCode::kSchema, "model version " + study::toText(version.id), "the id twice", "each id once");
      }
      addVersion(out, version, versions, events);
    }
    auto last = model_io::parseModel(versions.back().text, "model version " + study::toText(versions.back().id));
    if (!last) return tl::unexpected(std::move(last.error()));
    const StateId current = out.events_.back().state;
    out.states_[current].kept = std::make_shared<const KeptModel>(last->model, nullptr);
    auto ready = editing::ready(std::move(last->model));
    TACTUS_CHECK(ready.has_value());
    out.enter(current, std::move(*ready));
    for (std::size_t v = stored; v < versions.size(); ++v) {
      if (auto kept = keep(out, out.events_[v], versions[v]); !kept) return tl::unexpected(std::move(kept.error()));
    }
    return out;
  }

 private:
  static void addVersion(EditHistory& out, const ModelVersion& version, std::span<const ModelVersion> versions,
                         const std::map<RecordId, std::size_t>& events) {
    auto [kind, label] = editing::read(version.label);
    const auto parent = version.parent ? events.find(*version.parent) : events.end();
    const bool has_parent = parent != events.end() && parent->second != out.events_.size();
    const bool new_state = kind == EventKind::kOpened || kind == EventKind::kEdit || !has_parent ||
                           shaOf(versions[parent->second]) != shaOf(version);
    StateId state = has_parent ? out.events_[parent->second].state : 0;
    if (new_state) {
      State made;
      made.event = out.events_.size();
      if (has_parent) {
        made.parent = state;
        made.edits = out.states_[state].edits + 1;
        out.states_[state].redo = out.states_.size();
      }
      state = out.states_.size();
      out.states_.push_back(std::move(made));
      if (kind != EventKind::kOpened) kind = EventKind::kEdit;
    }
    if (kind == EventKind::kReturn) {
      for (StateId s = state; out.states_[s].parent; s = *out.states_[s].parent) {
        out.states_[*out.states_[s].parent].redo = s;
      }
    }
    out.events_.push_back(
        {version.id, version.parent, kind, std::move(label), {version.author, version.utc_ms}, state, true});
  }

  // What is not stored anywhere has to stay in memory.
  static Result<void> keep(EditHistory& out, Event& event, const ModelVersion& version) {
    event.stored = false;
    State& state = out.states_[event.state];
    if (state.kept) return {};
    const auto read = model_io::parseModel(version.text, "model version " + study::toText(version.id));
    if (!read) return tl::unexpected(read.error());
    const KeptModel* const before = state.parent ? out.states_[*state.parent].kept.get() : nullptr;
    state.kept = std::make_shared<const KeptModel>(read->model, before);
    return {};
  }

  static std::string shaOf(const ModelVersion& version) {
    return version.sha256.empty() ? base::sha256(version.text) : version.sha256;
  }
};

Result<ModelVersion> versionOf(const EditHistory& history, const Event& event) {
  const auto model = history.modelOf(event.state);
  if (!model) return tl::unexpected(model.error());
  return versionOf(event, *model);
}

ModelVersion versionOf(const Event& event, const fuzzy::ForceModel& model) {
  ModelVersion out;
  out.id = event.id;
  out.parent = event.parent;
  out.utc_ms = event.stamp.utc_ms;
  out.author = event.stamp.author;
  out.label = std::string(name(event.kind)).append(kSeparator).append(event.label);
  out.text = model_io::formatModel(model);
  out.sha256 = base::sha256(out.text);
  return out;
}

std::vector<ModelVersion> unstoredVersions(const EditHistory& history) {
  std::vector<ModelVersion> out;
  for (const auto& event : history.events()) {
    if (event.stored) continue;
    auto version = versionOf(history, event);
    // A state leaves the memory only once its version is stored.
    if (version) out.push_back(std::move(*version));
  }
  return out;
}

Result<EditHistory> historyFrom(std::span<const ModelVersion> versions, study::RecordIds ids, std::size_t stored) {
  return HistoryReader::read(versions, ids, stored);
}

Result<void> provideVersion(EditHistory& history, StateId state, const ModelVersion& version) {
  const auto read = model_io::parseModel(version.text, "model version " + study::toText(version.id));
  if (!read) return tl::unexpected(read.error());
  return history.provide(state, version.id, read->model);
}

}  // namespace tactus::editing
