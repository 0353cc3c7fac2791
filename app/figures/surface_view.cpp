#include "app/figures/surface_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactus::figures {
namespace {

constexpr double kDarkest = 0.58;
constexpr double kLit = 0.46;  // on top of that where the light falls straight on a cell
// The light as the viewer sees it: to the left, above, behind.
constexpr double kLightRight = -0.42;
constexpr double kLightUp = 0.62;
constexpr double kLightToViewer = 0.663;

BoxVector fromMiddle(const BoxPoint& point) {
  return {(point.x - 0.5) * kBox.x, (point.y - 0.5) * kBox.y, (point.z - 0.5) * kBox.z};
}

/// Length of the box's shadow along `direction`.
double shadow(const BoxVector& direction) {
  return std::abs(direction.x) * kBox.x + std::abs(direction.y) * kBox.y + std::abs(direction.z) * kBox.z;
}

}  // namespace

SurfaceView::SurfaceView(const SurfaceAngles& angles) {
  const double azimuth = angles.azimuth_deg * std::numbers::pi / 180;
  const double elevation = angles.elevation_deg * std::numbers::pi / 180;
  const double sin_a = std::sin(azimuth);
  const double cos_a = std::cos(azimuth);
  const double sin_e = std::sin(elevation);
  const double cos_e = std::cos(elevation);
  to_viewer_ = {cos_e * sin_a, -cos_e * cos_a, sin_e};
  right_ = {cos_a, sin_a, 0};
  up_ = {-sin_e * sin_a, sin_e * cos_a, cos_e};
}

SeenPoint SurfaceView::operator()(const BoxPoint& point) const {
  const BoxVector at = fromMiddle(point);
  return {dot(at, right_), dot(at, up_)};
}

double SurfaceView::nearness(const BoxPoint& point) const { return dot(fromMiddle(point), to_viewer_); }

SeenPoint SurfaceView::extent() const { return {shadow(right_), shadow(up_)}; }

BoxVector normalOf(double rise_x, double rise_y) {
  const double length = std::hypot(rise_x, rise_y, 1);
  return {-rise_x / length, -rise_y / length, 1 / length};
}

double brightness(const BoxVector& normal, const SurfaceView& seen) {
  double light = kLightRight * dot(normal, seen.right()) + kLightUp * dot(normal, seen.up()) +
                 kLightToViewer * dot(normal, seen.toViewer());
  // The side that is seen is the side that is lit.
  if (dot(normal, seen.toViewer()) < 0) light = -light;
  return kDarkest + kLit * std::max(0.0, light);
}

}  // namespace tactus::figures
