#include "core/model_io/bundle_manifest.h"

#include <algorithm>
#include <limits>
#include <set>

#include "core/base/json/json_members.h"
#include "core/base/json/json_writer.h"

namespace tactus::model_io {
namespace {

using base::JsonMembers;
using base::required;

constexpr std::string_view kFormat = "tactus-bundle";
constexpr base::NumberRange kNotNegative{0, std::numeric_limits<double>::max()};

/// Relative, without `.`, `..`, empty parts and backslashes.
bool staysInside(std::string_view path) {
  if (path.empty() || path.find('\\') != std::string_view::npos) return false;
  for (std::size_t at = 0; at <= path.size();) {
    const std::size_t end = std::min(path.find('/', at), path.size());
    const std::string_view part = path.substr(at, end - at);
    if (part.empty() || part == "." || part == "..") return false;
    at = end + 1;
  }
  return true;
}

void wantInside(JsonMembers& members, std::string_view key, const std::string& path) {
  if (!staysInside(path)) members.refuse(key, "a path inside the folder of the bundle, with / between its parts");
}

BundleFile fileOf(base::JsonValue value, std::optional<base::Error>& error) {
  JsonMembers members(value, error);
  BundleFile file;
  members.text(required("path"), file.path);
  wantInside(members, "path", file.path);
  members.text(required("sha256"), file.sha256);
  members.text(required("kind"), file.kind);
  members.text("expert", file.expert);
  if (members.has("rule")) {
    Promise promise;
    members.text(required("rule"), promise.rule);
    members.number(required("tolerance_n"), promise.tolerance_n, kNotNegative);
    members.number(required("largest_error_n"), promise.largest_error_n, kNotNegative);
    members.numbers(required("at"), promise.at);
    members.flag("measured", promise.measured);
    file.promise = std::move(promise);
  }
  return file;
}

}  // namespace

base::Result<BundleManifest> parseManifest(std::string_view text, const std::string& file) {
  const auto document = base::JsonDocument::parse(text);
  if (!document) return base::inFile(document.error(), file);
  std::optional<base::Error> error;
  JsonMembers members(document->root(), error);
  BundleManifest manifest;
  members.format(kFormat);
  members.version(required("version"));
  members.text(required("model"), manifest.model);
  wantInside(members, "model", manifest.model);
  members.textOrEmpty("created_utc", manifest.created_utc);
  members.textOrEmpty("generator", manifest.generator);
  std::set<std::string> paths;
  for (const base::JsonValue value : members.elements(required("files"))) {
    manifest.files.push_back(fileOf(value, error));
    if (!paths.insert(manifest.files.back().path).second)
      members.refuse("files", "the path " + base::quoted(manifest.files.back().path) + " twice", "each file once");
  }
  if (!error && !paths.contains(manifest.model)) members.refuse("model", "the path of one of the files");
  if (error) return base::inFile(std::move(*error), file);
  return manifest;
}

std::string formatManifest(const BundleManifest& manifest) {
  base::JsonWriter json;
  json.beginObject().key("format").value(kFormat).key("version").value(1);
  json.key("model").value(manifest.model).key("created_utc").value(manifest.created_utc);
  json.key("generator").value(manifest.generator).key("files").beginArray();
  for (const BundleFile& file : manifest.files) {
    json.beginObject().key("path").value(file.path).key("sha256").value(file.sha256).key("kind").value(file.kind);
    if (!file.expert.empty()) json.key("expert").value(file.expert);
    if (file.promise) {
      json.key("rule").value(file.promise->rule).key("tolerance_n").value(file.promise->tolerance_n);
      json.key("largest_error_n").value(file.promise->largest_error_n).key("at").values(file.promise->at);
      if (!file.promise->measured) json.key("measured").value(false);
    }
    json.endObject();
  }
  return json.endArray().endObject().text();
}

}  // namespace tactus::model_io
