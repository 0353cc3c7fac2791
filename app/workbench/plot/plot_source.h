// A plot that can be drawn into a picture: what all plots with a save and copy button give.
#pragma once

#include <QPen>
#include <QSize>
#include <QString>
#include <vector>

class QCPPainter;

namespace tactus::workbench {

/// A line, or with a fill an area, that the legend of a picture names.
struct LegendEntry {
  QString name;
  QPen pen;
  QBrush fill = Qt::NoBrush;
  bool dots = false;  ///< the points of the line are marked
};

class PlotSource {
 public:
  PlotSource() = default;
  virtual ~PlotSource() = default;
  PlotSource(const PlotSource&) = delete;
  PlotSource& operator=(const PlotSource&) = delete;

  /// Room for the plot in a picture, px, without legend and caption.
  virtual QSize pictureSize() const { return {1000, 560}; }
  /// What the picture explains below the plot, in this order.
  virtual std::vector<LegendEntry> legend() const { return {}; }
  /// Draws the plot as it stands over `size` px at the origin, ground included, without what only the mouse brings.
  /// A QCPPainter is a QPainter (plot_style.h); the plot on the screen looks the same afterwards.
  virtual void paintPicture(QCPPainter& painter, const QSize& size) = 0;
};

}  // namespace tactus::workbench
