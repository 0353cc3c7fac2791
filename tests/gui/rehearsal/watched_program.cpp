#include "tests/gui/rehearsal/watched_program.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcessEnvironment>
#include <algorithm>
#include <csignal>
#include <sys/resource.h>

#include "core/base/check.h"

#include "tests/gui/patience.h"

namespace tactus::tests {
namespace {

using tests::kPatience;

std::optional<RehearsalLine> parsed(const QByteArray& text) {
  const QJsonObject line = QJsonDocument::fromJson(text).object();
  if (line.isEmpty()) return std::nullopt;  // the place of the study
  const auto number = [&line](const char* name) { return line.value(QLatin1String(name)).toInt(-1); };
  return RehearsalLine{line.value(QStringLiteral("screen")).toString(),
                       number("insertions"),
                       number("judgements"),
                       number("answers"),
                       number("ratings"),
                       number("position"),
                       line.value(QStringLiteral("failed")).toBool()};
}

}  // namespace

WatchedProgram::WatchedProgram(const QString& path, const QString& settings) {
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
  environment.insert(QStringLiteral("XDG_RUNTIME_DIR"), settings);
  environment.insert(QStringLiteral("XDG_CONFIG_HOME"), settings);
  process_.setProcessEnvironment(environment);
  process_.start(QStringLiteral(TACTUS_WORKBENCH_PROGRAM), {QStringLiteral("--rehearse"), QStringLiteral("--speed"),
                                                            QStringLiteral("1000"), QStringLiteral("--study"), path});
  TACTUS_CHECK(process_.waitForStarted(kPatience));
}

WatchedProgram::~WatchedProgram() {
  if (process_.state() == QProcess::NotRunning) return;
  process_.kill();
  process_.waitForFinished(kPatience);
}

std::optional<RehearsalLine> WatchedProgram::read() {
  while (process_.canReadLine()) {
    if (auto line = parsed(process_.readLine())) return line;
  }
  return std::nullopt;
}

std::optional<RehearsalLine> WatchedProgram::next() {
  for (;;) {
    if (auto line = read()) return line;
    if (!process_.waitForReadyRead(kPatience) && !process_.canReadLine()) return std::nullopt;
  }
}

std::optional<RehearsalLine> WatchedProgram::readRest() {
  while (process_.waitForReadyRead(0)) {
  }
  std::optional<RehearsalLine> last;
  while (auto line = read()) last = line;
  return last;
}

bool WatchedProgram::standsStill() const {
  const QDir tasks(QStringLiteral("/proc/%1/task").arg(process_.processId()));
  const QStringList threads = tasks.entryList(QDir::Dirs | QDir::NoDotAndDotDot);
  return std::all_of(threads.begin(), threads.end(), [&tasks](const QString& thread) {
    QFile stat(tasks.filePath(thread + QStringLiteral("/stat")));
    if (!stat.open(QIODevice::ReadOnly)) return false;
    const QByteArray text = stat.readAll();
    return text.mid(text.lastIndexOf(')') + 2, 1) == "T";  // the name before it may hold anything
  });
}

std::optional<RehearsalLine> WatchedProgram::freeze() {
  ::kill(static_cast<pid_t>(process_.processId()), SIGSTOP);
  while (!standsStill()) {
  }
  return readRest();
}

void WatchedProgram::thaw() { ::kill(static_cast<pid_t>(process_.processId()), SIGCONT); }

std::optional<RehearsalLine> WatchedProgram::kill() {
  process_.kill();
  process_.waitForFinished(kPatience);
  return readRest();
}

void WatchedProgram::fillDisk(bool full) {
  const rlimit limit{full ? 0 : RLIM_INFINITY, RLIM_INFINITY};
  TACTUS_CHECK(::prlimit(static_cast<pid_t>(process_.processId()), RLIMIT_FSIZE, &limit, nullptr) == 0);
}

int WatchedProgram::exitCode() {
  process_.waitForFinished(kPatience);
  return process_.exitStatus() == QProcess::NormalExit ? process_.exitCode() : -1;
}

}  // namespace tactus::tests
