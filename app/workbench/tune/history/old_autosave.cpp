#include "app/workbench/tune/history/old_autosave.h"

#include <QDir>
#include <QFileInfo>
#include <QLockFile>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "core/base/files/file.h"
#include "core/base/files/sha256.h"
#include "core/base/json/json_members.h"
#include "core/model_io/model_file.h"

namespace tactus::workbench {
namespace {

using base::JsonMembers;
using base::JsonValue;
using base::required;
using study::ModelVersion;

constexpr std::size_t kMostPartBytes = std::size_t{256} << 20U;
constexpr auto kLockName = "lock";
constexpr auto kFactsName = "facts.json";

// A lock ends with its process, however old it is.
std::unique_ptr<QLockFile> lockOf(const QString& folder) {
  auto lock = std::make_unique<QLockFile>(QDir(folder).filePath(QLatin1String(kLockName)));
  lock->setStaleLockTime(0);
  return lock;
}

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

KeptWork readPart(JsonMembers& json, std::optional<base::Error>& error) {
  KeptWork out;
  std::string document;
  json.format("tactus-autosave");
  json.version(required("version"));
  json.textOrEmpty(required("document"), document);
  out.document = text(document);
  for (const JsonValue version : json.elements(required("versions"))) {
    if (!error) out.kept.versions.push_back(readVersion({version, error}));
  }
  if (const auto unfinished = json.object("unfinished")) {
    JsonMembers members(*unfinished, error);
    std::string label, model;
    members.textOrEmpty(required("label"), label);
    members.text(required("text"), model);
    out.kept.unfinished = editing::Unfinished{label, readModel(members, model)};
  }
  json.refuseOthers();
  return out;
}

OldAutosave readFacts(const QString& folder) {
  OldAutosave out;
  out.folder = folder;
  const QString path = QDir(folder).filePath(QLatin1String(kFactsName));
  out.last = QFileInfo(path).lastModified();
  const auto bytes = base::readFile(path.toStdString(), kMostPartBytes);
  if (!bytes) return out;
  (void)base::readJson(*bytes, {}, [&](JsonMembers& json, auto&) {
    std::string document;
    json.textOrEmpty("document", document);
    json.integer("edits", out.edits);
    out.document = text(document);
    return true;
  });
  return out;
}

}  // namespace

std::vector<OldAutosave> oldAutosaves(const QString& root) {
  std::vector<OldAutosave> out;
  for (const QFileInfo& entry : QDir(root).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    const QString folder = entry.absoluteFilePath();
    const auto lock = lockOf(folder);
    if (!QFileInfo::exists(QDir(folder).filePath(QLatin1String(kFactsName))) || !lock->tryLock(0)) continue;
    out.push_back(readFacts(folder));
  }
  return out;
}

TakenAutosave::TakenAutosave(QString folder, std::unique_ptr<QLockFile> lock)
    : folder_(std::move(folder)), lock_(std::move(lock)) {}

TakenAutosave::~TakenAutosave() = default;

base::Result<std::unique_ptr<TakenAutosave>> TakenAutosave::take(const QString& folder) {
  auto lock = lockOf(folder);
  if (!QFileInfo::exists(folder) || !lock->tryLock(0)) {
    return base::fail(base::ErrorCode::kIo, folder.toStdString(), "work that another window has taken",
                      "work that no window has taken");
  }
  return std::unique_ptr<TakenAutosave>(new TakenAutosave(folder, std::move(lock)));
}

base::Result<KeptWork> TakenAutosave::read() const {
  KeptWork out;
  for (const QString& name : QDir(folder_).entryList({QStringLiteral("part-*.json")}, QDir::Files, QDir::Name)) {
    const std::string path = QDir(folder_).filePath(name).toStdString();
    const auto bytes = base::readFile(path, kMostPartBytes);
    if (!bytes) return tl::unexpected(bytes.error());
    auto part = base::readJson(*bytes, path, readPart);
    if (!part) return part;
    out.document = std::move(part->document);
    for (auto& version : part->kept.versions) out.kept.versions.push_back(std::move(version));
    out.kept.unfinished = std::move(part->kept.unfinished);
  }
  if (out.kept.versions.empty() && !out.kept.unfinished) {
    return base::fail(base::ErrorCode::kData, folder_.toStdString(), "no edits", "the edits of a crash");
  }
  return out;
}

// Emptied while it is locked: another program takes the lock as soon as it is free.
void TakenAutosave::discard() {
  QDir folder(folder_);
  for (const QString& name : folder.entryList(QDir::Files | QDir::Hidden | QDir::System)) {
    if (name != QLatin1String(kLockName)) folder.remove(name);
  }
  lock_->unlock();
  QDir().rmdir(folder_);
}

}  // namespace tactus::workbench
