#include "app/workbench/tune/history/autosave_controller.h"

#include <QDateTime>
#include <algorithm>
#include <string>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"

namespace tactus::workbench {
namespace {

bool hasUnstored(const editing::EditHistory& history) {
  const auto& events = history.events();
  return std::any_of(events.rbegin(), events.rend(), [](const editing::Event& event) {
    return !event.stored && event.kind != editing::EventKind::kOpened;
  });
}

bool isDragging(const editing::EditHistory& history) {
  return history.inGesture() && &history.model() != &history.base();
}

}  // namespace

AutosaveController::AutosaveController(ModelController& models, EditController& edits, QString root, Times times,
                                       QObject* parent)
    : QObject(parent), models_(models), edits_(edits), times_(times), file_(std::make_shared<HistoryFile>(root)) {
  worker_.post([root = std::move(root)] { HistoryFile::makeRoom(root); });
  due_.setSingleShot(true);
  connect(&due_, &QTimer::timeout, this, &AutosaveController::write);
  connect(&edits_, &EditController::modelReset, this, &AutosaveController::onReset);
  connect(&edits_, &EditController::changed, this, &AutosaveController::onChange);
  connect(&edits_, &EditController::historyChanged, this, &AutosaveController::onChange);
  connect(&edits_, &EditController::stored, this, &AutosaveController::onChange);
  connect(&models_, &ModelController::saved, this, &AutosaveController::onSaved);
  connect(&models_, &ModelController::modifiedChanged, this, &AutosaveController::onChange);
  if (edits_.isOpen()) onReset();
}

AutosaveController::~AutosaveController() {
  if (edits_.isOpen()) takeOver();
  leave();
}

void AutosaveController::onChange() {
  if (!edits_.isOpen() || models_.current()->path != document_) return;
  takeOver();
  writeWithin(edits_.inGesture() ? times_.in_gesture_ms : times_.after_edit_ms);
}

// Copies share the models they hold, so that this costs little; texts are made by the worker.
void AutosaveController::takeOver() {
  if (edits_.inGesture() || models_.current()->path != document_) return;
  const editing::EditHistory& now = edits_.history();
  if (!in_study_ && (!history_ || history_->events().size() != now.events().size())) {
    history_ = std::make_shared<const editing::EditHistory>(now);
  }
  if (!models_.isModified()) saved_ = now.current();
}

void AutosaveController::writeWithin(int delay_ms) {
  if (!due_.isActive() || due_.remainingTime() > delay_ms) due_.start(delay_ms);
}

// Another document was opened, or the same document got another history.
void AutosaveController::onReset() {
  due_.stop();
  again_ = false;
  if (!adopting_) leave();
  document_ = models_.current()->path;
  in_study_ = models_.current()->in_study;
  history_.reset();
  saved_.reset();
  lost_.reset();
  drag_kept_ = false;
  takeOver();
  const auto& events = edits_.history().events();
  const bool is_fresh = events.size() == 1 && events.front().kind == editing::EventKind::kOpened;
  kept_ = is_fresh ? 1 : 0;
  if (is_fresh && !in_study_ && !adopting_) lookUp();
  onChange();
}

// The model may have moved to another file, or into a study; its file before keeps the state that it has.
void AutosaveController::onSaved() {
  if (models_.current()->path == document_ && models_.current()->in_study == in_study_) return onChange();
  leave();
  document_ = models_.current()->path;
  in_study_ = models_.current()->in_study;
  history_.reset();
  lost_.reset();
  kept_ = 0;
  takeOver();
  saved_ = edits_.history().current();
  onChange();
}

void AutosaveController::lookUp() {
  worker_.post([this, file = file_, document = document_, fresh = history_,
                label = tr("The file was changed by another program").toStdString(), stamp = edits_.stamp()] {
    auto found = std::make_shared<Found>(lookUp(*file, document, *fresh, label, stamp));
    answers_.post([this, document, found] { adopt(document, std::move(*found)); });
  });
}

AutosaveController::Found AutosaveController::lookUp(HistoryFile& file, const QString& document,
                                                     const editing::EditHistory& fresh,
                                                     const std::string& changed_label, const editing::Stamp& stamp) {
  Found out;
  const std::string sha256 = editing::versionOf(fresh.events().front(), fresh.base()).sha256;
  auto work = file.open(document, sha256);
  if (!work) {
    out.failure = text(work.error().message());
  } else if (*work) {
    out.merged = (*work)->merged;
    auto history = editing::goOn(std::move((*work)->kept), fresh, study::RecordIds(), changed_label, stamp);
    if (history) {
      out.history = std::move(*history);
    } else {
      out.failure = text(history.error().message());
      out.aside = file.setAside();
    }
  }
  return out;
}

void AutosaveController::adopt(const QString& document, Found found) {
  if (document != document_ || !edits_.isOpen() || in_study_) return;
  const QString name = shownFileName(document);
  if (!found.aside.isEmpty()) {
    emit setAside(tr("The history of %1 does not go on: %2. It is kept in %3, which opens as a study.")
                      .arg(name, found.failure, found.aside),
                  found.aside);
  } else if (!found.failure.isEmpty()) {
    emit notRead(tr("The earlier history of %1 was not read. %2").arg(name, found.failure), document);
  }
  // What was edited meanwhile stands beside the earlier history in the file.
  const bool is_fresh = edits_.history().events().size() == 1 && !edits_.inGesture();
  if (found.history && is_fresh) {
    editing::EarlierHistory& earlier = *found.history;
    const QString when =
        QDateTime::fromMSecsSinceEpoch(earlier.last_utc_ms).toString(QStringLiteral("yyyy-MM-dd HH:mm"));
    adopting_ = true;
    edits_.adopt(std::move(earlier.history));
    adopting_ = false;
    kept_ = earlier.kept;
    if (earlier.lost && !found.merged) {
      lost_ = LostEdits{*earlier.lost, std::move(earlier.drag), static_cast<int>(earlier.edits), earlier.last_utc_ms};
    }
    if (earlier.changed_elsewhere) {
      emit said(tr("Another program changed %1 after %2. Undo leads back to the state before; History has all others.")
                    .arg(name, when));
    }
    onChange();
  }
  emit lookedUp(document);
}

void AutosaveController::settleLost() {
  if (!std::exchange(lost_, std::nullopt)) return;
  kept_ = 0;
  drag_kept_ = true;
  writeWithin(0);
}

// The document before was closed, so its changes were saved or given up.
void AutosaveController::leave() {
  due_.stop();
  if (document_.isEmpty()) return;
  if (in_study_) {
    worker_.post([file = file_] { file->remove(); });
  } else {
    if (history_ && (drag_kept_ || (history_->events().size() > kept_ && hasUnstored(*history_)))) {
      auto last = std::make_shared<editing::EditHistory>(*history_);
      if (saved_) (void)last->returnTo(*saved_, edits_.stamp());
      worker_.post([file = file_, last, document = document_, utc_ms = edits_.stamp().utc_ms] {
        (void)file->write(*last, document, HistoryFile::Place::kHistory, utc_ms);  // a failure was told before
      });
    }
    worker_.post([file = file_] { file->close(); });
  }
  document_.clear();
}

bool AutosaveController::needsWriting() const {
  const editing::EditHistory& history = edits_.history();
  return isDragging(history) || drag_kept_ || (history.events().size() > kept_ && hasUnstored(history));
}

void AutosaveController::write() {
  due_.stop();
  if (!edits_.isOpen()) return;
  if (busy_) {
    again_ = true;
    return;
  }
  busy_ = true;
  const quint64 number = ++number_;
  auto history = needsWriting() ? std::make_shared<const editing::EditHistory>(edits_.history()) : nullptr;
  drag_kept_ = history && isDragging(*history);
  const auto place = in_study_ ? HistoryFile::Place::kNewFile : HistoryFile::Place::kHistory;
  worker_.post([this, number, file = file_, history = std::move(history), document = document_, place,
                utc_ms = edits_.stamp().utc_ms] {
    QString failure;
    if (history) {
      const auto done = file->write(*history, document, place, utc_ms);
      if (!done) failure = text(done.error().message());
    } else if (place == HistoryFile::Place::kNewFile) {
      file->remove();
    }
    answers_.post([this, number, failure] { finish(number, failure); });
  });
}

void AutosaveController::finish(quint64 number, const QString& failure) {
  if (number == number_) busy_ = false;
  if (failure_.isEmpty() && !failure.isEmpty()) {
    emit failed(tr("Autosave failed, so a crash would lose the changes of the model: %1").arg(failure));
  }
  if (!failure_.isEmpty() && failure.isEmpty()) emit worksAgain();
  failure_ = failure;
  if (std::exchange(again_, false)) {
    write();
  } else if (failure.isEmpty()) {
    emit written(number);
  } else {
    writeWithin(times_.after_failure_ms);
  }
}

quint64 AutosaveController::flush() {
  write();
  worker_.waitForDone();
  if (again_) {
    again_ = false;
    busy_ = false;
    write();
    worker_.waitForDone();
  }
  return number_;
}

void AutosaveController::post(std::function<void(HistoryFile&)> task) {
  worker_.post([file = file_, task = std::move(task)] { task(*file); });
}

void AutosaveController::wait() { worker_.waitForDone(); }

QString AutosaveController::file() {
  worker_.waitForDone();
  return file_->path();
}

}  // namespace tactus::workbench
