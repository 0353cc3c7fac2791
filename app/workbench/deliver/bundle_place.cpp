#include "app/workbench/deliver/bundle_place.h"

#include <QDir>
#include <QFileInfo>

#include "app/bundle/bundle.h"

namespace tactus::workbench {

QString bundleFolder(const QString& chosen, const QString& model_path) {
  if (bundle::mayHoldBundle(chosen.toStdString())) return chosen;
  QString name = QFileInfo(model_path).fileName();
  for (const auto* ending : {".tactus.json", ".json", ".tactus"}) {
    if (!name.endsWith(QLatin1String(ending))) continue;
    name.chop(QLatin1String(ending).size());
    break;
  }
  if (name.isEmpty()) name = QStringLiteral("model");
  return QDir(chosen).filePath(name + QStringLiteral("-bundle"));
}

}  // namespace tactus::workbench
