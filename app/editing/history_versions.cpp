#include "app/editing/history_versions.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/files/checksums.h"
#include "core/model_io/model_file.h"

namespace tactus::editing {
namespace {

using base::Result;
using study::ModelVersion;

constexpr std::string_view kDrag = "drag: ";
constexpr const char* kElsewhere = "another program";

bool haveSameInputs(const fuzzy::ForceModel& one, const fuzzy::ForceModel& other) {
  return std::equal(one.inputs.begin(), one.inputs.end(), other.inputs.begin(), other.inputs.end(),
                    [](const fuzzy::Variable& a, const fuzzy::Variable& b) { return a.id == b.id; });
}

}  // namespace

std::size_t editsIn(std::span<const ModelVersion> versions) {
  return static_cast<std::size_t>(std::count_if(versions.begin(), versions.end(), [](const ModelVersion& version) {
    return version.label.starts_with(name(EventKind::kEdit));
  }));
}

Result<EditHistory> wholeHistory(const KeptVersions& kept, study::RecordIds ids, const Stamp& stamp) {
  auto history = historyFrom(kept.versions, ids, 0);
  if (!history || !kept.unfinished) return history;
  TACTUS_TRY(auto edit, finished(kept.unfinished->model, kept.unfinished->label + " (recovered)"));
  history->apply(std::move(edit), stamp);
  return history;
}

ModelVersion dragVersion(const EditHistory& history, study::RecordIds& ids, std::int64_t utc_ms) {
  fuzzy::ForceModel model = history.model();
  refreshChecks(model, history.compiled());
  ModelVersion out;
  out.id = ids.next();
  out.parent = history.versionOf(history.current());
  out.utc_ms = utc_ms;
  out.label = std::string(kDrag) + history.gestureLabel();
  out.text = model_io::formatModel(model);
  out.sha256 = base::sha256(out.text);
  return out;
}

bool isDrag(const ModelVersion& version) { return version.label.starts_with(kDrag); }

Result<KeptVersions> withoutDrags(std::vector<ModelVersion> versions) {
  KeptVersions out;
  std::optional<ModelVersion> drag;
  if (!versions.empty() && isDrag(versions.back())) drag = versions.back();
  std::erase_if(versions, isDrag);
  out.versions = std::move(versions);
  if (!drag || (!out.versions.empty() && out.versions.back().sha256 == drag->sha256)) return out;
  TACTUS_TRY(auto model, model_io::parseModel(drag->text, "model version " + study::toText(drag->id)));
  out.unfinished = Unfinished{drag->label.substr(kDrag.size()), std::move(model.model)};
  return out;
}

Result<EarlierHistory> goOn(KeptVersions kept, const EditHistory& fresh, study::RecordIds ids,
                            const std::string& changed_label, const Stamp& stamp) {
  std::vector<ModelVersion>& versions = kept.versions;
  if (versions.empty()) return base::fail(base::ErrorCode::kData, "model versions", "none", "one or more");
  const Event& opened = fresh.events().front();
  ModelVersion in_file = versionOf(opened, fresh.base());
  const std::int64_t last_utc_ms = versions.back().utc_ms;
  const auto same = std::find_if(versions.rbegin(), versions.rend(),
                                 [&](const ModelVersion& version) { return version.sha256 == in_file.sha256; });
  const std::size_t known = versions.size();
  const bool changed_elsewhere = same == versions.rend();
  const std::size_t later = static_cast<std::size_t>(same - versions.rbegin());
  if (changed_elsewhere) {
    in_file.parent = versions.back().id;
    in_file.author = kElsewhere;
    in_file.label = std::string(name(EventKind::kEdit)) + ": " + changed_label;
    versions.push_back(std::move(in_file));
  }
  TACTUS_TRY(auto history, historyFrom(versions, ids, 0));
  const auto last = history.modelOf(history.events()[known - 1].state);
  if (!last || !haveSameInputs(*last, fresh.base())) {
    return base::fail(base::ErrorCode::kMismatch, "the history", "a model with other inputs", "the inputs of the file");
  }
  EarlierHistory out{std::move(history), known, {}, {}, 0, last_utc_ms, changed_elsewhere};
  if (changed_elsewhere || (later == 0 && !kept.unfinished)) return out;
  // The newest state is offered, and that of the file shown.
  out.lost = out.history.current();
  out.drag = std::move(kept.unfinished);
  out.edits = editsIn(std::span(versions).last(later)) + (out.drag ? 1 : 0);
  if (later > 0) {
    const StateId state = out.history.events()[known - 1 - later].state;
    if (auto back = out.history.returnTo(state, stamp); !back) return tl::unexpected(std::move(back.error()));
    out.kept = out.history.events().size();
  }
  return out;
}

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
    TACTUS_TRY(auto last,
               model_io::parseModel(versions.back().text, "model version " + study::toText(versions.back().id)));
    const StateId current = out.events_.back().state;
    out.states_[current].kept = std::make_shared<const KeptModel>(last.model, nullptr);
    auto ready = editing::ready(std::move(last.model));
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
    TACTUS_TRY(const auto read, model_io::parseModel(version.text, "model version " + study::toText(version.id)));
    const KeptModel* const before = state.parent ? out.states_[*state.parent].kept.get() : nullptr;
    state.kept = std::make_shared<const KeptModel>(read.model, before);
    return {};
  }

  static std::string shaOf(const ModelVersion& version) {
    return version.sha256.empty() ? base::sha256(version.text) : version.sha256;
  }
};

Result<ModelVersion> versionOf(const EditHistory& history, const Event& event) {
  TACTUS_TRY(const auto model, history.modelOf(event.state));
  return versionOf(event, model);
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
  TACTUS_TRY(const auto read, model_io::parseModel(version.text, "model version " + study::toText(version.id)));
  return history.provide(state, version.id, read.model);
}

}  // namespace tactus::editing
