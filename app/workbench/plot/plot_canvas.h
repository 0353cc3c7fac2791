// A QCustomPlot that draws straight into its window. Only files of plots/ include this.
#pragma once

#include <qcustomplot.h>

namespace tactus::workbench {

/// QCustomPlot draws into pictures of its own and then lays them over each other, several megabytes each on a fine
/// screen. Here the layers are drawn where they are seen, so a plot costs no more than its lines; `update` draws it.
class PlotCanvas : public QCustomPlot {
 public:
  using QCustomPlot::QCustomPlot;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
};

/// A graph whose fill is drawn in strips; its line covers the edge, so the fill need not be smoothed.
class FilledGraph : public QCPGraph {
 public:
  using QCPGraph::QCPGraph;

 protected:
  void drawFill(QCPPainter* painter, QVector<QPointF>* lines) const override;
};

// Qt hands fills of many rows to other threads and waits for them, which takes longer than the work where the processor
// has something else to do. These fill strip by strip; vector pictures in one piece.

/// Fills `area`, px.
void fillInStrips(QCPPainter& painter, const QRectF& area, const QColor& color);
/// Fills `shape` with the brush of `painter`.
void fillInStrips(QCPPainter& painter, const QPolygonF& shape);

}  // namespace tactus::workbench
