// The names of terms above a plot or to its right, each with a thin line to its place, and on demand a bar over the
// part of the axis that belongs to the term. Only files of plots/ include this.
#pragma once

#include <vector>

#include "app/workbench/model/force_curves.h"
#include "app/workbench/plot/plot_style.h"

namespace tactus::workbench {

class TermLabels : public QCPLayerable {
  Q_OBJECT

 public:
  enum class Side {
    kAbove,  ///< for the x axis
    kRight,  ///< for the y axis, read downward
  };

  TermLabels(QCustomPlot& plot, int rows, Side side = Side::kAbove);

  /// The names of `terms` over the universe of `variable`.
  void setTerms(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms);
  /// At most that many rows of names.
  void setRows(int rows) { rows_ = rows; }
  /// Bars between the plot and the names, where no bands behind the plot show the terms.
  void setBars(bool bars) { bars_ = bars; }
  /// Room between the plot and this, px, for something else.
  void setDistance(double px) { distance_ = px; }

  /// Room beside the axis rectangle that the rows need, px, the distance not counted.
  int height() const;

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  struct Name {
    QString text;
    double center = 0;     ///< on the axis
    Interval half;         ///< where the membership is 0.5 or more
    std::size_t term = 0;  ///< its place in the order of the terms, which gives the color
  };

  const QCPAxis& axis() const;
  double barRoom() const;

  int rows_;
  Side side_;
  bool bars_ = false;
  double distance_ = 0;
  QFont font_;
  std::vector<Name> names_;
};

}  // namespace tactus::workbench
