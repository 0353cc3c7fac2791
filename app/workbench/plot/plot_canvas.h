// A QCustomPlot that draws directly into its window. Needs QCustomPlot: only plotting code includes this.
#pragma once

#include <qcustomplot.h>

namespace tactus::workbench {

/// QCustomPlot draws each layer into an image of its own and then combines the images, several megabytes each on a
/// high-resolution screen. This class draws the layers directly, so a plot costs no more than its lines. `update` draws
/// it.
class PlotCanvas : public QCustomPlot {
 public:
  using QCustomPlot::QCustomPlot;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
};

/// A graph that draws its fill in strips. The line covers the edge, so the fill needs no smoothing.
class FilledGraph : public QCPGraph {
 public:
  using QCPGraph::QCPGraph;

 protected:
  void drawFill(QCPPainter* painter, QVector<QPointF>* lines) const override;
};

// Qt passes fills of many rows to other threads and waits for them. On a busy processor that takes longer than the fill
// itself. These functions fill strip by strip; in vector pictures they fill in one piece.

/// Fills `area`, px.
void fillInStrips(QCPPainter& painter, const QRectF& area, const QColor& color);
/// Fills `shape` with the brush of `painter`.
void fillInStrips(QCPPainter& painter, const QPolygonF& shape);

}  // namespace tactus::workbench
