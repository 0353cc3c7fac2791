#include "tests/gui/crashed.h"

#include <QDir>
#include <QFile>

#include "core/base/check.h"

namespace tactus::tests {

QString crashedCopy(const QString& root) {
  static int number = 0;
  const QString copy = root + QStringLiteral("-crashed-%1").arg(++number);
  QDir().mkpath(copy);
  const QStringList files = {QStringLiteral("*.tactus"), QStringLiteral("*.tactus-wal")};
  for (const QString& name : QDir(root).entryList(files, QDir::Files)) {
    TACTUS_CHECK(QFile::copy(QDir(root).filePath(name), QDir(copy).filePath(name)));
  }
  return copy;
}

}  // namespace tactus::tests
