#include "tests/bench/workbench_lab_visit.h"

#include <QElapsedTimer>
#include <QEventLoop>
#include <QLabel>
#include <QRegularExpression>
#include <QSettings>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <ctime>
#include <functional>
#include <iostream>
#include <map>
#include <sys/resource.h>

#include "app/workbench/labs/force/force_lab.h"
#include "app/workbench/labs/force/force_lab_view.h"
#include "app/workbench/labs/force/votes_view.h"
#include "app/workbench/labs/frame/lab_screen.h"
#include "app/workbench/labs/rules/rules_lab_view.h"
#include "app/workbench/labs/speed/speed_lab_view.h"
#include "app/workbench/workbench.h"
#include "core/base/check.h"

namespace tactus::bench {
namespace {

constexpr int kTickMs = 2;
constexpr qint64 kVisitMostMs = 300'000;
constexpr qint64 kVisitCalmMs = 400;  // nothing runs for so long: the lab is done

double peakMb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

double threadMs() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Watches the window from a timer in its thread: a late tick is an event that took long.
class Watch {
 public:
  explicit Watch(const workbench::LabScreen& screen) : screen_(screen) {}

  /// `shown`: whether the lab shows a result; empty: with `done`.
  LabVisit wait(const std::string& lab, const std::function<void()>& begin, const std::function<bool()>& done,
                const std::function<bool()>& shown = {}) {
    LabVisit out;
    out.lab = lab;
    QEventLoop loop;
    QTimer timer;
    QElapsedTimer since;
    qint64 calm_since = 0;
    qint64 last_ns = 0;
    double last_cpu = threadMs();
    since.start();
    QObject::connect(&timer, &QTimer::timeout, &loop, [&] {
      const qint64 now_ns = since.nsecsElapsed();
      const double cpu = threadMs();
      out.longest_ms = std::max(out.longest_ms, static_cast<double>(now_ns - last_ns) / 1e6 - kTickMs);
      out.longest_cpu_ms = std::max(out.longest_cpu_ms, cpu - last_cpu);
      listen(out, static_cast<double>(now_ns) / 1e9);
      if (shown && out.shown_s == 0 && shown()) out.shown_s = static_cast<double>(now_ns) / 1e9;
      if (!done()) calm_since = since.elapsed();
      if (since.elapsed() - calm_since > kVisitCalmMs || since.elapsed() > kVisitMostMs) loop.quit();
      last_ns = since.nsecsElapsed();
      last_cpu = threadMs();
    });
    timer.setTimerType(Qt::PreciseTimer);
    timer.start(kTickMs);
    begin();
    loop.exec();
    out.done_s = static_cast<double>(calm_since) / 1e3;
    if (out.first_s == 0) out.first_s = out.done_s;
    if (out.shown_s == 0) out.shown_s = out.done_s;
    out.peak_mb = peakMb();
    std::cerr << lab << ": " << out.done_s << " s\n";
    return out;
  }

 private:
  void listen(LabVisit& out, double now_s) const {
    static const QRegularExpression kNumbers(QStringLiteral("[0-9]+ %"));
    for (const auto* label : screen_.findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly)) {
      QString said = label->text();
      if (!label->isVisible() || said.isEmpty()) continue;
      if (out.first_s == 0) out.first_s = now_s;
      out.said.insert(said.remove(kNumbers).trimmed().toStdString());
    }
  }

  const workbench::LabScreen& screen_;
};

}  // namespace

std::vector<LabVisit> visitLabs(const std::string& path) {
  const QTemporaryDir folder;
  QSettings settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
  workbench::Workbench bench(settings, folder.filePath(QStringLiteral("autosave")));
  bench.window.resize(1920, 1080);
  bench.window.show();
  workbench::LabScreen& screen = *bench.views.labs;
  Watch watch(screen);
  std::vector<LabVisit> out;
  out.push_back(watch.wait(
      "opening", [&] { bench.files.open(QString::fromStdString(path)); },
      [&] { return bench.study.isOpen() && !bench.study.isOpening(); }));
  TACTUS_CHECK(bench.study.isOpen());
  const auto ready = [&screen] { return !screen.isBusy(); };
  out.push_back(watch.wait(
      "stage Build", [&] { bench.window.enter(workbench::Stage::kBuild); }, ready));
  workbench::SpeedLab& speed = bench.labs.speed;
  const std::map<const QWidget*, std::function<bool()>> shown = {
      {bench.views.speed, [&speed] { return speed.result() != nullptr; }},
      {bench.views.force, [&bench] { return bench.views.force->votes().table().rowCount() > 0; }},
      {bench.views.rules, [&bench] { return !bench.labs.rules.grids().experts.empty(); }}};
  for (QWidget* const lab : screen.labs()) {
    const std::string title = lab->windowTitle().toStdString();
    const auto own = shown.find(lab);
    out.push_back(watch.wait(
        title, [&] { screen.reveal(lab); }, ready, own == shown.end() ? std::function<bool()>() : own->second));
    auto* const pages = lab->findChild<QTabWidget*>();
    for (int page = 1; pages != nullptr && page < pages->count(); ++page) {
      out.push_back(watch.wait(
          title + ": " + pages->tabText(page).toStdString(), [&] { pages->setCurrentIndex(page); }, ready));
    }
    if (pages != nullptr) pages->setCurrentIndex(0);
  }
  screen.reveal(bench.views.speed);
  const auto current = [&speed] { return speed.isCurrent(); };
  out.push_back(watch.wait(
      "Speed: another alpha", [&] { speed.setAlpha(0.8); }, ready, current));
  out.push_back(watch.wait(
      "Speed: another m", [&] { speed.setFuzziness(2.5); }, ready, current));
  return out;
}

}  // namespace tactus::bench
