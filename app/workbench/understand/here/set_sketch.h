// Small pictures of fuzzy sets without axes: one term, filled to a height, or any set.
#pragma once

#include <QColor>
#include <QPen>
#include <QPolygonF>
#include <QRectF>
#include <optional>

#include "core/analysis/polyline.h"
#include "core/fuzzy/force_model.h"

class QPainter;

namespace tactus::workbench {

/// Paints into one rectangle over the universe of a variable, heights 0 to 1.
class SetSketch {
 public:
  SetSketch(QPainter& painter, const QRectF& area, const fuzzy::Variable& variable);

  /// The line at height 0.
  void ground();
  /// The outline of `term`.
  void term(const fuzzy::Term& term, const QColor& color);
  /// The filled set of `term`, cut or scaled at `strength`.
  void implied(const fuzzy::Term& term, double strength, fuzzy::Implication implication, const QColor& color);
  /// `set`, filled.
  void set(const analysis::Polyline& set, const QColor& color);
  /// A vertical line at `x`.
  void mark(double x, const QColor& color);
  /// A dashed horizontal line at `height` from `from_x` to the right edge.
  void level(double height, double from_x, const QColor& color);

 private:
  QPointF at(double x, double height) const;
  void outline(const QPolygonF& line, const QPen& pen);
  QPolygonF polygon(const analysis::Polyline& set) const;

  QPainter& painter_;
  QRectF area_;
  double min_;
  double max_;
};

}  // namespace tactus::workbench
