// The reading place in the curve plot: a line, a dot on every curve, and a tag. Needs QCustomPlot: only plotting code
// includes this.
#pragma once

#include <optional>
#include <vector>

#include "app/workbench/plot/plot_style.h"

namespace tactus::workbench {

class ReadingCursor : public QCPLayerable {
  Q_OBJECT

 public:
  struct Dot {
    double force_n = 0;
    QColor color;
  };

  explicit ReadingCursor(QCustomPlot& plot);

  void set(double x, QString tag, std::vector<Dot> dots);
  /// Gives the dots their colors in another look.
  void takeLook();
  /// The other place from which differences are counted: a dashed line; nothing: none.
  void setFrom(std::optional<double> x) { from_ = x; }

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  class Dots;

  double x_ = 0;
  std::optional<double> from_;
  QString tag_;
  std::vector<Dot> dots_;
  QFont font_;
};

}  // namespace tactus::workbench
