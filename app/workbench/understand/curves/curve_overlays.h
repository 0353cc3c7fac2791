// What lies behind and over the curves of the force: the spread of the experts, the curves before an edit, and
// reference curves. Only files of plots/ include this.
#pragma once

#include <span>
#include <vector>

#include "app/workbench/model/curve_family.h"
#include "app/workbench/model/ghost_controller.h"
#include "app/workbench/plot/plot_source.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/understand/curves/curve_looks.h"
#include "app/workbench/understand/curves/force_spread.h"
#include "app/workbench/understand/curves/reference_curve.h"
#include "core/analysis/force_steps.h"

namespace tactus::workbench {

/// The forces of a curve for a graph, which leaves a gap where a value is NaN.
QVector<double> withGaps(std::span<const fuzzy::Evaluation> curve);

class CurveOverlays {
 public:
  explicit CurveOverlays(QCustomPlot& plot);

  /// Takes everything away, before the plot drops its lines or another model comes.
  void clear();

  void setSpread(const std::vector<double>& x, const ForceSpread& spread, SpreadShown shown);
  /// The lines before, dashed, in the pens of the lines now: that of the mean first, then those of the experts. A pen
  /// without style hides its line. Null: no ghost.
  void setGhost(const GhostCurves* ghost, const std::vector<QPen>& pens);
  /// Lines of the mean at several values of an input, called `names`.
  void setFamily(const QStringList& names);
  void setFamilyCurves(const FamilyCurves& curves);
  void setFamilyShown(std::size_t line, bool shown);
  bool isFamilyShown(std::size_t line) const { return family_[line]->visible(); }
  LegendEntry familyLine(std::size_t line) const;
  std::size_t familySize() const { return family_.size(); }
  void setReferences(const std::vector<ReferenceCurve>& references);
  /// Steps of the force, each a thick piece from one side to the other.
  void setSteps(const std::vector<analysis::ForceStep>& steps);
  bool hasSteps() const { return steps_ != nullptr && steps_->visible(); }
  /// While the hand moves: thin lines.
  void setFast(bool fast);

  /// The look of the application changed.
  void takeLook();

  /// Entries of the family, the spread and the references, and one for the ghost with `ghost_name`.
  std::vector<LegendEntry> legend(const QString& ghost_name) const;

 private:
  QCPGraph* addLine(const char* layer);
  void removeLines(std::vector<QCPGraph*>& lines);

  QCustomPlot& plot_;
  std::vector<QCPGraph*> band_;  ///< lower and upper line of the range, then of the deviation
  std::vector<QCPGraph*> ghosts_;
  std::vector<QCPGraph*> family_;
  std::vector<QCPGraph*> references_;
  QCPCurve* steps_ = nullptr;
  SpreadShown shown_;
  bool fast_ = false;
};

}  // namespace tactus::workbench
