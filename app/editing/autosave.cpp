#include "app/editing/autosave.h"

#include <algorithm>
#include <utility>

#include "core/base/files/sha256.h"
#include "core/base/json/json_members.h"
#include "core/base/json/json_writer.h"
#include "core/model_io/model_file.h"

namespace tactus::editing {
namespace {

using base::JsonMembers;
using base::JsonValue;
using base::required;
using base::Result;
using study::ModelVersion;

constexpr std::string_view kFormat = "tactus-autosave";
constexpr long long kVersion = 1;

study::RecordId readId(JsonMembers& json, std::string_view key) {
  std::string text;
  json.text(required(key), text);
  const auto id = study::parseRecordId(text);
  if (!id) json.refuse(key, "an id of 32 hexadecimal digits");
  return id.value_or(study::RecordId{});
}

/// The model whose file's text is the member `text`.
fuzzy::ForceModel readModel(JsonMembers& json, const std::string& text) {
  auto model = model_io::parseModel(text, {});
  if (model) return std::move(model->model);
  json.refuse("text", std::move(model.error()));
  return {};
}

ModelVersion readVersion(JsonMembers json) {
  ModelVersion out;
  out.id = readId(json, "id");
  if (json.has("parent")) out.parent = readId(json, "parent");
  json.integer(required("utc_ms"), out.utc_ms);
  json.textOrEmpty(required("author"), out.author);
  json.textOrEmpty(required("label"), out.label);
  json.text(required("sha256"), out.sha256);
  json.text(required("text"), out.text);
  if (const auto sha = base::sha256(out.text); sha != out.sha256) {
    json.refuse("text", "a text with the SHA-256 " + sha, out.sha256, base::ErrorCode::kMismatch);
  }
  readModel(json, out.text);
  json.refuseOthers();
  return out;
}

Autosave read(JsonMembers& json, std::optional<base::Error>& error) {
  Autosave out;
  json.format(kFormat);
  json.version(required("version"));
  json.textOrEmpty(required("document"), out.document);
  for (const JsonValue version : json.elements(required("versions"))) {
    if (!error) out.versions.push_back(readVersion({version, error}));
  }
  if (const auto unfinished = json.object("unfinished")) {
    JsonMembers members(*unfinished, error);
    std::string label, text;
    members.textOrEmpty(required("label"), label);
    members.text(required("text"), text);
    out.unfinished = Autosave::Unfinished{label, readModel(members, text)};
  }
  json.refuseOthers();
  return out;
}

void write(base::JsonWriter& json, const ModelVersion& version) {
  json.beginObject().key("id").value(study::toText(version.id));
  if (version.parent) json.key("parent").value(study::toText(*version.parent));
  json.key("utc_ms").value(static_cast<long long>(version.utc_ms));
  json.key("author").value(version.author).key("label").value(version.label);
  json.key("sha256").value(version.sha256).key("text").value(version.text).endObject();
}

bool isUnfinished(const EditHistory& history) { return history.inGesture() && &history.model() != &history.base(); }

}  // namespace

std::string autosaveText(const EditHistory& history, const std::string& document, EventRange range) {
  const auto& events = history.events();
  const std::size_t last = std::min(range.last, events.size());
  base::JsonWriter json;
  json.beginObject().key("format").value(kFormat).key("version").value(kVersion);
  json.key("document").value(document).key("versions").beginArray();
  for (std::size_t e = range.first; e < last; ++e) {
    if (events[e].stored) continue;
    // A state leaves the memory only once its version is stored.
    if (const auto version = versionOf(history, events[e])) write(json, *version);
  }
  json.endArray();
  if (last == events.size() && isUnfinished(history)) {
    fuzzy::ForceModel model = history.model();
    refreshChecks(model, history.compiled());
    json.key("unfinished").beginObject().key("label").value(history.gestureLabel());
    json.key("text").value(model_io::formatModel(model)).endObject();
  }
  json.endObject();
  return json.text();
}

bool needsAutosave(const EditHistory& history) {
  const auto& events = history.events();
  return isUnfinished(history) || std::any_of(events.rbegin(), events.rend(), [](const Event& event) {
           return !event.stored && event.kind != EventKind::kOpened;
         });
}

Result<Autosave> parseAutosave(std::string_view text, const std::string& file) {
  return base::readJson(text, file, read);
}

std::vector<ModelVersion> lostVersions(const Autosave& autosave, std::span<const ModelVersion> stored) {
  std::vector<ModelVersion> out;
  for (const auto& version : autosave.versions) {
    const bool there =
        std::any_of(stored.begin(), stored.end(), [&](const ModelVersion& other) { return other.id == version.id; });
    if (!there) out.push_back(version);
  }
  return out;
}

Result<EditHistory> recovered(std::span<const ModelVersion> stored, const Autosave& autosave, study::RecordIds ids,
                              const Stamp& stamp) {
  std::vector<ModelVersion> all(stored.begin(), stored.end());
  const auto lost = lostVersions(autosave, stored);
  all.insert(all.end(), lost.begin(), lost.end());
  auto history = historyFrom(all, ids, stored.size());
  if (!history || !autosave.unfinished) return history;
  auto edit = finished(autosave.unfinished->model, autosave.unfinished->label + " (recovered)");
  if (!edit) return tl::unexpected(std::move(edit.error()));
  history->apply(std::move(*edit), stamp);
  return history;
}

}  // namespace tactus::editing
