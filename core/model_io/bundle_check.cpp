#include "core/model_io/bundle_check.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/base/files/checksums.h"
#include "core/base/files/file.h"
#include "core/base/json/json_members.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/model_io/model_file.h"

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

std::string fingerprintText(std::string_view sha256) {
  constexpr std::size_t kGroup = 16;
  std::string out;
  for (std::size_t at = 0; at < sha256.size(); at += kGroup)
    out += (at > 0 ? " " : "") + std::string(sha256.substr(at, kGroup));
  return out;
}

namespace {
constexpr std::string_view kApprovalsFormat = "tactus-approvals";
}

std::string formatApprovals(const std::vector<Approval>& approvals) {
  base::JsonWriter json;
  json.beginObject().key("format").value(kApprovalsFormat).key("version").value(1).key("approvals").beginArray();
  for (const Approval& one : approvals) {
    json.beginObject().key("author").value(one.author).key("utc").value(one.utc).key("text").value(one.text);
    json.endObject();
  }
  return json.endArray().endObject().text();
}

namespace {

base::Result<std::vector<Approval>> parseApprovals(std::string_view text, const std::string& file) {
  return base::readJson(text, file, [](JsonMembers& members, std::optional<base::Error>& error) {
    members.format(kApprovalsFormat);
    members.version(required("version"));
    std::vector<Approval> out;
    for (const base::JsonValue value : members.elements(required("approvals"))) {
      JsonMembers one(value, error);
      Approval& approval = out.emplace_back();
      one.textOrEmpty(required("author"), approval.author);
      one.textOrEmpty(required("utc"), approval.utc);
      one.text(required("text"), approval.text);
    }
    return out;
  });
}

constexpr std::size_t kMostManifestBytes = std::size_t{4} << 20U;
constexpr std::size_t kMostFileBytes = std::size_t{256} << 20U;
constexpr std::size_t kMostSignatureBytes = std::size_t{64} << 10U;

FileCheck failed(FileCheck check, std::string sentence) {
  check.ok = false;
  check.wrong = std::move(sentence);
  return check;
}

/// A link may lead to another file tomorrow.
base::Result<void> requireNoLink(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_symlink(path, ignored)) return {};
  return tl::unexpected(
      base::Error{base::ErrorCode::kMismatch, path, {}, "a link", "the file itself, as it was written"});
}

/// What lies in the folder without being named by the manifest, each a failure, in the order of their paths.
std::vector<FileCheck> unnamedIn(const std::string& folder, const BundleManifest& manifest) {
  std::set<std::string> named = {std::string(kManifestName), std::string(kSignatureName)};
  for (const BundleFile& file : manifest.files) named.insert(file.path);
  std::vector<FileCheck> out;
  std::error_code problem;
  for (std::filesystem::recursive_directory_iterator at(folder, problem), end; !problem && at != end;
       at.increment(problem)) {
    if (at->is_directory(problem) && !at->is_symlink(problem)) continue;
    FileCheck check;
    check.file.path = at->path().lexically_relative(folder).generic_string();
    check.file.kind = "unnamed";
    if (named.contains(check.file.path)) continue;
    out.push_back(failed(std::move(check),
                         folder + "/" + at->path().lexically_relative(folder).generic_string() +
                             ": found a file that the manifest does not name, wanted only those that it names"));
  }
  std::sort(out.begin(), out.end(), [](const FileCheck& a, const FileCheck& b) { return a.file.path < b.file.path; });
  return out;
}

/// The bytes of a file of the bundle, which must be those that the manifest means.
base::Result<std::string> unaltered(const std::string& folder, const BundleFile& file) {
  const std::string path = folder + "/" + file.path;
  if (const auto itself = requireNoLink(path); !itself) return tl::unexpected(itself.error());
  if (const auto below = base::requireBelow(folder, path); !below) return tl::unexpected(below.error());
  auto bytes = base::readFile(path, kMostFileBytes);
  if (!bytes) return bytes;
  if (base::sha256(*bytes) == file.sha256) return bytes;
  return tl::unexpected(base::Error{
      base::ErrorCode::kMismatch, path, {}, "another SHA-256 than the manifest's", "the file as it was written"});
}

/// Takes what it learns into `approvals`.
FileCheck checked(const fuzzy::ForceModel& model, const std::string& folder, const BundleFile& file,
                  std::vector<Approval>& approvals) {
  FileCheck check{file, true, false, file.promise ? file.promise->largest_error_n : 0, {}};
  auto bytes = unaltered(folder, file);
  if (!bytes) return failed(check, bytes.error().message());
  const std::string path = folder + "/" + file.path;
  const bool tube = file.kind == "tube-checks";
  if (tube || file.kind == "checks") {
    const auto error = (tube ? errorOfTubeChecks : errorOfChecks)(model, std::move(*bytes), path);
    if (!error) return failed(check, error.error().message());
    check.evaluated = true;
    check.largest_error_n = error->largest_n;
  }
  if (file.kind == "approvals") {
    const auto read = parseApprovals(*bytes, path);
    if (!read) return failed(check, read.error().message());
    approvals = *read;
  }
  if (!file.promise || check.largest_error_n <= file.promise->tolerance_n) return check;
  const std::string found = "an error of " + base::formatNumber(check.largest_error_n) + " N";
  return failed(check,
                path + ": found " + found + ", wanted at most " + base::formatNumber(file.promise->tolerance_n) + " N");
}

}  // namespace

bool BundleCheck::ok() const {
  return std::all_of(files.begin(), files.end(), [](const FileCheck& file) { return file.ok; });
}

base::Result<BundleCheck> checkBundle(const std::string& folder) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored)) {
    const bool is_there = std::filesystem::exists(folder, ignored);
    return tl::unexpected(base::Error{
        base::ErrorCode::kIo, folder, {}, is_there ? "a file" : "nothing of this name", "the folder of a bundle"});
  }
  const std::string path = folder + "/" + std::string(kManifestName);
  if (const auto itself = requireNoLink(path); !itself) return tl::unexpected(itself.error());
  TACTUS_TRY(const auto text, base::readFile(path, kMostManifestBytes));
  TACTUS_TRY(const auto manifest, parseManifest(text, path));
  BundleCheck out;
  const auto own = std::find_if(manifest.files.begin(), manifest.files.end(),
                                [&](const BundleFile& one) { return one.path == manifest.model; });
  const auto bytes = unaltered(folder, *own);
  if (!bytes) {
    // Missing or altered: nothing can be evaluated, and the bundle is not what it says.
    base::Error error = bytes.error();
    error.code = base::ErrorCode::kMismatch;
    return tl::unexpected(error);
  }
  TACTUS_TRY(auto read, parseModel(*bytes, folder + "/" + manifest.model));
  out.model = std::move(read.model);
  out.generator = manifest.generator;
  out.model_sha256 = own->sha256;
  out.manifest = text;
  out.fingerprint = base::sha256(text);
  for (const BundleFile& file : manifest.files) out.files.push_back(checked(out.model, folder, file, out.approvals));
  if (const std::string name = folder + "/" + std::string(kSignatureName);
      std::filesystem::exists(std::filesystem::symlink_status(name, ignored))) {
    if (const auto itself = requireNoLink(name); !itself) return tl::unexpected(itself.error());
    TACTUS_TRY(out.signature, base::readFile(name, kMostSignatureBytes));
  }
  for (FileCheck& check : unnamedIn(folder, manifest)) out.files.push_back(std::move(check));
  return out;
}

}  // namespace tactus::model_io
