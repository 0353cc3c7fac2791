// The plot of force along one input: a thin line per expert, the mean thick, gaps where an expert abstains.
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

#include "app/workbench/controllers/force_curves.h"
#include "app/workbench/plots/plot_source.h"
#include "core/fuzzy/force_model.h"

class QCustomPlot;
class QMouseEvent;

namespace tactus::workbench {

class LandmarkMarks;
class ReadingCursor;
class SilenceMarks;
class TermBands;
class TermLabels;
struct Reading;

class CurvePlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit CurvePlot(QWidget* parent = nullptr);

  /// The universes of `x` and of the output become the axes; `experts` name the lines.
  void setAxes(const fuzzy::Variable& x, const fuzzy::Variable& output, const std::vector<fuzzy::Expert>& experts);
  /// The terms of the x axis, shown as bands with their names on top.
  void setTerms(const fuzzy::Variable& x, const std::vector<fuzzy::Term>& terms);
  void setCurves(const ForceCurves& curves);
  /// Shows or hides the line of an expert.
  void setExpertShown(std::size_t expert, bool shown);
  void setMeanShown(bool shown);
  bool isMeanShown() const;
  bool isExpertShown(std::size_t expert) const;
  void setReading(const Reading& reading);

  std::vector<LegendEntry> legend() const override;
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 signals:
  /// The mouse is at `x`, in the unit of the x axis.
  void hovered(double x);
  void hoverLeft();
  /// The mouse was pressed at `x`.
  void picked(double x);

 protected:
  void leaveEvent(QEvent* event) override;

 private:
  void onMouse(QMouseEvent* event);
  void updateSilence();
  bool shown(std::size_t graph) const;

  QCustomPlot* plot_;
  TermBands* bands_;
  SilenceMarks* silence_;
  TermLabels* labels_;
  LandmarkMarks* landmarks_;
  ReadingCursor* cursor_;
  fuzzy::Variable x_;
  fuzzy::Variable output_;
  std::vector<Interval> everyone_silent_;
  std::vector<std::vector<Interval>> silent_;  ///< one list per expert
};

}  // namespace tactus::workbench
