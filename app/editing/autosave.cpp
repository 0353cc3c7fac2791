#include "app/editing/autosave.h"

#include <algorithm>
#include <utility>

#include "core/base/files/sha256.h"
#include "core/base/json/json_document.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/model_io/model_file.h"

namespace tactus::editing {
namespace {

using base::ErrorCode;
using base::fail;
using base::JsonKind;
using base::JsonValue;
using base::Result;
using study::ModelVersion;

constexpr std::string_view kFormat = "tactus-autosave";
constexpr long long kVersion = 1;

Result<std::string> text(const JsonValue& object, std::string_view key) {
  const auto value = object.kind() == JsonKind::kObject ? object.find(key) : std::nullopt;
  if (value && value->kind() == JsonKind::kString) return std::string(value->text());
  return fail(ErrorCode::kSchema, object.pointer(), value ? value->description() : "nothing",
              "a string under " + base::quoted(key));
}

Result<study::RecordId> id(const JsonValue& object, std::string_view key) {
  const auto found = text(object, key);
  if (!found) return tl::unexpected(found.error());
  if (const auto parsed = study::parseRecordId(*found)) return *parsed;
  return fail(ErrorCode::kValue, object.pointer(), base::quoted(*found), "an id of 32 hexadecimal digits");
}

Result<long long> integer(const JsonValue& object, std::string_view key) {
  const auto value = object.kind() == JsonKind::kObject ? object.find(key) : std::nullopt;
  if (value && value->kind() == JsonKind::kNumber) {
    if (const auto parsed = base::parseInteger(value->text())) return *parsed;
  }
  return fail(ErrorCode::kSchema, object.pointer(), value ? value->description() : "nothing",
              "a whole number under " + base::quoted(key));
}

Result<ModelVersion> readVersion(const JsonValue& object) {
  ModelVersion out;
  const auto own = id(object, "id");
  if (!own) return tl::unexpected(own.error());
  out.id = *own;
  if (object.find("parent")) {
    const auto parent = id(object, "parent");
    if (!parent) return tl::unexpected(parent.error());
    out.parent = *parent;
  }
  const auto utc_ms = integer(object, "utc_ms");
  if (!utc_ms) return tl::unexpected(utc_ms.error());
  out.utc_ms = *utc_ms;
  for (const auto& [key, target] : {std::pair{"author", &out.author}, std::pair{"label", &out.label},
                                    std::pair{"sha256", &out.sha256}, std::pair{"text", &out.text}}) {
    auto found = text(object, key);
    if (!found) return tl::unexpected(found.error());
    *target = std::move(*found);
  }
  if (const auto sha = base::sha256(out.text); sha != out.sha256) {
    return fail(ErrorCode::kMismatch, object.pointer(), "a text with the SHA-256 " + sha, out.sha256);
  }
  if (const auto model = model_io::parseModel(out.text, {}); !model) return tl::unexpected(model.error());
  return out;
}

Result<Autosave> read(const JsonValue& root) {
  const auto format = text(root, "format");
  if (!format || *format != kFormat) {
    return fail(ErrorCode::kSchema, "/format", format ? base::quoted(*format) : "nothing", std::string(kFormat));
  }
  const auto version = integer(root, "version");
  if (!version) return tl::unexpected(version.error());
  if (*version != kVersion) {
    return fail(ErrorCode::kVersion, "/version", std::to_string(*version), "version " + std::to_string(kVersion));
  }
  Autosave out;
  auto document = text(root, "document");
  if (!document) return tl::unexpected(document.error());
  out.document = std::move(*document);
  const auto versions = root.find("versions");
  if (!versions || versions->kind() != JsonKind::kArray) {
    return fail(ErrorCode::kSchema, "/versions", versions ? versions->description() : "nothing", "an array");
  }
  for (const JsonValue one : *versions) {
    auto found = readVersion(one);
    if (!found) return tl::unexpected(found.error());
    out.versions.push_back(std::move(*found));
  }
  if (const auto unfinished = root.find("unfinished")) {
    auto label = text(*unfinished, "label");
    if (!label) return tl::unexpected(label.error());
    const auto model_text = text(*unfinished, "text");
    if (!model_text) return tl::unexpected(model_text.error());
    auto model = model_io::parseModel(*model_text, {});
    if (!model) return tl::unexpected(model.error());
    out.unfinished = Autosave::Unfinished{std::move(*label), std::move(model->model)};
  }
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
  const auto document = base::JsonDocument::parse(text);
  if (!document) return base::inFile(document.error(), file);
  auto out = read(document->root());
  if (!out) return base::inFile(std::move(out.error()), file);
  return out;
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
