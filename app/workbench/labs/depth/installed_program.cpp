#include "app/workbench/labs/depth/installed_program.h"

#include <QProcess>
#include <QStandardPaths>

namespace tactus::workbench {
namespace {

constexpr int kPatienceMs = 60'000;  // a scan of the whole body takes some seconds

}  // namespace

QString installedProgram(const char* name) { return QStandardPaths::findExecutable(QLatin1String(name)); }

ProgramRun runProgram(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.start(program, arguments, QIODevice::ReadOnly);
  if (!process.waitForFinished(kPatienceMs)) {
    process.kill();
    process.waitForFinished();
    return {};
  }
  const bool ok = process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0;
  return {ok, ok ? process.readAllStandardOutput() : process.readAllStandardError()};
}

}  // namespace tactus::workbench
