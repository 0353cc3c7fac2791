#include "app/workbench/model/fresh_path.h"

#include <QFileInfo>

namespace tactus::workbench {

QString freshModelPath(const QString& stem) {
  QString fresh = stem + QStringLiteral(".tactus.json");
  for (int copy = 2; QFileInfo::exists(fresh); ++copy)
    fresh = stem + QLatin1Char('-') + QString::number(copy) + QStringLiteral(".tactus.json");
  return fresh;
}

}  // namespace tactus::workbench
