#include "app/workbench/base/language_name.h"

namespace tactus::workbench {

QString languageName(const QString& id) {
  if (id == QLatin1String("en")) return QStringLiteral("English");
  if (id == QLatin1String("zh-Hant")) return QStringLiteral("繁體中文");
  if (id == QLatin1String("zh-Hans")) return QStringLiteral("简体中文");
  return id;
}

}  // namespace tactus::workbench
