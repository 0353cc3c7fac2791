#include "app/workbench/controllers/model_controller.h"

#include <QFileInfo>

namespace tactus::workbench {

void ModelController::open(const QString& path) {
  const QString absolute_path = QFileInfo(path).absoluteFilePath();
  auto read = readOpenModel(absolute_path);
  if (!read) {
    emit openFailed(absolute_path, QString::fromStdString(read.error().message()));
    return;
  }
  current_ = std::make_shared<const OpenModel>(std::move(*read));
  emit opened();
}

void ModelController::reopen() {
  if (current_) open(current_->path);
}

}  // namespace tactus::workbench
