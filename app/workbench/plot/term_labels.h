// The names of terms above a plot or to its right, each with a thin line to its place. On request each has a bar over
// the term's part of the axis. Needs QCustomPlot: only plotting code includes this.
#pragma once

#include <vector>

#include "app/figures/force_curves.h"
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
  /// At most `rows` rows of names.
  void setRows(int rows) { rows_ = rows; }
  /// Shows bars between the plot and the names. For plots without bands behind the curves.
  void setBars(bool bars) { bars_ = bars; }
  /// Free space between the plot and the labels, px.
  void setDistance(double px) { distance_ = px; }

  /// Size beside the axis rectangle that the rows need, px, without the distance.
  int height() const;

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

 private:
  struct Name {
    QString text;
    double center = 0;       ///< on the axis
    figures::Interval half;  ///< where the membership is 0.5 or more
    QColor color;            ///< of the term
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
