// How the box of a surface is seen: turned by an angle, looked down on by another, without perspective, so that equal
// forces stay equally long wherever they stand.
#pragma once

#include <QPointF>
#include <QRectF>

namespace tactus::workbench {

/// A place in the box: each coordinate is a share in [0, 1] of its universe; z is the force.
struct BoxPoint {
  double x = 0;
  double y = 0;
  double z = 0;
};

/// A direction in the box, measured in its edges: all edges have the unit of length that kBox gives.
struct BoxVector {
  double x = 0;
  double y = 0;
  double z = 0;
};

inline double dot(const BoxVector& a, const BoxVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Lengths of the edges of the box relative to each other: the long one for the depth, whose profile is the finest.
inline constexpr BoxVector kBox = {1.85, 1.1, 0.8};

struct SurfaceAngles {
  /// Where the viewer stands, degrees: 0 at the low end of y, so that x goes to the right; 90 at the high end of x.
  double azimuth_deg = 32;
  /// How high the viewer stands, degrees from -90 to 90: 0 looks along the floor, 90 straight down.
  double elevation_deg = 30;

  friend bool operator==(const SurfaceAngles&, const SurfaceAngles&) = default;
};

class SurfaceProjection {
 public:
  /// The whole box in `area` (px) at every azimuth, `zoom` times as large and shifted by `shift` px.
  SurfaceProjection(const SurfaceAngles& angles, const QRectF& area, double zoom = 1, QPointF shift = {});

  /// Where a place of the box stands on the screen, px.
  QPointF operator()(const BoxPoint& point) const;
  /// How far a place stands toward the viewer, in lengths of the box, 0 at its middle.
  double nearness(const BoxPoint& point) const;

  /// The unit vector toward the viewer; those to the right and up on the screen.
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
