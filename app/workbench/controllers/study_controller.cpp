#include "app/workbench/controllers/study_controller.h"

#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "app/editing/history_versions.h"
#include "app/version.h"
#include "app/workbench/display_text.h"
#include "core/base/check.h"
#include "core/store/model_versions.h"

namespace tactus::workbench {
namespace {

using base::Result;

constexpr int kSlowMs = 200;    // design: a write that takes longer is shown
constexpr int kRetryMs = 3000;  // a disk that refused is asked again
constexpr std::size_t kTextsAtOnce = 20;
constexpr std::size_t kMostTextBytes = std::size_t{64} << 20U;  // of old versions kept in memory

// Appends one version. One that is there already was written by an attempt whose answer got lost.
Result<void> storeVersion(store::StudyFile& file, const editing::Event& event, const fuzzy::ForceModel& model) {
  const study::ModelVersion version = editing::versionOf(event, model);
  auto stored = store::append(file, version);
  if (stored) return stored;
  const auto there = store::modelVersion(file, version.id);
  if (there && there->sha256 == version.sha256) return {};
  return stored;
}

// `study.tactus.json` beside the study, or the first of `study-2.tactus.json`, … that is not there.
QString unusedModelPath(const QString& study) {
  const QFileInfo info(study);
  const QString stem = info.absolutePath() + QLatin1Char('/') + info.completeBaseName();
  QString path = stem + QStringLiteral(".tactus.json");
  for (int number = 2; QFileInfo::exists(path); ++number) {
    path = stem + QStringLiteral("-%1.tactus.json").arg(number);
  }
  return path;
}

Result<store::StudyFile> makeStudy(const std::string& path, study::RecordIds& ids) {
  const QString name = QFileInfo(text(path)).completeBaseName();
  return store::StudyFile::create(path, {ids.next(), name.toStdString(), utcNowMs(), std::string(kGenerator)});
}

}  // namespace

StudyController::StudyController(ModelController& models, EditController& edits, QObject* parent)
    : QObject(parent), models_(models), edits_(edits) {
  slow_timer_.setSingleShot(true);
  slow_timer_.setInterval(kSlowMs);
  retry_.setSingleShot(true);
  retry_.setInterval(kRetryMs);
  connect(&slow_timer_, &QTimer::timeout, this, [this] {
    slow_ = isBusy();
    emit savedChanged();
  });
  connect(&retry_, &QTimer::timeout, this, &StudyController::storeNow);
  connect(&edits_, &EditController::historyChanged, this, &StudyController::storeEvents);
  connect(&models_, &ModelController::opened, this, &StudyController::savedChanged);
  connect(&models_, &ModelController::storeNow, this, &StudyController::storeNow);
  connect(&models_, &ModelController::reopenFromStudy, this, &StudyController::openModel);
  connect(&models_, &ModelController::copied, this, [this](const QString& copy) {
    emit said(tr("A copy was written to %1; edits go on into %2.").arg(QFileInfo(copy).fileName(), fileName()));
  });
}

StudyController::~StudyController() {
  if (edits_.isOpen()) edits_.commit();
  storeEvents();
  post([](StudyWorker::Desk& desk) { desk.catchUp(); });
}

QString StudyController::fileName() const { return QFileInfo(path_).fileName(); }

bool StudyController::keepsModel() const { return isOpen() && models_.current() && models_.current()->in_study; }

QString StudyController::savedText() const {
  if (!keepsModel()) return {};
  if (!failure().isEmpty()) return tr("● Not stored in %1").arg(fileName());
  return (slow_ ? tr("Saving in %1…") : tr("Stored in %1")).arg(fileName());
}

std::optional<study::RecordId> StudyController::modelVersion() const {
  // While versions are compared, another one than the open one is looked at.
  if (!keepsModel() || models_.shown() != models_.current()) return std::nullopt;
  const editing::EditHistory& history = edits_.history();
  return history.events()[history.states()[history.current()].event].id;
}

void StudyController::order(Work work, Done done) { orderAs(false, std::move(work), std::move(done)); }

void StudyController::orderAs(bool is_version, Work work, Done done) {
  TACTUS_CHECK(isOpen());
  waiting_.push_back({std::move(done), is_version});
  post([this, work = std::move(work)](StudyWorker::Desk& desk) {
    desk.works.push_back({work, [this](const Result<void>& written) {
                            const auto error = written ? std::nullopt : std::optional(written.error());
                            answer([this, error] { onAnswer(error); });
                          }});
    desk.catchUp();
  });
  if (!slow_timer_.isActive()) slow_timer_.start();
}

void StudyController::open(const QString& path) {
  const QString absolute_path = QFileInfo(path).absoluteFilePath();
  if (isOpen() && QFileInfo(absolute_path) == QFileInfo(path_)) {
    openModel();
  } else if (mayLeave(absolute_path)) {
    begin(absolute_path, false);
  }
}

void StudyController::create(const QString& path) {
  const QString absolute_path = QFileInfo(path).absoluteFilePath();
  if (mayLeave(absolute_path)) begin(absolute_path, true);
}

void StudyController::close() {
  if (!isOpen() || !mayLeave(path_)) return;
  emit leaving();
  if (edits_.isOpen()) edits_.commit();
  storeEvents();
  opening_ = true;
  post([this](StudyWorker::Desk& desk) {
    if (!desk.catchUp()) {
      answer([this] { opening_ = false; });
      return;
    }
    const Result<void> closed = desk.file->close();
    desk.file.reset();
    const QString sentence = closed ? QString() : text(closed.error().message());
    answer([this, sentence] {
      opening_ = false;
      if (!sentence.isEmpty()) emit failed(path_, sentence);
      letGo();
    });
  });
}

void StudyController::openModel() {
  if (!isOpen() || opening_) return;
  if (edits_.isOpen()) edits_.commit();
  storeEvents();
  opening_ = true;
  post([this, stamp = stamp()](StudyWorker::Desk& desk) {
    desk.catchUp();
    auto read = readContents(*desk.file, stamp);
    const QString sentence = read ? QString() : text(read.error().message());
    const auto contents = read ? std::make_shared<StudyContents>(std::move(*read)) : nullptr;
    answer([this, contents, sentence] {
      opening_ = false;
      if (contents) {
        adopt(*contents);
      } else {
        emit failed(path_, sentence);
      }
    });
  });
}

void StudyController::buildModel() {
  if (!isOpen() || opening_) return;
  if (edits_.isOpen()) edits_.commit();
  storeEvents();
  opening_ = true;
  post([this, stamp = stamp()](StudyWorker::Desk& desk) {
    QString note;
    auto built = buildFromStudy(*desk.file, stamp, note);
    const QString sentence = built ? note : text(built.error().message());
    const auto history = built ? std::make_shared<editing::EditHistory>(std::move(*built)) : nullptr;
    answer([this, history, sentence] {
      opening_ = false;
      if (!history) {
        emit failed(path_, sentence);
        return;
      }
      show(std::move(*history));
      emit said(sentence);
    });
  });
}

void StudyController::putModel() {
  if (!isOpen() || !models_.current() || keepsModel()) return;
  edits_.commit();
  const QString from = QFileInfo(models_.current()->path).fileName();
  events_ordered_ = 0;
  models_.moveIntoStudy(path_);
  has_model_ = true;
  storeEvents();
  emit savedChanged();
  emit said(tr("%1 is a model of %2 now, with everything that was done to it.").arg(from, fileName()));
}

void StudyController::storeNow() {
  if (!isOpen()) return;
  retry_.stop();
  if (!refused_.isEmpty()) {
    refused_.clear();
    events_ordered_ = 0;
    storeEvents();
  }
  if (!isBusy()) {
    if (keepsModel()) emit said(tr("Everything is stored in %1.").arg(fileName()));
    return;
  }
  post([](StudyWorker::Desk& desk) { desk.catchUp(); });
}

void StudyController::refresh() {
  if (!isOpen()) return;
  post([this, path = path_](StudyWorker::Desk& desk) {
    if (!desk.file) return;
    auto people = readPeople(*desk.file);
    auto recordings = store::feelRecordings(*desk.file);
    if (!people || !recordings) return;
    answer([this, path, people = std::move(*people), recordings = std::move(*recordings)] {
      if (path != path_) return;
      people_ = people;
      recordings_ = recordings;
      emit contentsChanged();
    });
  });
}

// A study whose disk refuses keeps what was ordered; nobody gets away from it by accident.
bool StudyController::mayLeave(const QString& path) {
  if (opening_) return false;
  if (failure().isEmpty()) return true;
  emit failed(path, tr("%1 has to be written first: %2").arg(fileName(), failure()));
  return false;
}

void StudyController::begin(const QString& path, bool make) {
  opening_ = true;
  emit savedChanged();
  post([this, path = path.toStdString(), make, stamp = stamp()](StudyWorker::Desk& desk) {
    auto file = make ? makeStudy(path, desk.ids) : store::StudyFile::open(path);
    auto contents = file ? readContents(*file, stamp) : tl::unexpected(file.error());
    if (!contents) {
      answer([this, path = text(path), sentence = text(contents.error().message())] {
        opening_ = false;
        emit failed(path, sentence);
      });
      return;
    }
    desk.next = std::move(*file);
    answer([this, contents = std::make_shared<StudyContents>(std::move(*contents))] { changeOver(contents); });
  });
}

// What was done to the model of the study before is written before that study is let go of.
void StudyController::changeOver(std::shared_ptr<StudyContents> contents) {
  emit leaving();
  if (edits_.isOpen()) edits_.commit();
  storeEvents();
  post([this, contents](StudyWorker::Desk& desk) {
    const bool done = desk.catchUp();
    if (done) {
      // The destructor closes a study that does not close with a word; nothing is lost with it.
      desk.file = std::move(*desk.next);
    }
    desk.next.reset();
    answer([this, contents, done] {
      opening_ = false;
      if (!done) {
        emit failed(contents->path, tr("%1 has to be written first: %2").arg(fileName(), failure_));
        return;
      }
      if (keepsModel() && !contents->history) models_.moveOutOfStudy(unusedModelPath(path_));
      path_ = contents->path;
      adopt(*contents);
      emit opened();
      emit savedChanged();
    });
  });
}

void StudyController::adopt(StudyContents& contents) {
  people_ = std::move(contents.people);
  recordings_ = std::move(contents.recordings);
  versions_ = std::move(contents.versions);
  refused_.clear();
  has_model_ = contents.history.has_value();
  texts_ = std::make_shared<TextCache>();
  if (contents.history) {
    show(std::move(*contents.history));
    readTexts(0);
  }
  emit contentsChanged();
  if (!contents.note.isEmpty()) emit said(contents.note);
}

void StudyController::show(editing::EditHistory history) {
  OpenModel open;
  open.path = path_;
  open.in_study = true;
  open.model = history.model();
  open.compiled = history.compiled();
  open.simulated = saysSimulated(open.model);
  adopting_ = true;
  models_.openRead(std::move(open));
  if (!texts_) texts_ = std::make_shared<TextCache>();
  edits_.adopt(std::move(history), [texts = texts_](const study::RecordId& id) -> Result<study::ModelVersion> {
    const auto found = texts->find(id);
    if (found != texts->end()) return found->second;
    return base::fail(base::ErrorCode::kIo, "model version " + study::toText(id), "not read from the study yet",
                      "another try in a moment");
  });
  adopting_ = false;
  has_model_ = true;
  events_ordered_ = 0;
  storeEvents();
  emit savedChanged();
}

void StudyController::storeEvents() {
  if (adopting_ || !keepsModel()) return;
  const editing::EditHistory& history = edits_.history();
  for (; events_ordered_ < history.events().size(); ++events_ordered_) {
    const editing::Event& event = history.events()[events_ordered_];
    if (event.stored) continue;
    auto model = history.modelOf(event.state);
    TACTUS_CHECK(model.has_value());  // a state leaves the memory only once it is stored
    orderAs(
        true,
        [event, model = std::make_shared<const fuzzy::ForceModel>(std::move(*model))](
            store::StudyFile& file, study::RecordIds&) { return storeVersion(file, event, *model); },
        [this, id = event.id] { edits_.markStored(id); });
  }
}

void StudyController::onAnswer(const std::optional<base::Error>& error) {
  if (error && error->code == base::ErrorCode::kIo) {
    setFailure(text(error->message()));
    retry_.start();
    return;
  }
  const Waiting waited = std::move(waiting_.front());
  waiting_.pop_front();
  if (error) {
    const QString sentence = text(error->message());
    if (waited.is_version) refused_ = sentence;
    emit failed(path_, sentence);
  } else if (waited.done) {
    waited.done();
  }
  if (!isBusy()) {
    slow_timer_.stop();
    retry_.stop();
    slow_ = false;
  }
  setFailure({});
}

void StudyController::setFailure(const QString& sentence) {
  const bool is_new = sentence != failure_ && !sentence.isEmpty();
  failure_ = sentence;
  if (is_new) emit failed(path_, tr("Not stored, and tried again every few seconds: %1").arg(sentence));
  emit savedChanged();
}

void StudyController::letGo() {
  if (keepsModel()) models_.moveOutOfStudy(unusedModelPath(path_));
  path_.clear();
  people_.clear();
  recordings_.clear();
  versions_.clear();
  refused_.clear();
  has_model_ = false;
  emit closed();
  emit savedChanged();
}

// Texts of old states, the newest first, so that undo finds them; few at a time, so that edits are stored in between.
void StudyController::readTexts(std::size_t next) {
  if (next >= versions_.size()) return;
  std::vector<study::RecordId> wanted;
  const std::size_t end = std::min(next + kTextsAtOnce, versions_.size());
  for (std::size_t i = next; i < end; ++i) wanted.push_back(versions_[versions_.size() - 1 - i].id);
  post([this, wanted, end, cache = texts_](StudyWorker::Desk& desk) {
    if (!desk.file) return;
    std::vector<study::ModelVersion> read;
    for (const study::RecordId& id : wanted) {
      if (auto version = store::modelVersion(*desk.file, id)) read.push_back(std::move(*version));
    }
    answer([this, end, cache, read = std::move(read)] {
      if (cache != texts_) return;
      for (const study::ModelVersion& version : read) cache->emplace(version.id, version);
      std::size_t bytes = 0;
      for (const auto& [id, version] : *cache) bytes += version.text.size();
      if (bytes < kMostTextBytes) readTexts(end);
    });
  });
}

editing::Stamp StudyController::stamp() const { return {edits_.author().toStdString(), utcNowMs()}; }

}  // namespace tactus::workbench
