// How a surface z(x, y) is seen: a box without perspective, so that equal forces have equal lengths everywhere, and the
// light on its cells. The report and the workbench draw with it.
#pragma once

namespace tactus::figures {

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

/// A place in the picture, in lengths of the box from its center: x to the right, y up.
struct SeenPoint {
  double x = 0;
  double y = 0;
};

/// Orthographic.
class SurfaceView {
 public:
  explicit SurfaceView(const SurfaceAngles& angles = {});

  SeenPoint operator()(const BoxPoint& point) const;
  /// How near a point is to the viewer, in lengths of the box; 0 at the center of the box.
  double nearness(const BoxPoint& point) const;
  /// Width and height of the picture of the whole box; it is centered.
  SeenPoint extent() const;

  /// The unit vectors toward the viewer, and to the right and up in the picture.
  const BoxVector& toViewer() const { return to_viewer_; }
  const BoxVector& right() const { return right_; }
  const BoxVector& up() const { return up_; }

 private:
  BoxVector to_viewer_;
  BoxVector right_;
  BoxVector up_;
};

/// The upward unit normal vector of a surface that rises by `rise_x` and `rise_y` per length of the box.
BoxVector normalOf(double rise_x, double rise_y);

/// The brightness of a cell: 1 for its plain color, less if it faces away from a light at the upper left behind the
/// viewer. Both sides are lit.
double brightness(const BoxVector& normal, const SurfaceView& seen);

}  // namespace tactus::figures
