// The plot of force along one input: a thin line per expert, a thick line for the mean with its spread, and gaps where
// an expert abstains. Curves before an edit are dashed; reference curves are dotted.
#pragma once

#include <QCoreApplication>
#include <QStringList>
#include <QWidget>
#include <memory>
#include <optional>
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
#include "core/fuzzy/force_model.h"

class QCustomPlot;
class QMouseEvent;

namespace tactus::workbench {

class AxisZoom;
class CurveOverlays;
class LandmarkMarks;
class PullLayer;
class ReadingCursor;
class ShownRanges;
class SilenceMarks;
class SimulatorMarks;
class TermBands;
class TermLabels;
struct GhostCurves;
struct SimulatorMark;
struct PullMarks;
struct Reading;

// The lines and areas behind and over the force curves: the spread of the experts, the ghost (the curves before an
// edit), and reference curves. Needs QCustomPlot: only plotting code includes this.

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

/// Where simulators are that run elsewhere: a diamond for each, with its name. Looks like no hand and no reading.
class SimulatorMarks : public QCPLayerable {
  Q_OBJECT

 public:
  explicit SimulatorMarks(QCustomPlot& plot);
  ~SimulatorMarks() override;

  void set(std::vector<SimulatorMark> marks);

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  void drawName(QCPPainter& painter, const QString& name, QPointF at) const;

  std::vector<SimulatorMark> marks_;
  QFont font_;
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
  /// Draws what is pulled, in this color. Null: nothing.
  void setPull(const PullMarks* pull, const QColor& color);
  /// True during a drag: thin lines.
  void setFast(bool fast);
  /// A frame around the plot: the keys are here.
  void setFocused(bool focused);

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
  QCPGraph* pulled_ = nullptr;  ///< the line after an edit
  PullLayer* pull_ = nullptr;
  QCPItemRect* focus_ = nullptr;
  SpreadShown shown_;
  bool fast_ = false;
};

class CurvePlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  static constexpr int kMeanGraph = 0;  ///< the graph of the mean; that of expert i is i + 1

  explicit CurvePlot(ShownRanges& ranges, QWidget* parent = nullptr);
  ~CurvePlot() override;

  /// The axes become the universes of `x` and of the output; `experts` gives the names of the lines.
  void setAxes(const fuzzy::Variable& x, const fuzzy::Variable& output, const std::vector<fuzzy::Expert>& experts);
  /// The terms of the x axis, as bands with their names above the plot; landmarks, with the events of the model.
  void setTerms(const fuzzy::Variable& x, const std::vector<fuzzy::Term>& terms,
                std::span<const fuzzy::TubeEvent> events);
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
  /// What is pulled; null: nothing.
  void setPull(const PullMarks* pull);
  void setSimulators(std::vector<SimulatorMark> marks);
  QPoint pixelOf(double x, double force_n) const;
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
  /// A line was taken with Alt: that of `expert`, or of the mean.
  void grabbed(std::optional<std::size_t> expert, double x, double force_n);
  void bandDrawn(tactus::figures::Interval x, tactus::figures::Interval force_n);
  void pulledTo(double force_n);
  void pullReleased();
  // The keys: up and down move the wanted force, left and right the operating point; Enter, Escape.
  void pullStepped(double by_n);
  void pullDropped();
  void pullAsked();
  void placeStepped(int steps);
  /// The user pins the force at `x`, or takes the pin away that is there.
  void pinAsked(double x);

 protected:
  void changeEvent(QEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  std::optional<double> pinAt(double pixel_x) const;
  void onMouse(QMouseEvent* event);
  bool beginPull(const QMouseEvent& event);
  void movePull(const QMouseEvent& event);
  std::optional<std::size_t> lineAt(QPointF place) const;
  bool isOnHandle(QPointF place) const;
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
  SimulatorMarks* simulators_;
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
  /// What the mouse pulls from its press to its release.
  enum class Drag { kNone, kForce, kBand };
  Drag drag_ = Drag::kNone;
  QPointF band_from_;              ///< its first corner, in the units of the axes
  std::optional<QPointF> handle_;  ///< of the pulled line, in the units of the axes
  std::vector<double> pins_;       ///< on the x axis
  bool by_keys_ = false;           ///< the handle is moved by keys
};

}  // namespace tactus::workbench
