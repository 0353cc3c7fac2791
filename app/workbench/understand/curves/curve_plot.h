// The plot of force along one input: a thin line per expert, a thick line for the mean with its spread, and gaps where
// an expert abstains. Curves before an edit are dashed; reference curves are dotted.
#pragma once

#include <QStringList>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "app/figures/force_curves.h"
#include "app/workbench/model/curve_family.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/understand/curves/curve_legend.h"
#include "app/workbench/understand/curves/force_spread.h"
#include "app/workbench/understand/curves/reference_controller.h"
#include "core/analysis/force_steps.h"
#include "core/fuzzy/force_model.h"

class QCustomPlot;
class QMouseEvent;

namespace tactus::workbench {

class AxisZoom;
class CurveOverlays;
class LandmarkMarks;
class ReadingCursor;
class ShownRanges;
class SilenceMarks;
class TermBands;
class TermLabels;
struct GhostCurves;
struct Reading;

class CurvePlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit CurvePlot(ShownRanges& ranges, QWidget* parent = nullptr);
  ~CurvePlot() override;

  /// The axes become the universes of `x` and of the output; `experts` gives the names of the lines.
  void setAxes(const fuzzy::Variable& x, const fuzzy::Variable& output, const std::vector<fuzzy::Expert>& experts);
  /// The terms of the x axis, as bands with their names above the plot.
  void setTerms(const fuzzy::Variable& x, const std::vector<fuzzy::Term>& terms);
  void setCurves(const figures::ForceCurves& curves);
  /// Shows or hides the line of an expert.
  void setExpertShown(std::size_t expert, bool shown);
  void setMeanShown(bool shown);
  bool isMeanShown() const;
  bool isExpertShown(std::size_t expert) const;
  /// `left_behind`: the mean force at the operating point `from`, where the reading is elsewhere; the tag then gives
  /// the difference to it.
  void setReading(const Reading& reading, double from, const std::optional<fuzzy::Evaluation>& left_behind);
  /// Chooses the parts of the spread that `setCurves` draws.
  void setSpreadShown(SpreadShown shown) { spread_ = shown; }
  SpreadShown spreadShown() const { return spread_; }
  /// The curves before an edit, with their name for the legend; null: none.
  void setGhost(const GhostCurves* ghost, const QString& name);
  /// The lines of a family: the mean at several values of an input, in place of the experts' lines. `names` are their
  /// names; empty: no family.
  void setFamily(const QStringList& names);
  void setFamilyCurves(const FamilyCurves& curves);
  void setFamilyShown(std::size_t line, bool shown);
  bool isFamilyShown(std::size_t line) const;
  /// The legend entry of a line of the family.
  LegendEntry familyLine(std::size_t line) const;
  /// The reference curves for the current x axis. The force axis grows if they exceed the output's universe.
  void setReferences(const std::vector<ReferenceCurve>& references);
  /// Marks the steps of the visible curves (expert numbers as in `setAxes`).
  void setSteps(const std::vector<analysis::ForceStep>& steps);
  /// The number of marked steps.
  std::size_t stepsMarked() const { return steps_marked_; }
  /// True during a drag: thin lines without smoothing, which take half the time to draw.
  void setFast(bool fast);
  /// The legend entry of an expert's line, or of the mean.
  LegendEntry lineOf(std::optional<std::size_t> expert) const;

  std::vector<LegendEntry> legend() const override;
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 signals:
  /// The mouse is at `x`, in the unit of the x axis.
  void hovered(double x);
  void hoverLeft();
  /// The mouse was pressed at `x`.
  void picked(double x);
  /// The mouse was clicked with Shift at `x`.
  void marked(double x);
  /// The user asks where the force at `x` comes from.
  void originAsked(double x);

 protected:
  void changeEvent(QEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void onMouse(QMouseEvent* event);
  void nameAxis(bool named);
  void updateSilence();
  bool shown(std::size_t graph) const;
  QString differenceText(const Reading& reading, double from, const fuzzy::Evaluation& left_behind) const;
  void styleLines();

  QCustomPlot* plot_;
  AxisZoom* zoom_;
  TermBands* bands_;
  SilenceMarks* silence_;
  TermLabels* labels_;
  LandmarkMarks* landmarks_;
  ReadingCursor* cursor_;
  std::unique_ptr<CurveOverlays> overlays_;
  fuzzy::Variable x_;
  fuzzy::Variable output_;
  std::vector<figures::Interval> everyone_silent_;
  std::vector<std::vector<figures::Interval>> silent_;  ///< one list per expert
  std::vector<double> weights_;                         ///< of the experts
  std::vector<Coincidence> coincidences_;               ///< of the experts; empty before the first curves
  std::vector<std::size_t> numbers_;                    ///< of the experts, for their colors
  SpreadShown spread_;
  QString ghost_name_;
  bool fast_ = false;
  std::size_t steps_marked_ = 0;
};

}  // namespace tactus::workbench
