// The current value in a membership plot: a line, and a dot at each membership. Needs QCustomPlot: only plotting code
// includes this.
#pragma once

#include <optional>
#include <vector>

#include "app/workbench/plot/plot_style.h"

namespace tactus::workbench {

class ValueMarker : public QCPLayerable {
  Q_OBJECT

 public:
  explicit ValueMarker(QCustomPlot& plot);

  void set(std::optional<double> value, std::vector<double> memberships);

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  std::optional<double> value_;
  std::vector<double> memberships_;
};

}  // namespace tactus::workbench
