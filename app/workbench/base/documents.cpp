#include "app/workbench/base/documents.h"

#include <QDir>
#include <QStandardPaths>

namespace tactus::workbench {

QString documentsFolder() {
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return documents.isEmpty() ? QDir::homePath() : documents;
}

}  // namespace tactus::workbench
