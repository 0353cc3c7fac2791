#include "tests/bench/workbench_labs.h"

#include <QElapsedTimer>
#include <QSettings>
#include <QTemporaryDir>
#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <map>
#include <tuple>

#include "app/session/simulated_study.h"
#include "app/session/study_import.h"
#include "app/session/study_view.h"
#include "app/workbench/labs/frame/lab_screen.h"
#include "app/workbench/labs/speed/cluster_page.h"
#include "app/workbench/labs/speed/speed_lab_view.h"
#include "app/workbench/shell/frame_clock.h"
#include "app/workbench/workbench.h"
#include "core/base/check.h"

namespace tactus::bench {
namespace {

using workbench::SpeedLab;
using workbench::Workbench;

constexpr int kLabFrameMs = 16;
constexpr double kLabCalmMs = 70;  // some frames without painting; validity and intervals begin after 150
constexpr int kIntervalsMs = 320;  // after a move: validity is done, intervals are on their way
constexpr double kLabMostMs = 20'000;
constexpr int kLabWarmUp = 3;

struct Setting {
  const char* name;
  void (*set)(SpeedLab& lab, int move);
};

// Never twice the same value; the steps are those of the sliders.
constexpr std::array<Setting, 3> kSettings = {{
    {"alpha", [](SpeedLab& lab, int move) { lab.setAlpha(0.55 + 0.01 * (move + kLabWarmUp)); }},
    {"m", [](SpeedLab& lab, int move) { lab.setFuzziness(1.25 + 0.05 * (move + kLabWarmUp)); }},
    {"trimming", [](SpeedLab& lab, int move) { lab.setTrim(0.01 + 0.01 * (move + kLabWarmUp)); }},
}};

template <class Condition>
void waitUntil(Condition reached) {
  QElapsedTimer since;
  since.start();
  while (!reached() && since.elapsed() < kLabMostMs) runFor(5);
}

double cpuMs(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double otherThreadsMs() { return cpuMs(CLOCK_PROCESS_CPUTIME_ID) - cpuMs(CLOCK_THREAD_CPUTIME_ID); }

std::string partOf(const QObject* object) {
  for (const QObject* at = object; at != nullptr; at = at->parent()) {
    if (const auto* const plot = qobject_cast<const workbench::ClusterPlot*>(at)) {
      return plot->accessibleName().toStdString();
    }
    if (qobject_cast<const workbench::SpeedTermPlot*>(at)) return "terms";
    if (qobject_cast<const workbench::ClusterPage*>(at)) return "page of both";
  }
  return "window";
}

/// The strokes of each participant with `count` samples together, evenly spread in time.
std::vector<study::SpeedSample> resampled(const std::vector<study::SpeedSample>& samples, int count) {
  using Key = std::tuple<std::string, std::string, int>;
  std::vector<std::pair<Key, std::vector<study::SpeedSample>>> strokes;
  std::map<std::string, std::size_t> all;
  for (const auto& sample : samples) {
    const Key key(sample.participant, sample.level, sample.stroke);
    if (strokes.empty() || strokes.back().first != key) strokes.push_back({key, {}});
    strokes.back().second.push_back(sample);
    ++all[sample.participant];
  }
  std::vector<study::SpeedSample> out;
  for (const auto& [key, stroke] : strokes) {
    const auto own = static_cast<double>(stroke.size()) / static_cast<double>(all[std::get<0>(key)]);
    const auto wanted = static_cast<std::size_t>(std::lround(own * count));
    for (std::size_t i = 0; i < wanted; ++i) {
      const double place =
          static_cast<double>(i) * static_cast<double>(stroke.size() - 1) / static_cast<double>(wanted - 1);
      const auto before = std::min(stroke.size() - 2, static_cast<std::size_t>(place));
      const double share = place - static_cast<double>(before);
      study::SpeedSample sample = stroke[before];
      const study::SpeedSample& next = stroke[before + 1];
      sample.time_s = std::lerp(sample.time_s, next.time_s, share);
      sample.depth_mm = std::lerp(sample.depth_mm, next.depth_mm, share);
      sample.speed_mm_s = std::lerp(sample.speed_mm_s, next.speed_mm_s, share);
      out.push_back(std::move(sample));
    }
  }
  return out;
}

QString makeStudy(const QTemporaryDir& folder, int samples) {
  const auto demo = session::makeSimulatedNgtStudy(folder.filePath(QStringLiteral("demo.tactus")).toStdString());
  TACTUS_CHECK(demo.has_value());
  auto view = session::studyForElicitation(*demo);
  TACTUS_CHECK(view.has_value());
  view->study.speeds = resampled(view->study.speeds, samples);
  const QString path = folder.filePath(QStringLiteral("labs.tactus"));
  TACTUS_CHECK(session::importAsNewStudy(view->study, path.toStdString(), {"bench", {}, 1}, "bench"));
  return path;
}

void open(Workbench& bench, const QString& path) {
  bench.window.resize(1920, 1080);
  bench.window.show();
  bench.files.open(path);
  waitUntil([&] { return bench.study.isOpen() && !bench.study.isOpening(); });
  TACTUS_CHECK(bench.study.isOpen());
  bench.window.enter(workbench::Stage::kBuild);
}

class Mover {
 public:
  Mover(TimedApplication& application, Workbench& bench)
      : application_(application),
        lab_(bench.labs.speed),
        screen_(*bench.views.labs),
        strip_(*bench.views.labs->findChild<workbench::FrameClock*>()) {
    QObject::connect(&lab_, &SpeedLab::resultChanged, &screen_, [this] {
      if (result_ms_ > 0) return;
      result_ms_ = static_cast<double>(since_.nsecsElapsed()) / 1e6;
      worker_ms_ = otherThreadsMs() - others_before_ms_;
    });
  }

  LabTimes move(const Setting& setting, Rhythm rhythm, int moves) {
    LabTimes out;
    out.setting = setting.name;
    out.rhythm = rhythm;
    lab_.setDefaults();
    calm();
    if (rhythm == Rhythm::kDrag) {
      drag(setting, moves, out);
      return out;
    }
    for (int i = -kLabWarmUp; i < moves; ++i) {
      if (rhythm == Rhythm::kAlone) calm();
      if (rhythm == Rhythm::kIntervals) runFor(kIntervalsMs);
      moveOnce(setting, i, out);
    }
    return out;
  }

 private:
  void calm() {
    waitUntil([this] { return !screen_.isBusy(); });
    runFor(50);
  }

  void moveOnce(const Setting& setting, int i, LabTimes& out) {
    result_ms_ = 0;
    others_before_ms_ = otherThreadsMs();
    since_.start();
    application_.begin();
    setting.set(lab_, i);
    while ((result_ms_ == 0 || application_.shownMs() < result_ms_ || application_.calmMs() < kLabCalmMs) &&
           application_.calmMs() < kLabMostMs) {
      runFor(5);
    }
    if (i < 0) return;
    out.result_ms.push_back(result_ms_);
    out.worker_ms.push_back(worker_ms_);
    out.shown_ms.push_back(application_.shownMs());
    out.window_ms.push_back(application_.shownCpuMs());
    out.strip_ms.push_back(strip_.finest()->last_ms);
    for (const auto& [part, ns] : application_.spentNs()) {
      std::vector<double>& all = out.part_ms[part];
      all.resize(out.shown_ms.size());
      all.back() = static_cast<double>(ns) / 1e6;
    }
  }

  void drag(const Setting& setting, int moves, LabTimes& out) {
    const auto measured = QObject::connect(&strip_, &workbench::FrameClock::measured, &screen_,
                                           [&] { out.strip_ms.push_back(strip_.finest()->last_ms); });
    const auto result = QObject::connect(&lab_, &SpeedLab::resultChanged, &screen_, [&] { ++out.results; });
    for (int i = 0; i < moves; ++i) {
      setting.set(lab_, i);
      runFor(kLabFrameMs);
    }
    QObject::disconnect(result);
    waitUntil([this] { return lab_.isCurrent(); });
    runFor(100);
    QObject::disconnect(measured);
  }

  TimedApplication& application_;
  SpeedLab& lab_;
  workbench::LabScreen& screen_;
  workbench::FrameClock& strip_;
  QElapsedTimer since_;
  double result_ms_ = 1;
  double worker_ms_ = 0;
  double others_before_ms_ = 0;
};

}  // namespace

std::vector<LabTimes> moveLabSettings(TimedApplication& application, int samples, int moves) {
  application.namePanels(partOf);
  const QTemporaryDir folder;
  QSettings settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
  const QString path = makeStudy(folder, samples);
  Workbench bench(settings, folder.filePath(QStringLiteral("autosave")));
  open(bench, path);
  bench.views.labs->reveal(bench.views.speed);
  waitUntil([&] { return bench.labs.speed.result() != nullptr; });
  Mover mover(application, bench);
  std::vector<LabTimes> out;
  for (const Setting& setting : kSettings) {
    for (const Rhythm rhythm : {Rhythm::kAlone, Rhythm::kIntervals, Rhythm::kDrag}) {
      out.push_back(mover.move(setting, rhythm, moves));
    }
  }
  return out;
}

}  // namespace tactus::bench
