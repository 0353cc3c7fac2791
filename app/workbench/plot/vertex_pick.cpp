#include "app/workbench/plot/vertex_pick.h"

#include <QMouseEvent>
#include <cmath>
#include <qcustomplot.h>

namespace tactus::workbench {
namespace {

constexpr double kReachPx = 10;

}  // namespace

VertexPick::VertexPick(QCustomPlot& plot, const QString& what) : QObject(&plot), plot_(plot), what_(what) {
  plot_.setMouseTracking(true);
  connect(&plot_, &QCustomPlot::mouseMove, this, &VertexPick::onMove);
  connect(&plot_, &QCustomPlot::mouseRelease, this, &VertexPick::onRelease);
}

QPointF VertexPick::pixelOf(const Vertex& vertex) const {
  return {plot_.xAxis->coordToPixel(vertex.x), plot_.yAxis->coordToPixel(vertex.membership)};
}

std::optional<std::size_t> VertexPick::at(const QPointF& place) const {
  std::optional<std::size_t> best;
  double nearest = kReachPx;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const QPointF away = pixelOf(vertices_[i]) - place;
    const double distance = std::hypot(away.x(), away.y());
    if (distance >= nearest) continue;
    nearest = distance;
    best = i;
  }
  return best;
}

void VertexPick::onMove(QMouseEvent* event) {
  const bool there = at(event->position()).has_value();
  plot_.setCursor(there ? Qt::PointingHandCursor : Qt::ArrowCursor);
  plot_.setToolTip(there ? what_ : QString());
}

void VertexPick::onRelease(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (const auto found = at(event->position())) emit picked(vertices_[*found].term, vertices_[*found].point);
}

}  // namespace tactus::workbench
