#include "tests/bench/workbench_drag.h"

#include <QDockWidget>
#include <QEventLoop>
#include <QSettings>
#include <QTemporaryDir>
#include <QTimer>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <ctime>

#include "app/workbench/workbench.h"
#include "core/base/check.h"
#include "core/model_io/model_file.h"

// The window of earlier versions measures nothing itself.
#if __has_include("app/workbench/shell/frame_clock.h")
#include "app/workbench/shell/frame_clock.h"
#define TACTUS_FRAME_CLOCK
#endif

namespace tactus::bench {
namespace {

constexpr int kFrameMs = 16;
constexpr double kCalmMs = 70;  // some frames without painting: the edit is shown
constexpr double kMostMs = 20'000;
constexpr double kAmplitudeMm = 12;
constexpr int kWarmUp = 5;

qint64 threadCpuNs() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return now.tv_sec * 1'000'000'000LL + now.tv_nsec;
}

// Calls `then` with the time of each edit that is painted, also while further edits come.
template <class Clock, class Then>
void onPainted(const Clock& clock, Then then) {
  const auto tell = [&clock, then] { then(clock.painted()->last_ms); };
  if constexpr (requires { &Clock::shown; }) {
    QObject::connect(&clock, &Clock::shown, &clock, tell);
  } else {  // earlier versions tell only of the last edit
    QObject::connect(&clock, &Clock::measured, &clock, tell);
  }
}

// Never twice the same place.
double place(int edit) { return kAmplitudeMm * std::sin(0.37 * (edit + 0.5)); }

}  // namespace

void runFor(int ms) {
  QEventLoop loop;
  QTimer::singleShot(ms, Qt::PreciseTimer, &loop, &QEventLoop::quit);
  loop.exec();
}

std::string TimedApplication::dockOf(const QObject* object) {
  for (const QObject* at = object; at != nullptr; at = at->parent()) {
    if (qobject_cast<const QDockWidget*>(at)) return at->objectName().toStdString();
  }
  return "window";
}

bool TimedApplication::notify(QObject* receiver, QEvent* event) {
  const bool paint = event->type() == QEvent::Paint;
  if (!begun_ || (depth_ > 0 && !paint)) return QApplication::notify(receiver, event);
  const std::string panel = panel_of_(receiver);
  const qint64 painted_before = painted_ns_;
  ++depth_;
  const qint64 began_ns = threadCpuNs();
  const bool handled = QApplication::notify(receiver, event);
  const qint64 whole_ns = threadCpuNs() - began_ns;
  --depth_;
  spent_ns_[panel] += whole_ns - (painted_ns_ - painted_before);
  if (paint) {
    painted_ns_ = painted_before + whole_ns;
    if (panel != "window") {
      shown_ns_ = since_begin_.nsecsElapsed();
      shown_cpu_ns_ = threadCpuNs() - begin_cpu_ns_;
    }
  }
  return handled;
}

void TimedApplication::begin() {
  begun_ = true;
  shown_ns_ = 0;
  spent_ns_.clear();
  begin_cpu_ns_ = threadCpuNs();
  since_begin_.start();
}

DragTimes dragVertex(TimedApplication& application, const fuzzy::ForceModel& model, workbench::Stage stage, int edits) {
  const QTemporaryDir folder;
  QSettings settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
  workbench::Workbench bench(settings, folder.filePath(QStringLiteral("autosave")));
  const QString path = folder.filePath(QStringLiteral("bench.tactus.json"));
  TACTUS_CHECK(model_io::writeModel(model, path.toStdString()).has_value());
  bench.window.resize(1920, 1080);
  bench.window.show();
  bench.models.open(path);
  bench.window.enter(stage);
  runFor(800);
  if (const QByteArray picture = qgetenv("TACTUS_BENCH_PICTURE"); !picture.isEmpty()) {
    bench.window.grab().save(QString::fromLocal8Bit(picture));
  }

  bench.terms.setVariable("depth");
  bench.terms.beginMove({1, workbench::Grip::Part::kVertex, 3, false});
  DragTimes out;
#ifdef TACTUS_FRAME_CLOCK
  const auto* const strip = bench.views.edit_clock;
#endif
  for (int i = -kWarmUp; i < edits; ++i) {
    application.begin();
#ifdef TACTUS_FRAME_CLOCK
    // On a busy machine another thread may finish a map later than that.
    const auto finest_before = strip->finest() ? strip->finest()->edits : 0;
    const auto is_finest = [&] { return strip->finest() && strip->finest()->edits > finest_before; };
#else
    const auto is_finest = [] { return true; };
#endif
    QElapsedTimer call;
    call.start();
    bench.terms.moveBy(place(i));
    const double call_ms = static_cast<double>(call.nsecsElapsed()) / 1e6;
    const auto is_calm = [&] { return application.shownMs() > 0 && application.calmMs() >= kCalmMs && is_finest(); };
    while (!is_calm() && application.calmMs() < kMostMs) runFor(5);
    if (i < 0) continue;
    out.call_ms.push_back(call_ms);
    out.shown_ms.push_back(application.shownMs());
    out.cpu_ms.push_back(application.shownCpuMs());
    for (const auto& [panel, ns] : application.spentNs()) {
      std::vector<double>& all = out.panel_ms[panel];
      all.resize(out.call_ms.size());
      all.back() = static_cast<double>(ns) / 1e6;
    }
#ifdef TACTUS_FRAME_CLOCK
    if (is_finest()) out.strip_ms.push_back(strip->finest()->last_ms);
#endif
  }
#ifdef TACTUS_FRAME_CLOCK
  onPainted(*strip, [&out](double ms) { out.drag_ms.push_back(ms); });
  for (int i = 0; i < edits; ++i) {
    bench.terms.moveBy(place(edits + i));
    runFor(kFrameMs);
  }
  runFor(200);
#endif
  bench.feel.start(QStringLiteral("virtual"));
  runFor(300);
  for (int i = 0; i < edits; ++i) {
    bench.terms.moveBy(place(i));
    runFor(2 * kFrameMs);
    if (const auto felt = bench.feel.editLatency()) out.felt_ticks.push_back(static_cast<double>(felt->last_ticks));
  }
  bench.feel.stop();
  bench.terms.endMove();
  return out;
}

}  // namespace tactus::bench
