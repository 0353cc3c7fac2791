// What a plot shows of terms: their colors, lines, names and bands. Needs QCustomPlot: only plotting code includes
// this.
#pragma once

#include <QColor>
#include <cstddef>
#include <vector>

#include "app/figures/force_curves.h"
#include "app/workbench/base/plot_table.h"
#include "app/workbench/plot/chart.h"
#include "app/workbench/plot/plot_style.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::workbench {

// The colors of terms on the current look (app/figures/colors.h says what they mean).

// Mixes two colors, as figures::mixed does for the report.

/// `share` in [0, 1] of `to`, the rest of `from`. Both are opaque.
QColor mixedColor(const QColor& from, const QColor& to, double share);

/// The contrast of WCAG 2.1 between opaque colors: 1 to 21.
double contrastOf(const QColor& one, const QColor& other);

/// Of bars, chips and areas.
QColor termFill(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, std::size_t index);
/// Of lines and handles: contrast 3 to a card.
QColor termLine(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, std::size_t index);
/// Of small text: contrast 4.5 to a card.
QColor termText(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, std::size_t index);

// The line of a membership function over the universe of its variable, as plots draw it.

struct TermOutline {
  QVector<double> x;
  QVector<double> membership;
};

/// The corners of the shape between `low` and `high`. A vertical edge has two points at one place.
TermOutline outlineOf(const fuzzy::Term& term, double low, double high);

/// Draws the terms of `before` that are others in `now`, dashed, in the colors of `variable`; between `low` and `high`.
/// `fast`: while something is dragged. Returns whether there were any.
bool addGhosts(QCustomPlot& plot, const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& now,
               const std::vector<fuzzy::Term>& before, double low, double high, bool fast = false);
bool addGhosts(Chart& chart, const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& now,
               const std::vector<fuzzy::Term>& before, double low, double high);

/// Fills the columns `term`, the variable, and `membership`: a row for every corner of every term, also beyond the
/// universe. A Gaussian is sampled over the universe.
void fillTable(PlotTable& table, const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms);

/// The names of terms above a plot or to its right, each with a thin line to its place. On request each has a bar over
/// the term's part of the axis.
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

// The terms of the x axis as faint bands behind the curves. A band is as strong as its membership.

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
