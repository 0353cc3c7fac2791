// A vertex dragged in the real window, without a display: how long until all plots are painted, and where the time
// goes.
#pragma once

#include <QApplication>
#include <QElapsedTimer>
#include <map>
#include <string>
#include <vector>

#include "app/workbench/shell/stage.h"
#include "core/fuzzy/force_model.h"

namespace tactus::bench {

/// Times the events of the window: painting by the panel that is painted, everything else by the panel that gets it.
class TimedApplication : public QApplication {
 public:
  using QApplication::QApplication;

  bool notify(QObject* receiver, QEvent* event) override;

  /// Names the panel that an object belongs to, instead of the dock around it; only others than `window` count as
  /// shown when they are painted.
  using PanelOf = std::string (*)(const QObject* object);
  void namePanels(PanelOf panel_of) { panel_of_ = panel_of; }
  /// Begins an edit.
  void begin();
  /// From `begin` to the end of the last paint event of a panel, ms; 0 before the first one.
  double shownMs() const { return static_cast<double>(shown_ns_) / 1e6; }
  /// Of this, the time on a processor of the thread that draws, ms: what the same takes where nothing else runs.
  double shownCpuMs() const { return static_cast<double>(shown_cpu_ns_) / 1e6; }
  /// Since the last paint event of a panel, or since `begin`, ms.
  double calmMs() const { return static_cast<double>(since_begin_.nsecsElapsed() - shown_ns_) / 1e6; }
  /// Work and painting by panel since `begin`, ns on a processor.
  const std::map<std::string, qint64>& spentNs() const { return spent_ns_; }

 private:
  static std::string dockOf(const QObject* object);

  PanelOf panel_of_ = dockOf;
  std::map<std::string, qint64> spent_ns_;
  QElapsedTimer since_begin_;
  qint64 shown_ns_ = 0;
  qint64 begin_cpu_ns_ = 0;
  qint64 shown_cpu_ns_ = 0;
  qint64 painted_ns_ = 0;
  int depth_ = 0;
  bool begun_ = false;
};

/// Lets the window work for so long.
void runFor(int ms);

/// What the edits of a drag took.
struct DragTimes {
  std::vector<double> call_ms;     ///< the call that makes the edit and hands it to all who show it
  std::vector<double> shown_ms;    ///< until the last panel is painted
  std::vector<double> cpu_ms;      ///< of this, on a processor
  std::vector<double> strip_ms;    ///< the same as the strip of the window says
  std::vector<double> drag_ms;     ///< until all is painted, coarsely or not, while edits come with every frame
  std::vector<double> felt_ticks;  ///< of a drag while the tube is felt: from the edit to the first tick that uses it
  std::map<std::string, std::vector<double>> panel_ms;  ///< work and painting of each edit, on a processor
};

/// Drags a vertex of the depth terms in `stage`, in a window of 1920 x 1080 px: `edits` times alone, as often in a drag
/// with an edit in every frame, and as often again while the virtual device is felt.
DragTimes dragVertex(TimedApplication& application, const fuzzy::ForceModel& model, workbench::Stage stage, int edits);

}  // namespace tactus::bench
