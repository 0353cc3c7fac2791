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

/// A graph whose fill is drawn in strips.
class FilledGraph : public QCPGraph {
 public:
  using QCPGraph::QCPGraph;

 protected:
  void drawFill(QCPPainter* painter, QVector<QPointF>* lines) const override;
};

/// Draws with `draw` into strips of `area`, px. Qt hands larger areas to other threads and waits for them, which takes
/// longer than the work where the processor has something else to do. Vector pictures are drawn in one piece.
template <class Draw>
void drawInStrips(QCPPainter& painter, const QRectF& area, const Draw& draw) {
  constexpr double kRows = 90;  // of the device; from 96 on Qt uses threads
  if (painter.modes().testFlag(QCPPainter::pmVectorized)) {
    draw();
    return;
  }
  const double height = kRows / painter.device()->devicePixelRatioF();
  for (double top = area.top(); top < area.bottom(); top += height) {
    painter.save();
    painter.setClipRect(QRectF(area.left(), top, area.width(), std::min(height, area.bottom() - top)),
                        Qt::IntersectClip);
    draw();
    painter.restore();
  }
}

}  // namespace tactus::workbench
