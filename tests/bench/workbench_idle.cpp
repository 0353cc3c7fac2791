#include "tests/bench/workbench_idle.h"

#include <QSettings>
#include <QTemporaryDir>
#include <ctime>

#include "app/workbench/workbench.h"
#include "core/base/check.h"
#include "core/model_io/model_file.h"

#include "tests/bench/workbench_drag.h"

namespace tactus::bench {
namespace {

/// Share of a core that this process takes during `seconds`, percent.
double shareDuring(int seconds) {
  // What the change to this state set off has ended by then.
  runFor(2000);
  const std::clock_t before = std::clock();
  runFor(seconds * 1000);
  return 100.0 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC / seconds;
}

}  // namespace

std::vector<std::pair<std::string, double>> idleShares(const fuzzy::ForceModel& model, int seconds) {
  const QTemporaryDir folder;
  QSettings settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
  workbench::Workbench bench(settings, folder.filePath(QStringLiteral("autosave")));
  const QString path = folder.filePath(QStringLiteral("bench.tactus.json"));
  TACTUS_CHECK(model_io::writeModel(model, path.toStdString()).has_value());
  bench.window.resize(1920, 1080);
  bench.window.show();
  bench.models.open(path);
  std::vector<std::pair<std::string, double>> shares;
  bench.window.enter(workbench::Stage::kUnderstand);
  shares.emplace_back("Understand", shareDuring(seconds));
  bench.window.enter(workbench::Stage::kTune);
  shares.emplace_back("Tune", shareDuring(seconds));
  bench.feel.start(QStringLiteral("virtual"));
  shares.emplace_back("Tune, felt on the virtual device", shareDuring(seconds));
  bench.feel.stop();
  shares.emplace_back("Tune, felt no more", shareDuring(seconds));
  return shares;
}

}  // namespace tactus::bench
