#include "app/workbench/understand/here/set_sketch.h"

#include <QPainter>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {

SetSketch::SetSketch(QPainter& painter, const QRectF& area, const fuzzy::Variable& variable)
    : painter_(painter), area_(area), min_(variable.min), max_(variable.max) {}

void SetSketch::ground() {
  painter_.setPen(QPen(theme::border(), 1));
  painter_.drawLine(area_.bottomLeft(), area_.bottomRight());
}

void SetSketch::term(const fuzzy::Term& term, const QColor& color) {
  const auto function = fuzzy::MembershipFunction::of(term);
  outline(polygon(analysis::impliedSet(function, 1, fuzzy::Implication::kScale, min_, max_)), QPen(color, 1.3));
}

void SetSketch::implied(const fuzzy::Term& term, double strength, fuzzy::Implication implication, const QColor& color) {
  if (strength <= 0) return;
  set(analysis::impliedSet(fuzzy::MembershipFunction::of(term), strength, implication, min_, max_), color);
}

void SetSketch::set(const analysis::Polyline& set, const QColor& color) {
  QPolygonF shape = polygon(set);
  if (shape.isEmpty()) return;
  QColor fill = color;
  fill.setAlphaF(0.45F);
  // The line covers the edge, which therefore needs no smoothing.
  const bool smooth = painter_.testRenderHint(QPainter::Antialiasing);
  painter_.setRenderHint(QPainter::Antialiasing, false);
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(fill);
  painter_.drawPolygon(shape);
  painter_.setRenderHint(QPainter::Antialiasing, smooth);
  shape << shape.front();
  outline(shape, QPen(color, 1));
}

// Line by line, which takes a tenth of the time of one outline around all of it.
void SetSketch::outline(const QPolygonF& line, const QPen& pen) {
  painter_.setPen(pen);
  for (qsizetype i = 0; i + 1 < line.size(); ++i) painter_.drawLine(line[i], line[i + 1]);
}

void SetSketch::mark(double x, const QColor& color) {
  painter_.setPen(QPen(color, 1.4));
  painter_.drawLine(at(x, 0), at(x, 1.1));
}

void SetSketch::level(double height, double from_x, const QColor& color) {
  painter_.setPen(QPen(color, 1, Qt::DotLine));
  painter_.drawLine(at(from_x, height), QPointF(area_.right(), at(from_x, height).y()));
}

QPointF SetSketch::at(double x, double height) const {
  return {area_.left() + (x - min_) / (max_ - min_) * area_.width(), area_.bottom() - height / 1.1 * area_.height()};
}

QPolygonF SetSketch::polygon(const analysis::Polyline& set) const {
  QPolygonF points;
  if (set.empty()) return points;
  points << at(set.front().x, 0);
  for (const analysis::Vertex& vertex : set) points << at(vertex.x, vertex.height);
  points << at(set.back().x, 0);
  return points;
}

}  // namespace tactus::workbench
