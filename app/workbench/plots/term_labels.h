// The names of terms above a plot, each with a thin line to its place. Only files of plots/ include this.
#pragma once

#include <vector>

#include "app/workbench/plots/plot_style.h"

namespace tactus::workbench {

class TermLabels : public QCPLayerable {
  Q_OBJECT

 public:
  TermLabels(QCustomPlot& plot, int rows);

  /// The names of `terms` over the universe of `variable`.
  void setTerms(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms);

  /// Room above the axis rectangle that the rows need, px.
  int height() const;

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  struct Name {
    QString text;
    double center = 0;     ///< on the x axis
    std::size_t term = 0;  ///< its place in the order of the terms, which gives the color
  };

  int rows_;
  QFont font_;
  std::vector<Name> names_;
};

}  // namespace tactus::workbench
