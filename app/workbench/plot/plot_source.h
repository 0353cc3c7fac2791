// A plot that can be drawn into a picture. All plots with a copy and save button implement it.
#pragma once

#include <QPen>
#include <QSize>
#include <QString>
#include <vector>

class QCPPainter;

namespace tactus::workbench {

/// A legend entry of a picture: a line, or an area if it has a fill.
struct LegendEntry {
  QString name;
  QPen pen;
  QBrush fill = Qt::NoBrush;
  bool dots = false;  ///< the points of the line have dots
};

class PlotSource {
 public:
  PlotSource() = default;
  virtual ~PlotSource() = default;
  PlotSource(const PlotSource&) = delete;
  PlotSource& operator=(const PlotSource&) = delete;

  /// Size of the plot in a picture, px, without legend and caption.
  virtual QSize pictureSize() const { return {1000, 560}; }
  /// The legend entries of the picture, in this order.
  virtual std::vector<LegendEntry> legend() const { return {}; }
  /// Draws the plot in its current state over `size` px at the origin, with its background and without hover marks. A
  /// QCPPainter is a QPainter (plot_style.h). The plot on the screen stays unchanged.
  virtual void paintPicture(QCPPainter& painter, const QSize& size) = 0;
};

}  // namespace tactus::workbench
