#include "app/workbench/understand/map/surface_projection.h"

#include <algorithm>
#include <cmath>

namespace tactus::workbench {

SurfaceProjection::SurfaceProjection(const SurfaceAngles& angles, const QRectF& area, double zoom, QPointF shift)
    : SurfaceView(angles), middle_(area.center() + shift) {
  // The floor's diagonal is its greatest extent at any azimuth, so turning does not change the size.
  const double diagonal = std::hypot(kBox.x, kBox.y);
  const double sin_e = toViewer().z;
  const double height = kBox.z * up().z + diagonal * std::abs(sin_e);
  scale_ = zoom * std::max(1.0, std::min(area.width() / diagonal, area.height() / height));
}

QPointF SurfaceProjection::operator()(const BoxPoint& point) const {
  const figures::SeenPoint at = SurfaceView::operator()(point);
  return {middle_.x() + scale_ * at.x, middle_.y() - scale_ * at.y};
}

}  // namespace tactus::workbench
