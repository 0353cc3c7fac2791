// The view of a surface's box: azimuth and elevation without perspective, so that equal forces have equal lengths
// everywhere.
#pragma once

#include <QPointF>
#include <QRectF>

namespace tactus::workbench {

/// A point in the box. Each coordinate is a share in [0, 1] of its universe; z is the force.
struct BoxPoint {
  double x = 0;
  double y = 0;
  double z = 0;
};

/// A direction in the box, in the length units of kBox.
struct BoxVector {
  double x = 0;
  double y = 0;
  double z = 0;
};

inline double dot(const BoxVector& a, const BoxVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Relative lengths of the box's edges. The depth has the longest edge, because its profile has the finest details.
inline constexpr BoxVector kBox = {1.85, 1.1, 0.8};

struct SurfaceAngles {
  /// Direction of the viewer, degrees: 0 is the low end of y, with x to the right; 90 is the high end of x.
  double azimuth_deg = 32;
  /// Height of the viewer, degrees from -90 to 90: 0 looks along the floor, 90 straight down.
  double elevation_deg = 30;

  friend bool operator==(const SurfaceAngles&, const SurfaceAngles&) = default;
};

class SurfaceProjection {
 public:
  /// Fits the box into `area` (px) at every azimuth, then scales it by `zoom` and shifts it by `shift` px.
  SurfaceProjection(const SurfaceAngles& angles, const QRectF& area, double zoom = 1, QPointF shift = {});

  /// The position of a box point on the screen, px.
  QPointF operator()(const BoxPoint& point) const;
  /// How near a point is to the viewer, in lengths of the box; 0 at the center of the box.
  double nearness(const BoxPoint& point) const;

  /// The unit vectors toward the viewer, and to the right and up on the screen.
  const BoxVector& toViewer() const { return to_viewer_; }
  const BoxVector& right() const { return right_; }
  const BoxVector& up() const { return up_; }

 private:
  BoxVector to_viewer_;
  BoxVector right_;
  BoxVector up_;
  QPointF middle_;
  double scale_ = 1;
};

}  // namespace tactus::workbench
