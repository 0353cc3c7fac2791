#include "app/workbench/model/model_controller.h"

#include <QFileInfo>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/model_io/model_file.h"

namespace tactus::workbench {
namespace {

/// `model` in the place of the one that `before` has.
OpenModel inPlaceOf(const OpenModel& before, editing::SharedModel model) {
  OpenModel next(std::move(model));
  next.path = before.path;
  next.in_study = before.in_study;
  next.warnings = before.warnings;
  next.simulated = before.simulated;
  return next;
}

}  // namespace

base::Result<void> ModelController::edit(fuzzy::ForceModel model) {
  TACTUS_TRY(auto ready, editing::ready(std::move(model)));
  edit(std::move(ready));
  return {};
}

void ModelController::edit(editing::SharedModel model) {
  TACTUS_CHECK(current_ != nullptr);
  // The end of a gesture whose last update is shown already changes nothing.
  if (!instead_ && model == current_->shared) return;
  OpenModel next = inPlaceOf(*current_, std::move(model));
  next.simulated = next.simulated || saysSimulated(next.model);
  current_ = std::make_shared<const OpenModel>(std::move(next));
  instead_.reset();
  emit edited();
  setModified(!current_->in_study && (!on_disk_ || current_->model != on_disk_->model));
}

void ModelController::open(const QString& path) {
  const QString absolute_path = QFileInfo(path).absoluteFilePath();
  auto read = readOpenModel(absolute_path);
  if (!read) {
    emit openFailed(absolute_path, QString::fromStdString(read.error().message()));
    return;
  }
  openRead(std::move(*read));
}

void ModelController::openRead(OpenModel model) {
  current_ = std::make_shared<const OpenModel>(std::move(model));
  on_disk_ = current_;
  instead_.reset();
  emit opened();
  setModified(false);
}

void ModelController::openUnsaved(OpenModel model) {
  openRead(std::move(model));
  on_disk_.reset();
  setModified(true);
}

void ModelController::moveIntoStudy(const QString& path) { moveTo(path, true); }

void ModelController::moveOutOfStudy(const QString& path) { moveTo(path, false); }

void ModelController::moveTo(const QString& path, bool in_study) {
  TACTUS_CHECK(current_ != nullptr);
  OpenModel next = *current_;
  next.path = path;
  next.in_study = in_study;
  current_ = std::make_shared<const OpenModel>(std::move(next));
  on_disk_ = current_;
  setModified(false);
  emit saved(path);
}

void ModelController::showInstead(std::shared_ptr<const OpenModel> model) {
  TACTUS_CHECK(current_ != nullptr);
  if (model == current_) model.reset();
  if (model == instead_) return;
  instead_ = std::move(model);
  emit shownChanged();
}

void ModelController::reopen() {
  if (!current_) return;
  if (current_->in_study) {
    emit reopenFromStudy();
  } else {
    open(current_->path);
  }
}

void ModelController::save() {
  if (!current_) return;
  if (current_->in_study) {
    emit storeNow();
  } else {
    saveAs(current_->path);
  }
}

void ModelController::saveAs(const QString& path) {
  TACTUS_CHECK(current_ != nullptr);
  // An edit changes the forces that travel with the model as checks; a file with wrong ones cannot be written.
  OpenModel next = inPlaceOf(*current_, editing::withFreshChecks(current_->shared));
  next.path = QFileInfo(path).absoluteFilePath();
  const base::Result<void> written = model_io::writeModel(next.model, next.path.toStdString());
  if (!written) {
    emit saveFailed(next.path, QString::fromStdString(written.error().message()));
    return;
  }
  if (next.in_study) {
    emit copied(next.path);
    return;
  }
  current_ = std::make_shared<const OpenModel>(std::move(next));
  on_disk_ = current_;
  emit saved(current_->path);
  setModified(false);
}

void ModelController::setModified(bool modified) {
  if (modified == modified_) return;
  modified_ = modified;
  emit modifiedChanged(modified);
}

}  // namespace tactus::workbench
