#include "app/workbench/study/study_controller.h"

#include <QFileInfo>
#include <utility>

#include "app/editing/history_versions.h"
#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "core/base/check.h"
#include "core/store/model_versions.h"
#include "core/store/withdrawal.h"

namespace tactus::workbench {
namespace {

using base::Result;

// Appends one version. One that is there already was written by an attempt whose answer got lost.
Result<void> storeVersion(store::StudyFile& file, const editing::Event& event, const fuzzy::ForceModel& model) {
  const study::ModelVersion version = editing::versionOf(event, model);
  auto stored = store::append(file, version);
  if (stored) return stored;
  const auto there = store::modelVersion(file, version.id);
  if (there && there->sha256 == version.sha256) return {};
  return stored;
}

// The model of a state for the other thread; the current one is shared.
std::shared_ptr<const fuzzy::ForceModel> modelOf(const editing::EditHistory& history, editing::StateId state) {
  if (state == history.current()) {
    const editing::SharedModel ready = *history.readyOf(state);
    return {ready, &ready->model};
  }
  auto model = history.modelOf(state);
  TACTUS_CHECK(model.has_value());  // a state leaves the memory only once it is stored
  return std::make_shared<const fuzzy::ForceModel>(std::move(*model));
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
  connect(&orders_, &StudyOrders::changed, this, &StudyController::savedChanged);
  connect(&orders_, &StudyOrders::failed, this, [this](const QString& sentence) { emit failed(path_, sentence); });
  connect(&review_, &StudyReview::changed, this, &StudyController::notesChanged);
  connect(&texts_, &VersionTexts::arrived, &edits_, &EditController::historyChanged);
  connect(&edits_, &EditController::historyChanged, this, &StudyController::storeEvents);
  connect(&models_, &ModelController::opened, this, &StudyController::savedChanged);
  connect(&models_, &ModelController::storeNow, this, &StudyController::storeNow);
  connect(&models_, &ModelController::reopenFromStudy, this, &StudyController::openModel);
  connect(&models_, &ModelController::copied, this, [this](const QString& copy) {
    emit said(tr("A copy was written to %1; edits go on into %2.").arg(shownFileName(copy), fileName()));
  });
}

StudyController::~StudyController() {
  if (edits_.isOpen()) edits_.commit();
  storeEvents();
  post([](StudyWorker::Desk& desk) { desk.catchUp(); });
}

QString StudyController::fileName() const { return shownFileName(path_); }

bool StudyController::keepsModel() const { return isOpen() && models_.current() && models_.current()->in_study; }

QString StudyController::savedText() const {
  if (!keepsModel()) return {};
  if (!failure().isEmpty()) return tr("● Not stored in %1").arg(fileName());
  return (orders_.isSlow() ? tr("Saving in %1…") : tr("Stored in %1")).arg(fileName());
}

std::optional<study::RecordId> StudyController::modelVersion() const {
  if (!keepsModel()) return std::nullopt;
  // While versions are compared, another one than the open one may be looked at.
  if (models_.shown() != models_.current() && models_.shown()->version) return models_.shown()->version;
  return edits_.history().versionOf(edits_.history().current());
}

void StudyController::order(StudyOrders::Work work, StudyOrders::Done done, StudyOrders::Refused refused) {
  TACTUS_CHECK(takesOrders());
  if (!refused) refused = [this](const QString& sentence) { emit failed(path_, sentence); };
  orders_.add(std::move(work), std::move(done), std::move(refused));
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
  whenWritten([this](bool written) {
    if (!written) return;
    if (keepsModel()) moveOut();
    opening_ = closing_ = true;
    post([this](StudyWorker::Desk& desk) {
      const Result<void> closed = desk.file->close();
      desk.file.reset();
      const QString sentence = closed ? QString() : text(closed.error().message());
      answer([this, sentence] {
        if (!sentence.isEmpty()) emit failed(path_, sentence);
        letGo();
      });
    });
  });
}

void StudyController::openModel() {
  if (!isOpen() || !mayLeave(path_)) return;
  whenWritten([this](bool written) {
    if (!written) return;
    opening_ = true;
    const std::size_t known = edits_.isOpen() ? edits_.history().events().size() : 0;
    post([this, known, stamp = edits_.stamp()](StudyWorker::Desk& desk) {
      auto read = readContents(*desk.file, stamp);
      const QString sentence = read ? QString() : text(read.error().message());
      const auto contents = read ? std::make_shared<StudyContents>(std::move(*read)) : nullptr;
      answer([this, known, contents, sentence] {
        opening_ = false;
        if (!contents) {
          emit failed(path_, sentence);
        } else if (keepsModel() && edits_.history().events().size() != known) {
          openModel();  // what was edited meanwhile has to be read too
        } else {
          adopt(*contents);
        }
        emit savedChanged();
      });
    });
  });
}

void StudyController::buildModel() {
  if (!isOpen() || !mayLeave(path_)) return;
  whenWritten([this](bool written) {
    if (!written) return;
    opening_ = true;
    post([this, stamp = edits_.stamp()](StudyWorker::Desk& desk) {
      auto made = std::make_shared<base::Result<BuiltFromStudy>>(buildFromStudy(*desk.file, stamp));
      answer([this, made] {
        opening_ = false;
        if (*made) {
          show(std::move((*made)->history));
          review_.set(std::move((*made)->notes));
          emit said((*made)->sentence);
        } else {
          review_.begin(modelVersion());  // what is in the way stands there too
          emit failed(path_, text(made->error().message()));
        }
        emit savedChanged();
      });
    });
  });
}

void StudyController::putModel() {
  if (!takesOrders() || opening_ || !models_.current() || keepsModel()) return;
  edits_.commit();
  const QString from = shownFileName(models_.current()->path);
  events_ordered_ = 0;
  models_.moveIntoStudy(path_);
  has_model_ = true;
  storeEvents();
  review_.begin(modelVersion());
  emit savedChanged();
  emit said(tr("%1 is a model of %2 now, with everything that was done to it.").arg(from, fileName()));
}

void StudyController::finishErasure() {
  if (!takesOrders() || erasing_) return;
  const auto end = std::make_shared<ErasureEnd>();
  erasing_ = true;
  emit noticesChanged();
  // A failure is no error of the order: it would be done again and again, and nobody could leave the study meanwhile.
  order(
      [end](store::StudyFile& file, study::RecordIds&) -> Result<void> {
        const auto erasure = store::erase(file);
        end->failure = erasure ? QString() : text(erasure.error().message());
        end->models_changed = erasure && erasure->models > 0;
        if (auto notices = readNotices(file)) end->notices = std::move(*notices);
        return {};
      },
      [this, end] { onErased(std::move(*end)); });
}

void StudyController::onErased(ErasureEnd end) {
  erasing_ = false;
  if (end.notices) setNotices(std::move(*end.notices));
  emit noticesChanged();
  if (!end.failure.isEmpty()) {
    emit failed(path_, tr("The erasure is not finished: %1").arg(end.failure));
    return;
  }
  emit said(tr("The erasure is finished: nothing of those who withdrew is left in %1. Backups and exports made before "
               "can still hold their data.")
                .arg(fileName()));
  // Rules of somebody who withdrew were taken out of versions that are on the screen.
  if (end.models_changed && keepsModel()) openModel();
}

void StudyController::storeNow() {
  if (!isOpen()) return;
  if (!refused_.isEmpty()) {
    refused_.clear();
    events_ordered_ = 0;
    storeEvents();
  }
  if (!isBusy() && keepsModel()) emit said(tr("Everything is stored in %1.").arg(fileName()));
  orders_.tryAgain();
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

// Calls `then` at a moment when nothing is left to be written, edits that were made in between included; tells it
// false, and everybody why, where the disk refuses.
void StudyController::whenWritten(std::function<void(bool)> then) {
  opening_ = true;
  if (edits_.isOpen()) edits_.commit();
  storeEvents();
  orders_.whenWritten([this, then = std::move(then)](bool written) {
    if (edits_.isOpen()) edits_.commit();
    storeEvents();
    if (written && isBusy()) {
      whenWritten(then);
      return;
    }
    opening_ = false;
    if (!written) emit failed(path_, tr("%1 has to be written first: %2").arg(fileName(), failure()));
    then(written);
    emit savedChanged();
  });
}

void StudyController::begin(const QString& path, bool make) {
  opening_ = true;
  emit savedChanged();
  post([this, path = path.toStdString(), make, stamp = edits_.stamp()](StudyWorker::Desk& desk) {
    auto file = make ? makeStudy(path, desk.ids) : store::StudyFile::open(path);
    auto contents = file ? readContents(*file, stamp) : tl::unexpected(file.error());
    if (!contents) {
      answer([this, path = text(path), sentence = text(contents.error().message())] {
        opening_ = false;
        emit failed(path, sentence);
        emit savedChanged();
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
  whenWritten([this, contents](bool written) {
    post([written](StudyWorker::Desk& desk) {
      // The destructor closes a study that does not close with a word; nothing is lost with it.
      if (written) desk.file = std::move(*desk.next);
      desk.next.reset();
    });
    if (!written) return;
    if (keepsModel() && !contents->history) moveOut();
    path_ = contents->path;
    adopt(*contents);
    emit opened();
  });
}

void StudyController::adopt(StudyContents& contents) {
  people_ = std::move(contents.people);
  recordings_ = std::move(contents.recordings);
  refused_.clear();
  has_model_ = contents.history.has_value();
  texts_.begin(contents.versions);
  if (contents.history) show(std::move(*contents.history));
  setNotices(std::move(contents.notices));
  if (contents.built) {
    review_.set(std::move(contents.notes));
  } else {
    review_.begin(contents.versions.empty() ? std::nullopt : std::optional(contents.versions.back().id));
  }
  emit contentsChanged();
  if (!contents.note.isEmpty()) emit said(contents.note);
}

void StudyController::setNotices(StudyNotices notices) {
  if (notices == notices_) return;
  notices_ = std::move(notices);
  emit noticesChanged();
}

void StudyController::show(editing::EditHistory history) {
  OpenModel open(history.ready());
  open.path = path_;
  open.in_study = true;
  open.simulated = saysSimulated(open.model);
  adopting_ = true;
  models_.openRead(std::move(open));
  edits_.adopt(std::move(history), texts_.reader());
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
    order([event, model = modelOf(history, event.state)](
              store::StudyFile& file, study::RecordIds&) { return storeVersion(file, event, *model); },
          [this, id = event.id] { edits_.markStored(id); },
          [this](const QString& sentence) {
            refused_ = sentence;
            emit failed(path_, sentence);
          });
  }
}

// The study keeps what was done to its model until now. Beside it the model goes on with a history of its own, so that
// all of it can be kept elsewhere: as a file, after a crash, in another study.
void StudyController::moveOut() {
  models_.moveOutOfStudy(unusedModelPath(path_));
  edits_.adopt(editing::EditHistory::open(edits_.history().ready(), tr("Left in %1").arg(fileName()).toStdString(),
                                          edits_.stamp(), study::RecordIds()));
}

void StudyController::letGo() {
  path_.clear();
  people_.clear();
  recordings_.clear();
  refused_.clear();
  review_.clear();
  erasing_ = false;
  setNotices({});
  has_model_ = false;
  opening_ = closing_ = false;
  emit closed();
  emit savedChanged();
}

}  // namespace tactus::workbench
