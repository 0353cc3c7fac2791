#include "tests/gui/sample_models.h"

#include <QFile>

#include "core/base/check.h"
#include "core/model_io/model_file.h"

namespace tactus::tests {

QString ModelFolder::write(const fuzzy::ForceModel& model, const QString& name) const {
  QString file = path(name);
  TACTUS_CHECK(model_io::writeModel(model, file.toStdString()).has_value());
  return file;
}

QString ModelFolder::writeText(const QByteArray& text, const QString& name) const {
  QFile file(path(name));
  TACTUS_CHECK(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
  return file.fileName();
}

}  // namespace tactus::tests
