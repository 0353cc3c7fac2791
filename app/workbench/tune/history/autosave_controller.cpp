#include "app/workbench/tune/history/autosave_controller.h"

#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"

namespace tactus::workbench {

AutosaveController::AutosaveController(ModelController& models, EditController& edits, QString root, Times times,
                                       QObject* parent)
    : QObject(parent),
      models_(models),
      edits_(edits),
      times_(times),
      folder_(std::make_shared<AutosaveFolder>(std::move(root))) {
  due_.setSingleShot(true);
  connect(&due_, &QTimer::timeout, this, &AutosaveController::write);
  connect(&edits_, &EditController::modelReset, this, &AutosaveController::onReset);
  connect(&edits_, &EditController::changed, this, &AutosaveController::onChange);
  connect(&edits_, &EditController::historyChanged, this, &AutosaveController::onChange);
  connect(&edits_, &EditController::stored, this, &AutosaveController::onChange);
  connect(&models_, &ModelController::saved, this, &AutosaveController::onChange);
}

AutosaveController::~AutosaveController() {
  due_.stop();
  worker_.waitForDone();
  folder_->remove();
}

void AutosaveController::onChange() { writeWithin(edits_.inGesture() ? times_.in_gesture_ms : times_.after_edit_ms); }

void AutosaveController::writeWithin(int delay_ms) {
  if (!due_.isActive() || due_.remainingTime() > delay_ms) due_.start(delay_ms);
}

// The document before was closed, so its changes were saved or given up.
void AutosaveController::onReset() {
  due_.stop();
  again_ = false;
  worker_.post([folder = folder_] { folder->remove(); });
  onChange();
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
  // Copies share the models they hold, so that this costs little; texts are made by the worker.
  auto history = editing::needsAutosave(edits_.history())
                     ? std::make_shared<const editing::EditHistory>(edits_.history())
                     : nullptr;
  AutosaveFolder::Facts facts{models_.current()->path, !models_.isModified() && !models_.current()->in_study};
  worker_.post([this, number, folder = folder_, history = std::move(history), facts = std::move(facts)] {
    QString failure;
    if (!history) {
      folder->remove();
    } else if (const auto done = folder->write(*history, facts); !done) {
      failure = text(done.error().message());
    }
    answers_.post([this, number, failure] { finish(number, failure); });
  });
}

void AutosaveController::finish(quint64 number, const QString& failure) {
  if (number == number_) busy_ = false;
  if (failure_.isEmpty() && !failure.isEmpty()) {
    emit failed(tr("A crash would lose the changes of the model, because they cannot be kept: %1").arg(failure));
  }
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

QString AutosaveController::folder() {
  worker_.waitForDone();
  return folder_->path();
}

}  // namespace tactus::workbench
