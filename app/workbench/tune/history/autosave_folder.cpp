#include "app/workbench/tune/history/autosave_folder.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>
#include <QStandardPaths>
#include <QUuid>
#include <algorithm>
#include <numeric>
#include <utility>

#include "core/base/files/file.h"

namespace tactus::workbench {
namespace {

constexpr std::size_t kVersionsPerPart = 50;
// A part is written again with every edit until it is closed: this much takes a tenth of a second.
constexpr std::size_t kMostOpenBytes = std::size_t{8} << 20U;
constexpr std::size_t kMostPartBytes = editing::kMostAutosaveBytes / 4;
constexpr auto kLockName = "lock";
constexpr auto kFactsName = "facts.json";
constexpr std::size_t kMostFactsBytes = 1 << 16;

QString partName(std::size_t number) { return QStringLiteral("part-%1.json").arg(number, 5, 10, QLatin1Char('0')); }

// A lock ends with its process, however old it is.
std::unique_ptr<QLockFile> lockOf(const QString& folder) {
  auto lock = std::make_unique<QLockFile>(QDir(folder).filePath(QLatin1String(kLockName)));
  lock->setStaleLockTime(0);
  return lock;
}

// Emptied while it is locked: whoever looks for lost work takes the lock as soon as it is free.
void removeLocked(const QString& path, QLockFile& lock) {
  QDir folder(path);
  for (const QString& name : folder.entryList(QDir::Files | QDir::Hidden | QDir::System)) {
    if (name != QLatin1String(kLockName)) folder.remove(name);
  }
  lock.unlock();
  QDir().rmdir(path);
}

int editsOf(const editing::EditHistory& history) {
  const auto& events = history.events();
  const auto edits = std::count_if(events.begin(), events.end(), [](const editing::Event& event) {
    return !event.stored && event.kind == editing::EventKind::kEdit;
  });
  return static_cast<int>(edits) + (history.gestureLabel().empty() ? 0 : 1);
}

std::string pathIn(const QString& folder, const QString& name) { return QDir(folder).filePath(name).toStdString(); }

base::Result<void> writeFacts(const QString& folder, const editing::EditHistory& history,
                              const AutosaveFolder::Facts& facts) {
  const QJsonObject object{{QStringLiteral("document"), facts.document},
                           {QStringLiteral("edits"), editsOf(history)},
                           {QStringLiteral("saved"), facts.saved}};
  return base::writeFileAtomically(pathIn(folder, QLatin1String(kFactsName)),
                                   QJsonDocument(object).toJson().toStdString());
}

LostWork readFacts(const QString& folder) {
  LostWork out;
  out.folder = folder;
  const auto bytes = base::readFile(pathIn(folder, QLatin1String(kFactsName)), kMostFactsBytes);
  if (!bytes) return out;
  const QJsonObject facts = QJsonDocument::fromJson(QByteArray::fromStdString(*bytes)).object();
  out.document = facts[QStringLiteral("document")].toString();
  out.edits = facts[QStringLiteral("edits")].toInt();
  out.saved = facts[QStringLiteral("saved")].toBool();
  out.last = QFileInfo(QDir(folder).filePath(QLatin1String(kFactsName))).lastModified();
  return out;
}

}  // namespace

QString autosaveRoot() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)).filePath(QStringLiteral("autosave"));
}

AutosaveFolder::AutosaveFolder(QString root) : root_(std::move(root)) {}

AutosaveFolder::~AutosaveFolder() = default;

base::Result<void> AutosaveFolder::begin() {
  const QString path = QDir(root_).filePath(QUuid::createUuid().toString(QUuid::Id128));
  if (auto made = base::makeFolder(path.toStdString(), base::FolderMode::kPrivate); !made) return made;
  auto lock = lockOf(path);
  if (!lock->tryLock(0)) {
    return base::fail(base::ErrorCode::kIo, path.toStdString(), "a folder that cannot be locked",
                      "one of this process");
  }
  path_ = path;
  lock_ = std::move(lock);
  closed_parts_ = closed_events_ = 0;
  return {};
}

base::Result<void> AutosaveFolder::write(const editing::EditHistory& history, const Facts& facts) {
  if (path_.isEmpty()) {
    if (auto begun = begin(); !begun) return begun;
  }
  const std::string document = facts.document.toStdString();
  const std::size_t count = history.events().size();
  for (bool done = false; !done;) {
    std::size_t end = std::min(count, closed_events_ + kVersionsPerPart);
    std::string text = editing::autosaveText(history, document, {closed_events_, end});
    while (text.size() > kMostPartBytes && end > closed_events_ + 1) {
      end = std::midpoint(closed_events_, end);
      text = editing::autosaveText(history, document, {closed_events_, end});
    }
    const auto written = base::writeFileAtomically(pathIn(path_, partName(closed_parts_)), text);
    if (!written) return written;
    const bool stays_open = text.size() <= kMostOpenBytes || end == closed_events_;
    done = end == count;
    if (done && stays_open) break;
    ++closed_parts_;
    closed_events_ = end;
  }
  return writeFacts(path_, history, facts);
}

void AutosaveFolder::remove() {
  if (path_.isEmpty()) return;
  removeLocked(path_, *lock_);
  lock_.reset();
  path_.clear();
  closed_parts_ = closed_events_ = 0;
}

std::vector<LostWork> lostWork(const QString& root) {
  std::vector<LostWork> out;
  for (const QFileInfo& entry : QDir(root).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    const QString folder = entry.absoluteFilePath();
    const auto lock = lockOf(folder);
    if (!lock->tryLock(0)) continue;
    LostWork work = readFacts(folder);
    // A process that ended before its first text was whole left nothing.
    if (!work.document.isEmpty()) out.push_back(std::move(work));
  }
  std::sort(out.begin(), out.end(), [](const LostWork& a, const LostWork& b) { return a.last > b.last; });
  return out;
}

TakenWork::TakenWork(QString folder, std::unique_ptr<QLockFile> lock)
    : folder_(std::move(folder)), lock_(std::move(lock)) {}

TakenWork::~TakenWork() = default;

base::Result<std::unique_ptr<TakenWork>> TakenWork::take(const LostWork& work) {
  auto lock = lockOf(work.folder);
  if (!QFileInfo::exists(work.folder) || !lock->tryLock(0)) {
    return base::fail(base::ErrorCode::kIo, work.folder.toStdString(), "work that another window has taken",
                      "work that nobody has taken");
  }
  return std::unique_ptr<TakenWork>(new TakenWork(work.folder, std::move(lock)));
}

base::Result<editing::Autosave> TakenWork::read() const {
  editing::Autosave out;
  const QStringList parts = QDir(folder_).entryList({QStringLiteral("part-*.json")}, QDir::Files, QDir::Name);
  for (const QString& name : parts) {
    const std::string path = pathIn(folder_, name);
    const auto bytes = base::readFile(path, editing::kMostAutosaveBytes);
    if (!bytes) return tl::unexpected(bytes.error());
    auto part = editing::parseAutosave(*bytes, path);
    if (!part) return tl::unexpected(part.error());
    out.document = std::move(part->document);
    for (auto& version : part->versions) out.versions.push_back(std::move(version));
    out.unfinished = std::move(part->unfinished);
  }
  if (out.versions.empty() && !out.unfinished) {
    return base::fail(base::ErrorCode::kData, folder_.toStdString(), "no edits", "the edits of a crash");
  }
  return out;
}

void TakenWork::discard() { removeLocked(folder_, *lock_); }

}  // namespace tactus::workbench
