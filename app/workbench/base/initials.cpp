#include "app/workbench/base/initials.h"

#include <QStringList>

namespace tactus::workbench {

QString initialsOf(const QString& words) {
  QString out;
  const QStringList parts = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  for (const QString& part : parts) out += part.front().toUpper();
  return out;
}

}  // namespace tactus::workbench
