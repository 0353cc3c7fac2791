#include "app/workbench/plot/value_marker.h"

#include <utility>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {

// The overlay has a buffer of its own, so the marker moves without drawing the shapes again.
ValueMarker::ValueMarker(QCustomPlot& plot) : QCPLayerable(&plot, QStringLiteral("overlay")) {}

void ValueMarker::set(std::optional<double> value, std::vector<double> memberships) {
  value_ = value;
  memberships_ = std::move(memberships);
}

void ValueMarker::applyDefaultAntialiasingHint(QCPPainter* painter) const { painter->setAntialiasing(true); }

void ValueMarker::draw(QCPPainter* painter) {
  if (!value_) return;
  const QCPAxisRect* area = mParentPlot->axisRect();
  if (!area->axis(QCPAxis::atBottom)->range().contains(*value_)) return;
  const double x = area->axis(QCPAxis::atBottom)->coordToPixel(*value_);
  painter->setPen(QPen(theme::accent(), 1.4));
  painter->drawLine(QLineF(x, area->top(), x, area->bottom()));
  painter->setPen(QPen(theme::card(), 1.2));
  painter->setBrush(theme::accent());
  for (const double membership : memberships_) {
    painter->drawEllipse(QPointF(x, area->axis(QCPAxis::atLeft)->coordToPixel(membership)), 4, 4);
  }
}

}  // namespace tactus::workbench
