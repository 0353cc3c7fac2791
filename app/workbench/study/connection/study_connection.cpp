#include "app/workbench/study/connection/study_connection.h"

#include <QFileInfo>
#include <QPointer>
#include <algorithm>
#include <utility>

#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "core/base/check.h"
#include "core/base/error.h"
#include "core/store/copies.h"
#include "core/store/persons.h"
#include "core/store/study_file.h"
#include "core/store/withdrawal.h"

namespace tactus::workbench {

bool StudyWorker::OpenStudy::catchUp() {
  while (!works.empty()) {
    const base::Result<void> done = works.front().run(*file, ids);
    const auto answer = works.front().answer;
    const bool again = !done && done.error().code == base::ErrorCode::kIo;
    if (!again) works.pop_front();
    answer(done);
    if (again) return false;
  }
  return true;
}

base::Result<void> StudyWorker::OpenStudy::close() {
  drop();
  const base::Result<void> closed = file->close();
  file.reset();
  return closed;
}

void StudyWorker::OpenStudy::exchange() {
  drop();
  // The destructor closes a study that does not close with a word; nothing is lost with it.
  file = std::move(*next);
  next.reset();
}

void StudyWorker::OpenStudy::drop() {
  for (const auto& call : before_closing) call();
  before_closing.clear();
}

namespace {

using base::Result;

constexpr int kSlowMs = 200;    // design: a write that takes longer is shown
constexpr int kRetryMs = 3000;  // a disk that refused is asked again

}  // namespace

StudyOrders::StudyOrders(StudyWorker& worker, CallQueue& answers, QObject* parent)
    : QObject(parent), worker_(worker), answers_(answers) {
  slow_timer_.setSingleShot(true);
  slow_timer_.setInterval(kSlowMs);
  retry_.setSingleShot(true);
  retry_.setInterval(kRetryMs);
  connect(&slow_timer_, &QTimer::timeout, this, [this] {
    slow_ = isBusy();
    emit changed();
  });
  connect(&retry_, &QTimer::timeout, this, &StudyOrders::tryAgain);
}

void StudyOrders::add(Work work, Done done, Refused refused) {
  waiting_.push_back({std::move(done), std::move(refused)});
  worker_.post([this, work = std::move(work)](StudyWorker::OpenStudy& at) {
    at.works.push_back({work, [this](const Result<void>& written) {
                          const auto error = written ? std::nullopt : std::optional(written.error());
                          answers_.post([this, error] { onAnswer(error); });
                        }});
    at.catchUp();
  });
  if (!slow_timer_.isActive()) slow_timer_.start();
}

void StudyOrders::tryAgain() {
  retry_.stop();
  if (isBusy()) worker_.post([](StudyWorker::OpenStudy& at) { at.catchUp(); });
}

void StudyOrders::whenWritten(std::function<void(bool)> then) {
  worker_.post([this, then = std::move(then)](StudyWorker::OpenStudy& at) {
    answers_.post([then, done = at.catchUp()] { then(done); });
  });
}

void StudyOrders::onAnswer(const std::optional<base::Error>& error) {
  if (error && error->code == base::ErrorCode::kIo) {
    retry_.start();
    setFailure(text(error->message()));
    return;
  }
  const Waiting waited = std::move(waiting_.front());
  waiting_.pop_front();
  if (error) {
    waited.refused(text(error->message()));
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

void StudyOrders::setFailure(const QString& sentence) {
  const bool is_new = sentence != failure_ && !sentence.isEmpty();
  failure_ = sentence;
  if (is_new) emit failed(tr("Not stored, and tried again every few seconds: %1").arg(sentence));
  emit changed();
}

namespace {

using base::Result;

Result<store::StudyFile> makeStudy(const std::string& path, const session::ProcedurePtr& procedure,
                                   study::RecordIds& ids) {
  const QString name = QFileInfo(text(path)).completeBaseName();
  const bool another = procedure != nullptr && procedure != procedure::defaultProcedure();
  if (another) {
    // Before there is a file.
    if (auto fits = session::firstProtocol(procedure); !fits) return tl::unexpected(fits.error());
  }
  TACTUS_TRY(auto file,
             store::StudyFile::create(path, {ids.next(), name.toStdString(), utcNowMs(), std::string(kGenerator)}));
  if (another) {
    auto tools = session::systemTools();
    if (auto kept = session::keepProcedure(file, procedure, tools); !kept) return tl::unexpected(kept.error());
  }
  return file;
}

struct OpenedFile {
  store::StudyFile file;
  QString read_only;  ///< why it is open for reading alone; empty: it is not
};

/// For writing, where that is possible.
Result<OpenedFile> openAsItMay(const std::string& path) {
  auto file = store::StudyFile::open(path);
  if (file) return OpenedFile{std::move(*file), {}};
  const auto reason = store::readOnlyReason(path);
  const bool newer = file.error().code == base::ErrorCode::kVersion;
  if (!reason && !newer) return tl::unexpected(file.error());
  TACTUS_TRY(auto reading, store::StudyFile::open(path, {store::Access::kReadOnly, {}}));
  return OpenedFile{std::move(reading), newer ? StudyConnection::tr("a newer version of Tactus wrote it")
                                              : StudyConnection::tr("it or its folder is read-only")};
}

}  // namespace

StudyConnection::StudyConnection(QObject* parent) : QObject(parent) {
  connect(&orders_, &StudyOrders::changed, this, &StudyConnection::changed);
  connect(&orders_, &StudyOrders::failed, this, [this](const QString& sentence) { emit failed(path_, sentence); });
}

StudyConnection::~StudyConnection() {
  orderRest();
  post([](StudyWorker::OpenStudy& at) { at.catchUp(); });
}

QString StudyConnection::fileName() const { return shownFileName(path_); }

QString StudyConnection::failure() const {
  if (!orders_.failure().isEmpty() || keeper_ == nullptr) return orders_.failure();
  return keeper_->refusal();
}

void StudyConnection::order(StudyOrders::Work work, StudyOrders::Done done, StudyOrders::Refused refused) {
  TACTUS_CHECK(takesOrders());
  if (!refused) refused = [this](const QString& sentence) { emit failed(path_, sentence); };
  orders_.add(std::move(work), std::move(done), std::move(refused));
}

void StudyConnection::read(QObject& asker, Read read, Deliver closed) {
  post(
      [this, asker = QPointer(&asker), read = std::move(read), closed = std::move(closed)](StudyWorker::OpenStudy& at) {
        answer([asker, deliver = at.file ? read(*at.file) : closed] {
          if (asker && deliver) deliver();
        });
      });
}

void StudyConnection::readAlone(QObject& asker, std::function<Read()> prepare) {
  if (!isOpen() || !mayLeave(path_)) return;
  whenWritten([this, asker = QPointer(&asker), prepare = std::move(prepare)](bool written) {
    if (!written || !asker) return;
    opening_ = true;
    post([this, asker, read = prepare()](StudyWorker::OpenStudy& at) {
      answer([this, asker, deliver = read(*at.file)] {
        opening_ = false;
        if (asker && deliver) deliver();
        emit changed();
      });
    });
  });
}

void StudyConnection::withdraw(const study::RecordId& person, StudyOrders::Done done, StudyOrders::Refused refused) {
  const auto end = std::make_shared<ErasureEnd>();
  order(
      [end, person](store::StudyFile& file, study::RecordIds&) -> Result<void> {
        const auto withdrawal = store::withdraw(file, person, utcNowMs());
        TACTUS_TRY(const auto left, store::persons(file));
        const bool still_there =
            std::any_of(left.begin(), left.end(), [&](const study::Person& one) { return one.id == person; });
        // With the records gone, only the erasure may have failed, which the notices offer to finish.
        if (!withdrawal && still_there) return tl::unexpected(withdrawal.error());
        end->models_changed = !withdrawal || withdrawal->models > 0;
        if (auto notices = readNotices(file)) end->notices = std::move(*notices);
        return {};
      },
      [this, end, done = std::move(done)] {
        if (end->notices) setNotices(std::move(*end->notices));
        refresh();
        if (end->models_changed) emit modelsErased();
        if (done) done();
      },
      std::move(refused));
}

void StudyConnection::beforeClosing(std::function<void()> drop) {
  post([drop = std::move(drop)](StudyWorker::OpenStudy& at) { at.before_closing.push_back(drop); });
}

void StudyConnection::attach(StudyKeeper& keeper) {
  TACTUS_CHECK(keeper_ == nullptr);
  keeper_ = &keeper;
}

void StudyConnection::detach() { keeper_ = nullptr; }

void StudyConnection::open(const QString& path) {
  const QString absolute_path = QFileInfo(path).absoluteFilePath();
  if (isOpen() && QFileInfo(absolute_path) == QFileInfo(path_)) {
    emit openedAgain();
  } else if (mayLeave(absolute_path)) {
    begin(absolute_path, false);
  }
}

void StudyConnection::create(const QString& path, session::ProcedurePtr procedure) {
  const QString absolute_path = QFileInfo(path).absoluteFilePath();
  if (mayLeave(absolute_path)) begin(absolute_path, true, std::move(procedure));
}

void StudyConnection::close() {
  if (!isOpen() || !mayLeave(path_)) return;
  emit leaving();
  whenWritten([this](bool written) {
    if (!written) return;
    if (keeper_ != nullptr) keeper_->leave();
    opening_ = closing_ = true;
    post([this](StudyWorker::OpenStudy& at) {
      const Result<void> closed = at.close();
      const QString sentence = closed ? QString() : text(closed.error().message());
      answer([this, sentence] {
        if (!sentence.isEmpty()) emit failed(path_, sentence);
        releaseStudy();
      });
    });
  });
}

void StudyConnection::finishErasure() {
  if (!takesOrders() || erasing_) return;
  const auto end = std::make_shared<ErasureEnd>();
  erasing_ = true;
  emit noticesChanged();
  // A permanent failure is dropped: retrying it for ever would keep the user from closing the study.
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

void StudyConnection::onErased(ErasureEnd end) {
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
  if (end.models_changed) emit modelsErased();
}

void StudyConnection::saveCopy(const QString& path) {
  if (!isOpen()) return;
  read(*this, [this, path](const store::StudyFile& file) -> Deliver {
    const auto done = store::backUp(file, path.toStdString());
    const QString sentence = done ? QString() : text(done.error().message());
    return [this, path, sentence] {
      if (sentence.isEmpty()) {
        emit copied(path);
      } else {
        emit copyFailed(sentence);
      }
    };
  });
}

void StudyConnection::moveTo(const QString& path) {
  if (!isOpen() || opening_) return;
  opening_ = true;
  emit changed();
  post([this, path = path.toStdString()](StudyWorker::OpenStudy& at) {
    const auto copied = store::backUp(*at.file, path);
    auto copy = copied ? openAsItMay(path) : tl::unexpected(copied.error());
    auto contents = copy ? readContents(copy->file) : tl::unexpected(copy.error());
    if (!contents) {
      answer([this, sentence = text(contents.error().message())] {
        opening_ = false;
        emit copyFailed(sentence);
        emit changed();
      });
      return;
    }
    at.next = std::move(copy->file);
    at.exchange();
    at.catchUp();
    answer([this,
            study = std::make_shared<OpenedStudy>(OpenedStudy{std::move(*contents), {}, std::move(copy->read_only)})] {
      opening_ = false;
      adopt(*study);
      emit opened();
      emit changed();
      if (keeper_ != nullptr) keeper_->orderAgain();
      refresh();
    });
  });
}

void StudyConnection::storeNow() {
  if (!isOpen()) return;
  if (keeper_ != nullptr) keeper_->orderAgain();
  orders_.tryAgain();
}

void StudyConnection::refresh() {
  if (!isOpen()) return;
  read(*this, [this, path = path_](const store::StudyFile& file) -> Deliver {
    auto people = readPeople(file);
    auto recordings = store::feelRecordings(file);
    if (!people || !recordings) return {};
    return [this, path, people = std::move(*people), recordings = std::move(*recordings)] {
      if (path != path_) return;
      people_ = people;
      recordings_ = recordings;
      emit contentsChanged();
    };
  });
}

// If the disk refuses, the orders are kept and the study cannot be closed by accident.
bool StudyConnection::mayLeave(const QString& path) {
  if (opening_) return false;
  if (failure().isEmpty()) return true;
  emit failed(path, tr("%1 has to be written first: %2").arg(fileName(), failure()));
  return false;
}

void StudyConnection::orderRest() {
  if (keeper_ != nullptr) keeper_->orderRest();
}

// Calls `then` at a moment when nothing is left to be written, what the keeper orders in between included; tells it
// false, and everybody why, where the disk refuses.
void StudyConnection::whenWritten(std::function<void(bool)> then) {
  opening_ = true;
  orderRest();
  orders_.whenWritten([this, then = std::move(then)](bool written) {
    orderRest();
    if (written && isBusy()) {
      whenWritten(then);
      return;
    }
    opening_ = false;
    if (!written) emit failed(path_, tr("%1 has to be written first: %2").arg(fileName(), failure()));
    then(written);
    emit changed();
  });
}

void StudyConnection::begin(const QString& path, bool make, session::ProcedurePtr procedure) {
  opening_ = true;
  emit changed();
  const auto share = keeper_ != nullptr ? keeper_->reader() : StudyKeeper::ReadShare();
  post([this, path = path.toStdString(), make, share, procedure = std::move(procedure)](StudyWorker::OpenStudy& at) {
    auto opened = make ? makeStudy(path, procedure, at.ids).map([](store::StudyFile&& made) {
      return OpenedFile{std::move(made), {}};
    })
                       : openAsItMay(path);
    auto contents = opened ? readContents(opened->file) : tl::unexpected(opened.error());
    if (contents && !make && opened->read_only.isEmpty()) {
      if (const auto kept = store::keepCopy(opened->file); !kept) {
        const QString sentence = tr("No copy of the study was kept at this opening: %1.");
        contents->notices.now.push_back({sentence.arg(harmless(text(kept.error().message()))), false});
      }
    }
    auto take = !contents ? tl::unexpected(contents.error()) : share ? share(opened->file) : StudyKeeper::Take();
    if (!take) {
      answer([this, path = text(path), sentence = text(take.error().message())] {
        opening_ = false;
        emit failed(path, sentence);
        emit changed();
      });
      return;
    }
    at.next = std::move(opened->file);
    answer([this, study = std::make_shared<OpenedStudy>(OpenedStudy{
                      std::move(*contents), std::move(*take), std::move(opened->read_only)})] { changeOver(study); });
  });
}

// What was ordered for the study before is written before that study is let go of.
void StudyConnection::changeOver(std::shared_ptr<OpenedStudy> study) {
  emit leaving();
  whenWritten([this, study](bool written) {
    post([written](StudyWorker::OpenStudy& at) {
      if (written) at.exchange();
      at.next.reset();
    });
    if (!written) return;
    adopt(*study);
    emit opened();
  });
}

void StudyConnection::adopt(OpenedStudy& study) {
  path_ = study.contents.path;
  read_only_ = study.read_only;
  procedure_ = study.contents.procedure != nullptr ? study.contents.procedure : procedure::defaultProcedure();
  people_ = std::move(study.contents.people);
  recordings_ = std::move(study.contents.recordings);
  emit procedureChanged();
  if (study.take) study.take();
  setNotices(std::move(study.contents.notices));
  emit contentsChanged();
}

void StudyConnection::setNotices(StudyNotices notices) {
  if (notices == notices_) return;
  notices_ = std::move(notices);
  emit noticesChanged();
}

void StudyConnection::releaseStudy() {
  path_.clear();
  read_only_.clear();
  procedure_ = procedure::defaultProcedure();
  people_.clear();
  recordings_.clear();
  erasing_ = false;
  setNotices({});
  opening_ = closing_ = false;
  emit closed();
  emit changed();
}

}  // namespace tactus::workbench
