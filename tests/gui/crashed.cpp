#include "tests/gui/crashed.h"

#include <QDir>
#include <QFile>
#include <QProcess>

#include "core/base/check.h"

namespace tactus::tests {

QString crashedCopy(const QString& folder) {
  const QString copy = folder + QStringLiteral("-crashed");
  QDir().mkpath(copy);
  for (const QString& name : QDir(folder).entryList({QStringLiteral("*.json")}, QDir::Files)) {
    TACTUS_CHECK(QFile::copy(QDir(folder).filePath(name), QDir(copy).filePath(name)));
  }
  QProcess gone;
  gone.start(QStringLiteral("true"), {});
  TACTUS_CHECK(gone.waitForStarted());
  const qint64 pid = gone.processId();
  gone.waitForFinished();
  QFile lock(QDir(copy).filePath(QStringLiteral("lock")));
  TACTUS_CHECK(lock.open(QIODevice::WriteOnly));
  lock.write(QByteArray::number(pid) + "\ngui_test\n\n\n\n");
  return copy;
}

}  // namespace tactus::tests
