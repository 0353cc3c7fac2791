// The lines and areas behind and over the force curves: the spread of the experts, the ghost (the curves before an
// edit), and reference curves. Needs QCustomPlot: only plotting code includes this.
#pragma once

#include <QCoreApplication>
#include <span>
#include <vector>

#include "app/figures/force_curves.h"
#include "app/workbench/model/curve_family.h"
#include "app/workbench/model/ghost_controller.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/understand/curves/curve_legend.h"
#include "app/workbench/understand/curves/force_spread.h"
#include "app/workbench/understand/curves/reference_controller.h"
#include "core/analysis/force_steps.h"

namespace tactus::workbench {

/// Marks the places where no rule fires: hatched over the whole height where every expert abstains, and a hatched lane
/// at the lower edge for each expert who abstains alone. Needs QCustomPlot: only plotting code includes this.
class SilenceMarks : public QCPLayerable {
  Q_OBJECT

 public:
  struct Lane {
    QString text;
    QColor color;
    std::vector<figures::Interval> intervals;
  };

  explicit SilenceMarks(QCustomPlot& plot);

  /// `everyone`: the intervals in which all experts abstain; `lanes`: those of single experts. Draws at most six lanes;
  /// the last one then stands for all other experts.
  void set(std::vector<figures::Interval> everyone, std::vector<Lane> lanes);

  /// Height at the lower edge that is used for something else, px.
  void setFoot(double px) { foot_ = px; }

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  std::vector<figures::Interval> inSight(const std::vector<figures::Interval>& intervals) const;
  void drawEveryone(QCPPainter& painter, const figures::Interval& interval) const;
  void drawLane(QCPPainter& painter, const Lane& lane, double bottom) const;

  QFont font_;
  double foot_ = 0;
  std::vector<figures::Interval> everyone_;
  std::vector<Lane> lanes_;
};

/// The forces of a curve for a graph, which leaves a gap where a value is NaN.
QVector<double> withGaps(std::span<const fuzzy::Evaluation> curve);

class CurveOverlays {
  Q_DECLARE_TR_FUNCTIONS(CurveOverlays)

 public:
  explicit CurveOverlays(QCustomPlot& plot);

  /// Removes everything. Call before the plot removes its lines or gets another model.
  void clear();

  void setSpread(const std::vector<double>& x, const ForceSpread& spread, SpreadShown shown);
  /// Draws the ghost, dashed, in the pens of the current lines: first the mean, then the experts. A pen without style
  /// hides its line. Null: no ghost.
  void setGhost(const GhostCurves* ghost, const std::vector<QPen>& pens);
  /// The lines of a family: the mean at several values of an input, with these names.
  void setFamily(const QStringList& names);
  void setFamilyCurves(const FamilyCurves& curves);
  void setFamilyShown(std::size_t line, bool shown);
  bool isFamilyShown(std::size_t line) const { return family_[line]->visible(); }
  LegendEntry familyLine(std::size_t line) const;
  std::size_t familySize() const { return family_.size(); }
  void setReferences(const std::vector<ReferenceCurve>& references);
  /// The steps of the force, each a thick line from one side to the other.
  void setSteps(const std::vector<analysis::ForceStep>& steps);
  bool hasSteps() const { return steps_ != nullptr && steps_->visible(); }
  /// True during a drag: thin lines.
  void setFast(bool fast);

  /// Takes the colors of the current look.
  void takeLook();

  /// The entries of the family, the spread and the references; `ghost_name` is the entry of the ghost.
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
