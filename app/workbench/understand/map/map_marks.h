// The marks over a color map: contour lines, and the cross at the operating point. Needs QCustomPlot: only plotting
// code includes this.
#pragma once

#include <QLineF>
#include <vector>

#include "app/workbench/plot/plot_style.h"

namespace tactus::workbench {

class ContourMarks : public QCPLayerable {
  Q_OBJECT

 public:
  struct Line {
    QString text;                ///< the level, as written on the line
    QColor ground;               ///< the color of the level, behind the text
    std::vector<QLineF> pieces;  ///< in the units of the axes
  };

  explicit ContourMarks(QCustomPlot& plot);

  /// `labelled`: each line shows its level at a place where no other line crosses the number.
  void set(std::vector<Line> lines, bool labelled = false) {
    lines_ = std::move(lines);
    labelled_ = labelled;
  }

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  void drawLabels(QCPPainter& painter, const std::vector<QVector<QLineF>>& pieces) const;

  std::vector<Line> lines_;
  bool labelled_ = false;
};

class MapCross : public QCPLayerable {
  Q_OBJECT

 public:
  explicit MapCross(QCustomPlot& plot);

  void set(double x, double y, QString tag);

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  double x_ = 0;
  double y_ = 0;
  QString tag_;
  QFont font_;
};

}  // namespace tactus::workbench
