#include "app/workbench/model/model_controller.h"

#include <QFileInfo>

#include "app/editing/edit.h"
#include "core/base/check.h"
#include "core/model_io/model_file.h"

namespace tactus::workbench {
base::Result<void> ModelController::edit(fuzzy::ForceModel model) {
  auto compiled = fuzzy::compile(model);
  if (!compiled) return tl::unexpected(compiled.error());
  edit(std::move(model), std::move(*compiled));
  return {};
}

void ModelController::edit(fuzzy::ForceModel model, fuzzy::CompiledModel compiled) {
  TACTUS_CHECK(current_ != nullptr);
  OpenModel next;
  next.path = current_->path;
  next.in_study = current_->in_study;
  next.model = std::move(model);
  next.compiled = std::move(compiled);
  next.warnings = current_->warnings;
  next.simulated = current_->simulated || saysSimulated(next.model);
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
  OpenModel next = *current_;
  next.path = QFileInfo(path).absoluteFilePath();
  // An edit changes the forces that travel with the model as checks; a file with wrong ones cannot be written.
  editing::refreshChecks(next.model, next.compiled);
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
