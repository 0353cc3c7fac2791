// Opens model files. The model that is open stays until another one was read without an error.
#pragma once

#include <QObject>
#include <QString>
#include <memory>

#include "app/workbench/controllers/open_model.h"

namespace tactus::workbench {

class ModelController : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// The open model, or null before the first one.
  std::shared_ptr<const OpenModel> current() const { return current_; }

 public slots:
  /// Reads the model file `path`; ends with `opened` or `openFailed`.
  void open(const QString& path);
  /// Reads the file of the open model again.
  void reopen();

 signals:
  void opened();
  /// One sentence for the person: what, where, found, wanted.
  void openFailed(const QString& path, const QString& sentence);

 private:
  std::shared_ptr<const OpenModel> current_;
};

}  // namespace tactus::workbench
