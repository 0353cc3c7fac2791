#include "app/workbench/understand/map/surface_projection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactus::workbench {
namespace {

BoxVector fromMiddle(const BoxPoint& point) {
  return {(point.x - 0.5) * kBox.x, (point.y - 0.5) * kBox.y, (point.z - 0.5) * kBox.z};
}

}  // namespace

SurfaceProjection::SurfaceProjection(const SurfaceAngles& angles, const QRectF& area, double zoom, QPointF shift)
    : middle_(area.center() + shift) {
  const double azimuth = angles.azimuth_deg * std::numbers::pi / 180;
  const double elevation = angles.elevation_deg * std::numbers::pi / 180;
  const double sin_a = std::sin(azimuth);
  const double cos_a = std::cos(azimuth);
  const double sin_e = std::sin(elevation);
  const double cos_e = std::cos(elevation);
  to_viewer_ = {cos_e * sin_a, -cos_e * cos_a, sin_e};
  right_ = {cos_a, sin_a, 0};
  up_ = {-sin_e * sin_a, sin_e * cos_a, cos_e};
  // The floor's diagonal is its greatest extent at any azimuth, so turning does not change the size.
  const double diagonal = std::hypot(kBox.x, kBox.y);
  const double height = kBox.z * std::abs(cos_e) + diagonal * std::abs(sin_e);
  scale_ = zoom * std::max(1.0, std::min(area.width() / diagonal, area.height() / height));
}

QPointF SurfaceProjection::operator()(const BoxPoint& point) const {
  const BoxVector at = fromMiddle(point);
  return {middle_.x() + scale_ * dot(at, right_), middle_.y() - scale_ * dot(at, up_)};
}

double SurfaceProjection::nearness(const BoxPoint& point) const { return dot(fromMiddle(point), to_viewer_); }

}  // namespace tactus::workbench
