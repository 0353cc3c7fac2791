// What lies behind and over the curves of the force: the spread of the experts, the curves before an edit, and
// reference curves. Only files of plots/ include this.
#pragma once

#include <vector>

#include "app/workbench/controllers/force_spread.h"
#include "app/workbench/controllers/ghost_controller.h"
#include "app/workbench/controllers/reference_curve.h"
#include "app/workbench/plots/curve_looks.h"
#include "app/workbench/plots/plot_source.h"
#include "app/workbench/plots/plot_style.h"

namespace tactus::workbench {

class CurveOverlays {
 public:
  explicit CurveOverlays(QCustomPlot& plot);

  /// Takes everything away, before the plot drops its lines or another model comes.
  void clear();

  void setSpread(const std::vector<double>& x, const ForceSpread& spread, SpreadShown shown);
  /// The lines before, dashed, in the pens of the lines now: that of the mean first, then those of the experts. A pen
  /// without style hides its line. Null: no ghost.
  void setGhost(const GhostCurves* ghost, const std::vector<QPen>& pens);
  void setReferences(const std::vector<ReferenceCurve>& references);
  /// While the hand moves: thin lines.
  void setFast(bool fast);

  /// Entries of the spread and of the references, and one for the ghost with `ghost_name`.
  std::vector<LegendEntry> legend(const QString& ghost_name) const;

 private:
  QCPGraph* addLine(const char* layer);
  void removeLines(std::vector<QCPGraph*>& lines);

  QCustomPlot& plot_;
  std::vector<QCPGraph*> band_;  ///< lower and upper line of the range, then of the deviation
  std::vector<QCPGraph*> ghosts_;
  std::vector<QCPGraph*> references_;
  SpreadShown shown_;
  bool fast_ = false;
};

}  // namespace tactus::workbench
