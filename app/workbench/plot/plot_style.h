// What all plots have in common: colors, axes, fonts. Needs QCustomPlot: only plotting code includes this.
#pragma once

#include <QPen>
#include <cstddef>
#include <initializer_list>
#include <qcustomplot.h>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

// The lines of experts in a plot: told apart by color and dashes, or faint where there are many.

/// The line of the expert with this number (figures::expertNumbers) among `count`. Up to 24 differ by color and dashes;
/// of more, the lines are faint and thin: together they show the spread, and the mean stands out.
QPen expertPen(std::size_t number, std::size_t count);

/// A plot without interactions, decorations or legend, in the colors of the theme.
QCustomPlot* makePlot(QWidget* parent);

/// Draws `plot` with the next frame: once for any number of calls, and only while the plot is visible.
void redraw(QCustomPlot& plot);

/// Adds a line of `width` px and a fill below it in the same color; the plot owns the graph.
QCPGraph& addShape(QCustomPlot& plot, const QColor& color, double width, float fill_alpha);

/// Lines and fonts of an axis over the universe of `variable`.
void styleAxis(QCPAxis& axis, const fuzzy::Variable& variable);

/// Draws `plot` without `hidden` over `size` px at the origin of `painter`. The plot on the screen stays unchanged.
void paintPlot(QCustomPlot& plot, QCPPainter& painter, const QSize& size, std::initializer_list<QCPLayerable*> hidden);

/// `line` mixed with the background: fainter, and opaque.
QColor fadedLine(const QColor& line);

/// A line of the model before an edit: dashed, and fainter than `line`.
QPen ghostPen(const QColor& line, bool fast = false);

/// Ticks at round numbers and at the ends of the universe that are in sight.
class UniverseTicker : public QCPAxisTicker {
 public:
  UniverseTicker(double min, double max) : min_(min), max_(max) {}

 protected:
  QVector<double> createTickVector(double step, const QCPRange& range) override;

 private:
  double min_;
  double max_;
};

}  // namespace tactus::workbench
