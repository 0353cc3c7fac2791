#include "app/workbench/tune/history/history_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>
#include <chrono>
#include <utility>

#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "core/base/error.h"
#include "core/base/files/checksums.h"
#include "core/base/files/file.h"
#include "core/store/batch.h"
#include "core/store/model_versions.h"
#include "core/store/study_info.h"

namespace tactus::workbench {
namespace {

using base::Result;
using study::ModelVersion;

constexpr int kMostWindows = 9;  // that keep a history of one document at the same time
constexpr auto kEnding = ".tactus";
constexpr auto kJournalEnding = "-wal";
// The newest versions are read up to this; a history beyond it stays whole in its file, which opens as a study.
constexpr std::size_t kMostBytes = std::size_t{64} << 20U;

/// `s4-1a2b3c4d5e6f.tactus`, and `s4-1a2b3c4d5e6f-2.tactus` for a second window.
QString fileName(const QString& document, int number) {
  const QString stem = QFileInfo(document).fileName().section(QLatin1Char('.'), 0, 0).left(40);
  const QString place = text(base::sha256(document.toStdString())).left(12);
  const QString window = number == 1 ? QString() : QStringLiteral("-%1").arg(number);
  return stem + QLatin1Char('-') + place + window + QLatin1String(kEnding);
}

Result<std::vector<ModelVersion>> newestVersions(const store::StudyFile& file) {
  auto versions = store::modelVersions(file);
  if (!versions) return versions;
  std::size_t bytes = 0;
  auto first = versions->end();
  while (first != versions->begin() && bytes < kMostBytes) {
    --first;
    TACTUS_TRY(auto whole, store::modelVersion(file, first->id));
    bytes += whole.text.size();
    *first = std::move(whole);
  }
  versions->erase(versions->begin(), first);
  return versions;
}

Result<KeptWork> readWork(const store::StudyFile& file, bool with_texts) {
  KeptWork out;
  TACTUS_TRY(const auto info, store::studyInfo(file));
  out.document = text(info.name);
  TACTUS_TRY(auto versions, with_texts ? newestVersions(file) : store::modelVersions(file));
  if (!with_texts) {
    out.kept.versions = std::move(versions);
    return out;
  }
  auto kept = editing::withoutDrags(std::move(versions));
  if (!kept) return base::inFile(std::move(kept.error()), file.path());
  out.kept = std::move(*kept);
  return out;
}

/// What an upgrade leaves beside a history (core/store/migrations.h).
constexpr auto kBeforeUpgrade = ".before-v";

void removeFiles(const QString& path) {
  for (const char* ending : {"", kJournalEnding, "-shm", "-journal"}) QFile::remove(path + QLatin1String(ending));
  const QFileInfo file(path);
  for (const QString& copy : file.dir().entryList({file.fileName() + QLatin1String(kBeforeUpgrade) + QLatin1Char('*')}))
    QFile::remove(file.dir().filePath(copy));
}

std::int64_t utcNowMs() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

}  // namespace

QString autosaveRoot() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)).filePath(QStringLiteral("autosave"));
}

Result<std::optional<KeptWork>> HistoryFile::open(const QString& document, const std::string& model_sha256) {
  close();
  if (auto opened = openFile(document, IfAbsent::kLeave); !opened) return tl::unexpected(opened.error());
  if (!file_) absorbMoved(document, model_sha256);
  if (!file_) return std::nullopt;
  const bool merged = absorbSideFiles();
  auto work = readWork(*file_, true);
  if (work) work->merged = merged;
  if (!work) return tl::unexpected(std::move(work.error()));
  if (work->kept.versions.empty()) return std::nullopt;
  return std::optional(std::move(*work));
}

// A file that another window has open, or that is damaged, stays as it is; the next number is taken.
Result<void> HistoryFile::openFile(const QString& document, IfAbsent absent, Place place) {
  document_ = document;
  base::Error last =
      base::fail(base::ErrorCode::kLimit, root_.toStdString(), "too many histories of one document", "fewer windows")
          .value();
  for (int number = 1; number <= kMostWindows; ++number) {
    const QString path = QDir(root_).filePath(fileName(document, number));
    if (QFileInfo::exists(path)) {
      if (place == Place::kNewFile) continue;
      auto file = store::StudyFile::open(path.toStdString());
      if (file) return adoptFile(std::move(*file), path);
      last = std::move(file.error());
      continue;
    }
    if (absent == IfAbsent::kLeave) {
      const bool damaged = last.code != base::ErrorCode::kIo && last.code != base::ErrorCode::kLimit;
      return damaged ? Result<void>(tl::unexpected(std::move(last))) : Result<void>();
    }
    if (auto made = base::makeFolder(root_.toStdString(), base::FolderMode::kPrivate); !made) return made;
    TACTUS_TRY(auto file, store::StudyFile::create(path.toStdString(), {ids_.next(), document.toStdString(), utcNowMs(),
                                                                        std::string(kGenerator)}));
    return adoptFile(std::move(file), path);
  }
  return tl::unexpected(std::move(last));
}

Result<void> HistoryFile::adoptFile(store::StudyFile file, const QString& path) {
  TACTUS_TRY(auto versions, store::modelVersions(file));
  file_ = std::move(file);
  path_ = path;
  for (const ModelVersion& version : versions) there_.insert(version.id);
  if (!versions.empty() && editing::isDrag(versions.back())) drag_sha256_ = versions.back().sha256;
  return {};
}

Result<void> HistoryFile::append(std::vector<ModelVersion> versions) {
  std::set<study::RecordId> added;
  for (ModelVersion& version : versions) {
    const bool knows_parent = version.parent && (there_.contains(*version.parent) || added.contains(*version.parent));
    if (!knows_parent) version.parent.reset();
    added.insert(version.id);
  }
  const auto done = store::inOneBatch(*file_, [&]() -> Result<void> {
    for (const ModelVersion& version : versions) {
      if (auto stored = store::append(*file_, version); !stored) return stored;
    }
    return {};
  });
  if (!done || versions.empty()) return done;
  there_.merge(added);
  drag_sha256_ = editing::isDrag(versions.back()) ? versions.back().sha256 : std::string();
  return {};
}

Result<void> HistoryFile::absorb(const QString& path) {
  TACTUS_TRY(auto file, store::StudyFile::open(path.toStdString()));
  TACTUS_TRY(auto listed, store::modelVersions(file));
  std::vector<ModelVersion> versions;
  for (const ModelVersion& one : listed) {
    if (there_.contains(one.id) || editing::isDrag(one)) continue;
    TACTUS_TRY(auto whole, store::modelVersion(file, one.id));
    versions.push_back(std::move(whole));
  }
  if (auto appended = append(std::move(versions)); !appended) return appended;
  if (auto closed = file.close(); !closed) return closed;
  removeFiles(path);
  return {};
}

bool HistoryFile::absorbSideFiles() {
  bool any = false;
  for (int number = 1; number <= kMostWindows; ++number) {
    const QString path = QDir(root_).filePath(fileName(document_, number));
    // What cannot be read now stays for the next time.
    if (path != path_ && QFileInfo::exists(path)) any = absorb(path).has_value() || any;
  }
  return any;
}

void HistoryFile::absorbMoved(const QString& document, const std::string& model_sha256) {
  const QDir folder(root_);
  for (const QString& name : folder.entryList({QLatin1Char('*') + QLatin1String(kEnding)}, QDir::Files)) {
    const QString path = folder.filePath(name);
    const auto work = read(path, false);
    if (!work || work->kept.versions.empty() || QFileInfo::exists(work->document)) continue;
    if (work->kept.versions.back().sha256 != model_sha256) continue;
    if (!openFile(document, IfAbsent::kCreate)) return;
    (void)absorb(path);
    return;
  }
}

Result<void> HistoryFile::write(const editing::EditHistory& history, const QString& document, Place place,
                                std::int64_t utc_ms) {
  if (document != document_) close();
  if (!file_) {
    if (auto opened = openFile(document, IfAbsent::kCreate, place); !opened) return opened;
  }
  std::vector<ModelVersion> versions;
  for (const editing::Event& event : history.events()) {
    if (event.stored || there_.contains(event.id)) continue;
    // A state leaves the memory only once its version is stored.
    if (auto version = editing::versionOf(history, event)) versions.push_back(std::move(*version));
  }
  const bool dragging = history.inGesture() && &history.model() != &history.base();
  if (dragging || (!drag_sha256_.empty() && versions.empty())) {
    ModelVersion drag = editing::dragVersion(history, ids_, utc_ms);
    if (!versions.empty() || drag.sha256 != drag_sha256_) versions.push_back(std::move(drag));
  }
  return versions.empty() ? Result<void>() : append(std::move(versions));
}

void HistoryFile::close() {
  if (file_) (void)file_->close();  // where the disk refuses, the journal keeps what the file lacks
  file_.reset();
  path_.clear();
  document_.clear();
  there_.clear();
  drag_sha256_.clear();
}

void HistoryFile::remove() {
  const QString path = path_;
  close();
  if (!path.isEmpty()) removeFiles(path);
}

QString HistoryFile::setAside() {
  const QString path = path_;
  close();
  const QString stem = path.chopped(static_cast<qsizetype>(qstrlen(kEnding)));
  QString other;
  for (int number = 1; other.isEmpty() || QFileInfo::exists(other); ++number) {
    other = stem + QStringLiteral("-before-%1").arg(number) + QLatin1String(kEnding);
  }
  return QFile::rename(path, other) ? other : path;
}

QStringList HistoryFile::leftByCrash(const QString& root) {
  QStringList out;
  const QDir folder(root);
  const QString journals = QLatin1Char('*') + QLatin1String(kEnding) + QLatin1String(kJournalEnding);
  for (const QString& name : folder.entryList({journals}, QDir::Files, QDir::Time)) {
    out.append(folder.filePath(name.chopped(static_cast<qsizetype>(qstrlen(kJournalEnding)))));
  }
  return out;
}

void HistoryFile::makeRoom(const QString& root, qint64 most_bytes) {
  // Copies of histories that are gone.
  const QString copies = QLatin1Char('*') + QLatin1String(kEnding) + QLatin1String(kBeforeUpgrade) + QLatin1Char('*');
  for (const QFileInfo& copy : QDir(root).entryInfoList({copies}, QDir::Files)) {
    const QString path = copy.filePath();
    if (!QFileInfo::exists(path.left(path.lastIndexOf(QLatin1String(kBeforeUpgrade))))) QFile::remove(path);
  }
  const QFileInfoList newest_first =
      QDir(root).entryInfoList({QLatin1Char('*') + QLatin1String(kEnding)}, QDir::Files, QDir::Time);
  qint64 bytes = 0;
  for (const QFileInfo& one : newest_first) {
    bytes += one.size();
    const QString path = one.filePath();
    if (bytes <= most_bytes || QFileInfo::exists(path + QLatin1String(kJournalEnding))) continue;
    if (!store::StudyFile::open(path.toStdString())) continue;  // another program has it, or it is not a history
    removeFiles(path);
    bytes -= one.size();
  }
}

Result<KeptWork> HistoryFile::read(const QString& path, bool with_texts) {
  TACTUS_TRY(const auto file, store::StudyFile::open(path.toStdString(), {store::Access::kReadOnly}));
  return readWork(file, with_texts);
}

Result<void> HistoryFile::settle(const QString& path, const std::string& sha256, const editing::Stamp& stamp) {
  TACTUS_TRY(auto file, store::StudyFile::open(path.toStdString()));
  TACTUS_TRY(const auto versions, store::modelVersions(file));
  const auto same = std::find_if(versions.rbegin(), versions.rend(), [&](const ModelVersion& version) {
    return version.sha256 == sha256 && !editing::isDrag(version);
  });
  if (same != versions.rend()) {
    TACTUS_TRY(auto version, store::modelVersion(file, same->id));
    study::RecordIds ids;
    version.parent = std::exchange(version.id, ids.next());
    version.utc_ms = stamp.utc_ms;
    version.author = stamp.author;
    const auto colon = version.label.find(": ");
    const std::string subject = colon == std::string::npos ? version.label : version.label.substr(colon + 2);
    version.label = std::string(editing::name(editing::EventKind::kReturn)) + ": " + subject;
    if (auto stored = store::append(file, version); !stored) return stored;
  }
  return file.close();
}

void HistoryFile::discard(const QString& path) { removeFiles(path); }

}  // namespace tactus::workbench
