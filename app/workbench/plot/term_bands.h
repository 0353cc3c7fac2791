// The terms of the x axis as faint bands behind the curves. A band is as strong as its membership. Needs QCustomPlot:
// only plotting code includes this.
#pragma once

#include <vector>

#include "app/workbench/plot/plot_style.h"
#include "core/fuzzy/membership.h"

namespace tactus::workbench {

class TermBands : public QCPLayerable {
  Q_OBJECT

 public:
  explicit TermBands(QCustomPlot& plot);

  void setTerms(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms);

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  QColor colorAt(double place) const;
  void paint(QPainter& painter, const QRectF& room) const;

  double min_ = 0;
  double max_ = 1;
  std::vector<fuzzy::MembershipFunction> terms_;
  std::vector<QColor> colors_;
  std::vector<double> places_;  ///< the color changes linearly between these
};

}  // namespace tactus::workbench
